#include "reports/history/store/digest.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cmath>

namespace halfway::history {
namespace {

std::uint64_t bits(double x) { return std::isnan(x) ? ~std::uint64_t(0) : std::bit_cast<std::uint64_t>(x); }

}  // namespace

void Digest::bytes(const void* data, std::size_t size) {
  crc_ = std::uint32_t(::crc32_z(crc_, static_cast<const Bytef*>(data), size));
}

void Digest::text(std::string_view key, std::string_view value) {
  if (value.empty()) return;
  bytes(key.data(), key.size() + 1);  // keys are literals: with the zero at their end
  bytes(value.data(), value.size());
  bytes("", 1);
}

template <class... Words>
void Digest::words(Words... words) {
  const std::uint64_t all[] = {std::uint64_t(words)...};
  bytes(all, sizeof all);
}

void Digest::run(const Run& run, const Series& series) {
  text("commit", run.commit), text("date", run.date), text("title", run.title), text("release", run.release);
  text("dirty", run.dirty ? "1" : ""), text("libraries", run.libraries);
  text("load", std::isnan(run.load) ? "" : fmt::format("{}", run.load));
  text("cpu", series.machine.cpu), text("cores", fmt::format("{}", series.machine.cores));
  text("caches", series.machine.caches), text("microcode", series.machine.microcode);
  text("compiler", series.compiler), text("flags", series.flags);
  text("build_type", series.build_type), text("isa", series.isa);
}

void Digest::time(std::uint32_t figure, const Time& t) { words(1, figure, t.median, t.low, t.high, t.n); }

void Digest::change(std::uint32_t figure, const Reading& r) {
  words(2, figure, bits(r.value), int(r.comparison), bits(r.expected), bits(r.low), bits(r.high),
        int(r.verdict));
}

void Digest::repetitions(std::uint32_t figure, const Repetitions& all) {
  words(3, figure, all.size());
  bytes(all.data(), all.size() * sizeof all[0]);
}

std::uint32_t digest_of(const Figure& f) {
  const std::string text = fmt::format("{}\x1f{}\x1f{}\x1f{}\x1f{}", f.name, f.unit, to_string(f.kind),
                                       to_string(f.better), f.formulation);
  return std::uint32_t(::crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
}

}  // namespace halfway::history
