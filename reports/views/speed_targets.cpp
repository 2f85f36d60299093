// The targets of speed: each a ratio of medians within one run.
#include "reports/views/speed.hpp"

#include "bench/peak/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reports {
namespace {

using bench::Timing;

const double kMissing = std::nan("");

/// What tells a timing from others of its formulation, kind and output.
struct Pick {
  std::string formulation, kind, what, implementation;
  std::string variant{}, isa{}, precision = "double";
  int joints = 0;   ///< 0: any
  int threads = 0;  ///< 0: one or none
};

const Timing* find(const std::vector<Timing>& timings, const Pick& p) {
  const auto it = std::ranges::find_if(timings, [&](const Timing& t) {
    return !t.wrong && t.formulation == p.formulation && t.kind == p.kind && t.what == p.what &&
           t.implementation == p.implementation && t.variant == p.variant && t.isa == p.isa &&
           t.precision == p.precision && t.method.empty() && (p.joints == 0 || t.joints == p.joints) &&
           std::max(t.threads, 1) == std::max(p.threads, 1);
  });
  return it == timings.end() ? nullptr : &*it;
}

double ratio(const std::vector<Timing>& timings, const Pick& over, const Pick& under) {
  const Timing *a = find(timings, over), *b = find(timings, under);
  return a && b ? a->ns / b->ns : kMissing;
}

class Table {
 public:
  explicit Table(const bench::Run& run) : timings_(run.timings), peaks_(run.peaks), parallel_(run.parallel) {}

  /// Kernel against the readable transcription, both with tangent, joint points and frames on both ends.
  void against_reference(const std::string& kind, double limit) {
    const std::string formulation = "invariant";
    add({fmt::format("{} invariant, residual + tangent: transcription / kernel", label(kind)),
         ratio(timings_, {formulation, kind, "residual_tangent", "reference"},
               {formulation, kind, "residual_tangent", "kernel"}),
         limit, true, ""});
  }

  void against_attached(const std::string& kind, double limit) {
    add({fmt::format("{} residual: invariant / attached, kernels without ends", label(kind)),
         ratio(timings_, {"invariant", kind, "residual", "kernel", "no_ends"},
               {"attached_a", kind, "residual", "kernel", "no_ends"}),
         limit, false, ""});
  }

  void batch(const std::string& formulation, const std::string& kind, const std::string& what, double limit) {
    const std::string isa = best_isa();
    add({fmt::format("{} {} {}: own scalar kernel / {} batch", label(kind), formulation, words(what), isa),
         ratio(timings_, {formulation, kind, what, "kernel", "no_ends"},
               {.formulation = formulation,
                .kind = kind,
                .what = what,
                .implementation = "batch",
                .variant = "no_ends",
                .isa = isa,
                .joints = kInCache}),
         limit, true, ""});
  }

  void peak(const std::string& formulation, const std::string& kind, const std::string& what, double limit) {
    const std::string isa = best_isa();
    const Timing* t = find(timings_, {.formulation = formulation,
                                      .kind = kind,
                                      .what = what,
                                      .implementation = "batch",
                                      .variant = "no_ends",
                                      .isa = isa,
                                      .joints = kInCache});
    const auto p = std::ranges::find_if(
        peaks_, [&](const bench::Peak& at) { return at.isa == isa && at.precision == "double"; });
    const double share =
        t && t->flops > 0 && p != peaks_.end() ? t->flops / t->ns / p->flops_per_ns : kMissing;
    add({fmt::format("{} {} {}: share of the {} peak", label(kind), formulation, words(what), isa), share,
         limit, true, ""});
  }

  /// Against what the units that multiply can do; see share_of_ports.
  void ports(const std::string& kind, const std::string& what, double limit) {
    const Timing* t = in_cache("invariant", kind, what);
    const auto p = std::ranges::find_if(
        peaks_, [&](const bench::Peak& at) { return at.isa == best_isa() && at.precision == "double"; });
    add({fmt::format("{} invariant {}: share of the {} ports that multiply", label(kind), words(what),
                     best_isa()),
         t && p != peaks_.end() ? bench::share_of_ports(*t, *p) : kMissing, limit, true, ""});
  }

  /// The cheapest law without a defect, with tangent; ns.
  void cheapest(const std::string& kind, double limit) {
    const Timing* t = in_cache("fasse", kind, "residual_tangent");
    add({fmt::format("{} fasse with tangent, {} batch, ns", label(kind), best_isa()), t ? t->ns : kMissing,
         limit, false, ""});
  }
  void cheapest_kernel(double limit) {
    const Timing* t = find(timings_, {"fasse", "angular", "residual_tangent", "kernel", "no_ends"});
    add({"angular fasse with tangent, kernel without ends, ns", t ? t->ns : kMissing, limit, false, ""});
  }

  void compressed(const std::string& kind, double limit) {
    const Timing* t = in_cache("invariant", kind, "residual_compressed", kMany);
    add({fmt::format("{} invariant with compressed tangent, {} joints, ns", label(kind), kMany),
         t ? t->ns : kMissing, limit, false, ""});
  }

  /// Where the machine has both.
  void registers(const std::string& kind, double limit) {
    const auto pick = [&](const char* isa) {
      return Pick{.formulation = "potential",
                  .kind = kind,
                  .what = "residual_tangent",
                  .implementation = "batch",
                  .variant = "no_ends",
                  .isa = isa,
                  .joints = kInCache};
    };
    if (find(timings_, pick("avx2vl")) == nullptr) return;
    add({fmt::format("{} potential with tangent: AVX2 in 16 registers / in 32", label(kind)),
         ratio(timings_, pick("avx2"), pick("avx2vl")), limit, true, ""});
  }

