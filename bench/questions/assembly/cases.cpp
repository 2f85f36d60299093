// From poses to a sparse matrix: ns a joint, by the way it is done.
#include "bench/questions/assembly/lattice.hpp"
#include "reference/record/effort.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <new>
#include <optional>
#include <tuple>
#include <utility>

namespace halfway::bench {

Cases assembly_cases();

namespace {

using assemble::Form, assemble::Layout, assemble::Part, assemble::Pattern;

/// Two joints a node: 8 064 joints of 5.8 MB, 99 904 of 72 MB.
struct Size {
  int width, height;
  int joints() const { return 2 * width * height; }
};
constexpr Size kInCache{64, 63}, kFromMemory{224, 223};

struct Problem {
  std::string formulation, implementation, variant;
  Kind kind;
  Size size;
  int threads = 1;
  Form form{};
  Way way;
};

/// On cache lines: what blocks lie on should not be the allocator's choice.
class Numbers {
 public:
  explicit Numbers(long count) : first_(new (kLine) double[count]()), count_(std::size_t(count)) {}
  ~Numbers() { ::operator delete[](first_, kLine); }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  operator std::span<double>() { return {first_, count_}; }

 private:
  static constexpr std::align_val_t kLine{64};
  double* first_;
  std::size_t count_;
};

/// Nodes and where their joints go: made once for all ways.
struct Ground {
  Lattice lattice;
  Pattern pattern;
};
std::shared_ptr<const Ground> ground(Kind kind, const Size& size, Form form) {
  static std::map<std::tuple<Kind, int, int, Layout, Part>, std::shared_ptr<const Ground>> known;
  auto& made = known[{kind, size.width, size.height, form.layout, form.part}];
  if (made) return made;
  form.unknowns = kind == Kind::angular ? 3 : 6;
  Lattice joints = lattice(kind, size.width, size.height);
  Pattern pattern(form, joints.rows, joints.joints);
  return made = std::make_shared<const Ground>(Ground{std::move(joints), std::move(pattern)});
}

/// A matrix, and one way to fill it.
class Work {
 public:
  Work(const Problem& p, const Size& size)
      : ground_(ground(p.kind, size, p.form)),
        residual(pattern().unknown_count()),
        values(pattern().value_count()),
        assemble_(p.way(ground_->lattice, pattern())) {}
  void run() { assemble_(residual, values); }
  const Pattern& pattern() const { return ground_->pattern; }

 private:
  std::shared_ptr<const Ground> ground_;

 public:
  Numbers residual, values;

