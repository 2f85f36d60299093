#include "halfway/batch/run.hpp"

#include "halfway/batch/entries.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace halfway::batch::detail {
namespace {

/// Streaming stores pay for results larger than this (bytes; measured: from 5 MB on with 1 MB of L2, by
/// 1.3, and by 2.8 from 20 MB on), where a store is a whole cache line: with 16 or 32 bytes on as many
/// rows as a tangent has they take 3 to 4 times as long.
constexpr long kKeptInCache = 8L << 20;
constexpr int kCacheLine = 64;

constexpr int kMaxLanes = 16;
constexpr int kMaxLawRows = 21;
constexpr int kMaxBlockRows = 9 + 81;

struct Range {
  long begin = 0, end = 0;
};

/// Numbers of shared laws, one pack of copies each.
template <class T>
struct LawCopies {
  alignas(64) T numbers[kMaxLawRows * kMaxLanes];

  explicit LawCopies(const Work<T>& w) {
    const Columns<const T>& law = w.joints.law;
    for (int row = 0; row < law_rows(w.model.kind, w.model.law); ++row) {
      std::fill_n(numbers + row * w.lanes, w.lanes, law.first[row * law.stride]);
    }
  }
};

template <class T>
Columns<T> moved(const Columns<T>& c, long by) {
  return {c.first == nullptr ? nullptr : c.first + by, c.stride};
}

template <class T>
Place<T> moved(const Place<T>& p, long by) {
  return {p.first == nullptr ? nullptr : p.at(by), p.stride, p.rows, p.block};
}
template <class T>
Place<T> table(const Columns<T>& c) {
  return {c.first, c.stride};
}

/// All joints.
template <class T>
Job<T> job_of(const Work<T>& w, const LawCopies<T>* shared) {
  static constexpr BatchEnd<T> kAtTheNode{};
  const Joints<T>& j = w.joints;
  const bool ends = j.a != nullptr && j.b != nullptr;
  Job<T> job{.count = j.count, .q_a = j.q_a, .q_b = j.q_b, .x_a = j.x_a, .x_b = j.x_b, .law = j.law};
  job.direction = j.direction;
  job.law_step = shared != nullptr ? 0 : 1;
  if (shared != nullptr) job.law = {shared->numbers, w.lanes};
  job.polynomial = w.model.law == LawForm::polynomial;
  job.a = ends ? j.a : &kAtTheNode, job.b = ends ? j.b : &kAtTheNode;
  job.parameters = parameters(w.model);
  job.loads = table(w.results.loads);
  job.tangent = w.output == Output::compressed ? blocks(w.results.tangent.first, w.tangent_rows)
                                               : table(w.results.tangent);
  return job;
}

/// The part [begin, begin + count) of a job.
template <class T>
Job<T> part_of(const Job<T>& whole, long begin, long count) {
  Job<T> job = whole;
  job.count = count;
  for (Columns<const T>* c : {&job.q_a, &job.q_b, &job.x_a, &job.x_b, &job.direction}) *c = moved(*c, begin);
  if (job.law_step != 0) job.law = moved(job.law, begin);
  job.loads = moved(job.loads, begin), job.tangent = moved(job.tangent, begin);
  return job;
}

/// Whole packs, their results by way of blocks that stay in the nearest cache.
template <class T>
void run_in_blocks(const Work<T>& w, const Job<T>& job, Spread<T> spread) {
  constexpr long kPacks = 4;
  alignas(64) T numbers[kPacks * (64 / sizeof(T)) * kMaxBlockRows];
  const Kind kind = w.model.kind;
  Block<T> block{numbers, 0, load_rows(kind), w.kept_rows, {}, {}};
  for (long i = 0; i < job.count; i += kPacks * w.lanes) {
    Job<T> part = part_of(job, i, std::min(kPacks * w.lanes, job.count - i));
    block.packs = part.count / w.lanes;
    block.loads = part.loads, block.tangent = part.tangent;
    const int rows = block.load_rows + block.tangent_rows;
    part.loads = {numbers, w.lanes, rows, w.lanes};
    part.tangent = {numbers + block.load_rows * w.lanes, w.lanes, rows, w.lanes};
    w.function(part);
    spread(block);
  }
}

template <class T>
void run_packs(const Work<T>& w, const Job<T>& job, bool past_caches) {
  if (const Spread<T> spread = past_caches ? w.streamed : w.spread)
    run_in_blocks(w, job, spread);
  else
    w.function(job);
}

/// The last joints, fewer than a pack: through tables of one pack, filled up with copies of the last one.
template <class T>
class Tail {
 public:
  Tail(const Work<T>& w, const Job<T>& job) : work_(w), job_(job) {}