  void threads() {
    const Pick one{.formulation = "invariant",
                   .kind = "angular",
                   .what = "residual_tangent",
                   .implementation = "batch",
                   .variant = "no_ends",
                   .isa = best_isa(),
                   .joints = kMany,
                   .threads = 1};
    two_threads(fmt::format("two threads against one, {} joints, wall time", kMany), one);
  }

  /// From poses to a sparse matrix, from memory: how many times as long as `assemble` this way takes.
  void assembly(const std::string& kind, const std::string& way, const std::string& implementation,
                double limit) {
    const Pick other{"invariant", kind,    "assembly", implementation, "", isa_of(implementation),
                     "double",    kLattice};
    add({fmt::format("{} invariant, poses to a sparse matrix, {} joints: {} / assemble", label(kind),
                     kLattice, way),
         ratio(timings_, other, assembled(kind, "")), limit, true, ""});
  }

  void assembly_threads() {
    two_threads(fmt::format("assemble, two threads against one, {} joints, wall time", kLattice),
                assembled("linear_angular", "wall"));
  }

  void statics() {
    add({"C1 static solve, invariant: GSL hybrids / Newton on the kernel",
         ratio(timings_, {"invariant", "angular", "equilibrium_gsl", "reference"},
               {"invariant", "angular", "equilibrium_newton", "kernel"}),
         4, true, ""});
  }

  std::vector<Target> take() { return std::move(targets_); }

  static constexpr int kInCache = 256, kMany = 100000, kLattice = 99904;

 private:
  const Timing* in_cache(const std::string& formulation, const std::string& kind, const std::string& what,
                         int joints = kInCache) const {
    return find(timings_, {.formulation = formulation,
                           .kind = kind,
                           .what = what,
                           .implementation = "batch",
                           .variant = "no_ends",
                           .isa = best_isa(),
                           .joints = joints});
  }
  Pick assembled(const std::string& kind, const std::string& variant) const {
    return {"invariant", kind, "assembly", "assemble", variant, best_isa(), "double", kLattice};
  }
  std::string isa_of(const std::string& implementation) const {
    return implementation == "batch" ? best_isa() : "";
  }
  void two_threads(const std::string& name, const Pick& one) {
    Pick two = one;
    two.threads = 2;
    const double gain = ratio(timings_, one, two);
    if (parallel_ < bench::kIdle && std::isfinite(gain)) {
      add({name, kMissing, kTwoThreads, true,
           fmt::format("not measurable: two idle loops gained {:.2f}, others are at work on the cores",
                       parallel_)});
    } else {
      add({name, gain, kTwoThreads, true, ""});
    }
  }
  static constexpr double kTwoThreads = 1.8;
  static std::string label(const std::string& kind) {
    return kind == "linear_angular" ? "linear/angular" : kind;
  }
  static std::string words(const std::string& what) {
    return what == "residual" ? "residual" : "with tangent";
  }
  /// The widest instruction set of which a batch was timed.
  std::string best_isa() const {
    for (const char* isa : {"avx512", "avx2", "sse2"})
      if (std::ranges::any_of(timings_, [&](const Timing& t) { return t.isa == isa; })) return isa;
    return "avx512";
  }
  void add(Target t) {
    if (std::isfinite(t.value) && !t.met()) t.note = missed(t);
    targets_.push_back(std::move(t));
  }
  /// By how much; why is for the reader of the roofline.
  static std::string missed(const Target& t) {
    return fmt::format("missed by {:.0f} %", 100 * std::abs(t.value / t.limit - 1));
  }

  const std::vector<Timing>& timings_;
  const bench::Peaks& peaks_;
  const double parallel_;
  std::vector<Target> targets_;
};

}  // namespace

std::vector<Target> speed_targets(const bench::Run& run) {
  Table table(run);
#ifdef __clang__
  table.against_reference("angular", 4), table.against_reference("linear", 3);
#else
  table.against_reference("angular", 5), table.against_reference("linear", 4);
#endif
  table.against_reference("linear_angular", 3);
  table.against_attached("angular", 1.10), table.against_attached("linear", 1.35);
  table.batch("invariant", "angular", "residual", 6),
      table.batch("invariant", "angular", "residual_tangent", 6);
  table.batch("invariant", "linear", "residual", 6),
      table.batch("invariant", "linear", "residual_tangent", 6);
  for (const char* what : {"residual", "residual_tangent"}) {
    for (const char* kind : {"angular", "linear"}) {
      table.peak("attached_a", kind, what, 0.6), table.peak("invariant", kind, what, 0.6);
      table.peak("intrinsic", kind, what, 0.5);
    }
  }
  for (const char* kind : {"angular", "linear", "linear_angular"}) {
    table.ports(kind, "residual", 0.75), table.ports(kind, "residual_tangent", 0.65);
  }
  table.cheapest_kernel(20), table.cheapest("angular", 4), table.cheapest("linear_angular", 18);
  table.compressed("linear", 20);
  table.registers("angular", 1.1), table.registers("linear_angular", 1.1);
  table.assembly("linear_angular", "scalar kernel", "kernel", 2.2);
  table.assembly("linear_angular", "textbook", "textbook", 9);
  table.assembly("linear_angular", "whole table of a batch", "batch", 2.8);
  table.threads(), table.assembly_threads();
  table.statics();
  return table.take();
}

}  // namespace halfway::reports
