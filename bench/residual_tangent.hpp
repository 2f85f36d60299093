// How long do the loads of one joint take, and the loads with their tangent?
//
// The joint is a static type: formulation, law and kind are known to the compiler, no call in the
// timed loop is virtual. Included only by the generated units, one for each line of catalog.def.
#pragma once

#include "bench/check.hpp"

#include <memory>

namespace halfway::bench {

template <class F>
F make_formulation() {
  if constexpr (requires { F::kProbeXi; })
    return F(F::kProbeXi);
  else
    return F{};
}

template <class F>
Inputs inputs_of(Kind kind) {
  constexpr bool block_diagonal = requires { F::kBlockDiagonalLawOnly; };
  double xi = 0.5;
  if constexpr (requires { F::kProbeXi; }) xi = F::kProbeXi;
  return inputs(kind, xi, block_diagonal);
}

template <class F, Kind kind>
auto make_joint(const reference::JointSpec& spec) {
  constexpr int n = strain_count(kind);
  const LinearLaw<double, n> law{std::get<reference::LinearSpec>(spec.law).matrix};
  return Joint<kind, double, F, LinearLaw<double, n>>{make_formulation<F>(), law, spec.a, spec.b};
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
  c.timed = [in](benchmark::State& state) {
    const auto joint = make_joint<F, kind>(in->spec);
    const Pose<double>* const a = in->a.data();
    const Pose<double>* const b = in->b.data();
    for (auto _ : state) {
      for (int i = 0; i < kPoses; ++i) {
        auto result = loads<with_tangent>(joint, a[i], b[i]);
        benchmark::DoNotOptimize(result);
      }
    }
  };
  return c;
}

template <class F>
Cases residual_cases() {
  Cases cases;
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
