// How long do the loads of one joint take, and the loads with their tangent?
//
// The joint is a static type: formulation, law and kind are known to the compiler, no call in the
// timed loop is virtual. Included only by the generated units, one for each line of catalog.def.
#pragma once

#include "bench/harness/check.hpp"
#include "bench/harness/flops.hpp"
#include "bench/questions/static_joint.hpp"
#include "halfway/kernels/kernel.hpp"

#include <memory>

namespace halfway::bench {

/// Poses read and loads written; the joint stays in registers or L1.
template <Kind kind, bool with_tangent>
constexpr double bytes() {
  const int read = kind == Kind::angular ? 2 * 9 : 2 * 12;  // positions do not concern an angular joint
  const int written = kind == Kind::angular ? (with_tangent ? 3 + 18 : 3) : (with_tangent ? 12 + 144 : 12);
  return (read + written) * double(sizeof(double));
}

template <class F, Kind kind, bool with_tangent>
Case residual_case(const std::shared_ptr<const Inputs>& in) {
  Case c;
  c.formulation = F::name;
  c.kind = to_string(kind);
  c.what = with_tangent ? "residual_tangent" : "residual";
  c.name = c.formulation + '/' + c.kind + '/' + c.what;
  c.evaluations = kPoses;
  c.check = [in] {
    const auto joint = make_joint<F, kind>(in->spec);
    std::vector<Evaluated> values;
    for (int i = 0; i < kPoses; ++i) {
      values.push_back(evaluated<with_tangent>(loads<with_tangent>(joint, in->a[i], in->b[i])));
    }
    return compare(F::name, *in, values);
  };
  c.flops = kept_flops(c.name);
  c.bytes = bytes<kind, with_tangent>();
  time_by(c, [in, joint = make_joint<F, kind>(in->spec)](int iterations) {
    // A caller's own copy: no store through a pointer can touch it, so it stays in registers.
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    const auto local = joint;
    const Pose<double>* const a = in->a.data();
    const Pose<double>* const b = in->b.data();
    for (int iteration = 0; iteration < iterations; ++iteration) {
      for (int i = 0; i < kPoses; ++i) {
        auto result = loads<with_tangent>(local, a[i], b[i]);
        benchmark::DoNotOptimize(result);
      }
    }
  });
  return c;
}

/// The transcription is timed where the catalog asks for it (`wide`), and where it is all there is.
template <class F, bool wide>
Cases residual_cases() {
  Cases cases;
  if constexpr (kernel::kHasKernel<F> && !wide) return cases;
  const auto add = [&]<Kind kind>(std::integral_constant<Kind, kind>) {
    const auto in = std::make_shared<const Inputs>(inputs_of<F>(kind));
    cases.push_back(residual_case<F, kind, false>(in));
    cases.push_back(residual_case<F, kind, true>(in));
  };
  add(std::integral_constant<Kind, Kind::angular>{});
  add(std::integral_constant<Kind, Kind::linear>{});
  add(std::integral_constant<Kind, Kind::linear_angular>{});
  return cases;
}

}  // namespace halfway::bench