  void run() {
    const Kind kind = work_.model.kind;
    Job<T> pack = job_;
    pack.count = work_.lanes;
    pack.q_a = read(job_.q_a, 4), pack.q_b = read(job_.q_b, 4);
    if (kind != Kind::angular) pack.x_a = read(job_.x_a, 3), pack.x_b = read(job_.x_b, 3);
    if (work_.output == Output::product) pack.direction = read(job_.direction, direction_rows(kind));
    if (job_.law_step != 0) pack.law = read(job_.law, law_rows(kind, work_.model.law));
    pack.loads = table(place(load_rows(kind))), pack.tangent = table(place(work_.tangent_rows));
    run_packs(work_, pack, false);
    write(pack.loads, job_.loads, load_rows(kind));
    write(pack.tangent, job_.tangent, work_.tangent_rows);
  }

 private:
  Columns<T> place(int rows) {
    const Columns<T> c{numbers_ + used_, work_.lanes};
    used_ += rows * work_.lanes;
    return c;
  }
  Columns<const T> read(const Columns<const T>& from, int rows) {
    const Columns<T> to = place(rows);
    for (int row = 0; row < rows; ++row) {
      for (long i = 0; i < work_.lanes; ++i) {
        to.first[row * to.stride + i] = from.first[row * from.stride + std::min(i, job_.count - 1)];
      }
    }
    return {to.first, to.stride};
  }
  void write(const Place<T>& from, const Place<T>& to, int rows) const {
    for (int row = 0; row < rows; ++row) {
      std::copy_n(from.first + row * from.stride, job_.count, to.first + row * to.stride);
    }
  }

  static constexpr int kMaxRows = 4 + 4 + 3 + 3 + 12 + kMaxLawRows + 9 + 144;
  const Work<T>& work_;
  const Job<T>& job_;
  int used_ = 0;
  alignas(64) T numbers_[kMaxRows * kMaxLanes];
};

void end_of_streaming() {
#ifdef __x86_64__
  __builtin_ia32_sfence();  // what was streamed is seen before the results are said to be ready
#endif
}

template <class T>
void run_range(const Work<T>& w, Range r, const Job<T>& all, bool past_caches) {
  const long whole = (r.end - r.begin) / w.lanes * w.lanes;
  if (whole > 0) {
    run_packs(w, part_of(all, r.begin, whole), past_caches);
    if (past_caches) end_of_streaming();
  }
  if (r.begin + whole < r.end) {
    const Job<T> rest = part_of(all, r.begin + whole, r.end - r.begin - whole);
    Tail<T>(w, rest).run();
  }
}

bool on_boundary(const void* p, long stride_bytes) {
  return reinterpret_cast<std::uintptr_t>(p) % 64 == 0 && stride_bytes % 64 == 0;
}

template <class T>
bool past_caches(const Work<T>& w, Streaming streaming) {
  const auto& [loads, tangent] = w.results;
  if (streaming == Streaming::never || w.streamed == w.spread) return false;
  constexpr long kSize = sizeof(T);
  if (!on_boundary(loads.first, loads.stride * kSize) ||
      !on_boundary(tangent.first, tangent.stride * kSize)) {
    return false;
  }
  if (streaming == Streaming::always) return true;
  if (w.lanes * kSize != kCacheLine) return false;
  const int rows = load_rows(w.model.kind) + w.tangent_rows;
  return rows * kSize * w.joints.count > kKeptInCache;
}

/// Equal shares; all but the last end on a boundary of 64 joints, whatever the pack: no two threads write
/// to one line.
std::vector<Range> shares(long count, int threads) {
  constexpr long kBlock = 64;
  const long blocks = (count + kBlock - 1) / kBlock;
  std::vector<Range> out;
  for (int k = 0; k < threads; ++k) {
    const Range r{std::min(count, blocks * k / threads * kBlock),
                  std::min(count, blocks * (k + 1) / threads * kBlock)};
    if (r.begin < r.end) out.push_back(r);
  }
  return out;
}

}  // namespace

template <class T>
void run(const Work<T>& work, const Options& options) {
  std::optional<LawCopies<T>> copies;
  if (!work.joints.law_per_joint) copies.emplace(work);
  const Job<T> all = job_of(work, copies ? &*copies : nullptr);
  const bool streamed = past_caches(work, options.streaming);
  if (options.threads <= 1) return run_range(work, {0, all.count}, all, streamed);
  const std::vector<Range> parts = shares(all.count, options.threads);
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    others.emplace_back([&, k] { run_range(work, parts[k], all, streamed); });
  }
  if (!parts.empty()) run_range(work, parts[0], all, streamed);
}

template void run(const Work<double>&, const Options&);
template void run(const Work<float>&, const Options&);

}  // namespace halfway::batch::detail