 private:
  Assemble assemble_;
};

/// Small, but with whole packs, a rest, and nodes that four joints share.
Size checked_size() { return reference::is_quick() ? Size{3, 3} : Size{5, 3}; }

const ExactAssembly& truth(const std::string& formulation, Kind kind) {
  static std::map<std::pair<std::string, Kind>, ExactAssembly> known;
  const Size size = checked_size();
  const auto it = known.find({formulation, kind});
  if (it != known.end()) return it->second;
  return known
      .emplace(std::pair(formulation, kind),
               exact_assembly(formulation, lattice(kind, size.width, size.height)))
      .first->second;
}

/// Entry (row, column) of the truth as the form has it.
reference::Real50 entry(const ExactAssembly& exact, const Form& form, long row, long column) {
  if (form.layout == Layout::columns) std::swap(row, column);
  if (form.part == Part::whole) return exact.tangent(row, column);
  return (exact.tangent(row, column) + exact.tangent(column, row)) / 2;
}

/// A few hundred roundings of the largest entry, as the single joints of every case.
constexpr double kTolerance = 512 * std::numeric_limits<double>::epsilon();

Checked check(const Problem& p) {
  Work work(p, checked_size());
  work.run();
  const ExactAssembly& exact = truth(p.formulation, p.kind);
  const Pattern& pattern = work.pattern();
  const Form& form = pattern.form();
  const int n = form.layout == Layout::blocks ? form.unknowns : 1;
  const double of_loads = largest_entry(exact.loads), of_tangent = largest_entry(exact.tangent);
  reference::Measurement worst;
  const std::span<const double> residual = std::span<double>(work.residual),
                                values = std::span<double>(work.values);
  for (std::size_t i = 0; i < residual.size(); ++i)
    worst.include(std::abs(double(residual[i] - exact.loads[long(i)])) / of_loads, {});
  for (std::size_t row = 0; row + 1 < pattern.start().size(); ++row) {
    for (int k = pattern.start()[row]; k < pattern.start()[row + 1]; ++k) {
      for (int e = 0; e < n * n; ++e) {
        const auto right = entry(exact, form, n * long(row) + e / n, n * pattern.index()[k] + e % n);
        worst.include(std::abs(double(values[long(n) * n * k + e] - right)) / of_tangent, {});
      }
    }
  }
  Checked out;
  out.error = worst.value();
  if (!(out.error <= kTolerance)) out.message = fmt::format("matrix or residual is off by {:.1e}", out.error);
  return out;
}

Case assembly_case(const Problem& p) {
  Case c;
  c.formulation = p.formulation;
  c.kind = to_string(p.kind);
  c.what = "assembly";
  c.implementation = p.implementation;
  c.variant = p.variant;
  c.joints = p.size.joints(), c.threads = p.threads;
  if (p.implementation == "batch" || p.implementation == "assemble")
    c.isa = batch::to_string(batch::choose({}));
  c.name = fmt::format("{}/{}/assembly/{}{}/{}{}", c.formulation, c.kind, c.implementation,
                       c.variant.empty() ? "" : "/" + c.variant, c.joints,
                       c.threads > 1 ? fmt::format("/threads_{}", c.threads) : "");
  c.evaluations = c.joints;
  c.wall_time = c.threads > 1;
  c.check = [p] { return check(p); };
  c.timed = [p](benchmark::State& state) {
    Work work(p, p.size);
    for (auto _ : state) work.run();
  };
  c.evaluate = [p, work = std::make_shared<std::optional<Work>>()](int iterations) {
    if (!*work) work->emplace(p, p.size);
    for (int i = 0; i < iterations; ++i) (*work)->run();
  };
  return c;
}

}  // namespace

Cases assembly_cases() {
  Cases cases;
  const auto add = [&](const Problem& p) { cases.push_back(assembly_case(p)); };
  for (const Size size : {kInCache, kFromMemory}) {
    for (const Kind kind : {Kind::angular, Kind::linear, Kind::linear_angular}) {
      add({"invariant", "textbook", "", kind, size, 1, {}, textbook_way(kind)});
      add({"mbdyn_joint_inv", "reference", "", kind, size, 1, {}, mbdyn_like_way(kind)});
      add({"invariant", "kernel", "", kind, size, 1, {}, kernel_way(kind)});
      add({"invariant", "batch", "", kind, size, 1, {}, batch_way()});
      add({"invariant", "assemble", "", kind, size, 1, {}, assemble_way("invariant", 1)});
    }
    const Kind full = Kind::linear_angular;
    add({"fasse", "assemble", "", full, size, 1, {}, assemble_way("fasse", 1)});
    add({"fasse", "assemble", "upper", full, size, 1, {.part = Part::upper}, assemble_way("fasse", 1)});
    add({"invariant",
         "assemble",
         "eigen",
         full,
         size,
         1,
         {.layout = Layout::columns},
         assemble_way("invariant", 1)});
  }
  for (const int threads : {1, 2}) {
    Problem p{"invariant", "assemble", "wall", Kind::linear_angular,
              kFromMemory, threads,    {},     assemble_way("invariant", threads)};
    cases.push_back(assembly_case(p));
    cases.back().wall_time = true;
  }
  return cases;
}

}  // namespace halfway::bench
