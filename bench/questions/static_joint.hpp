// The joint of a spec as a static type: formulation, law and kind are known to the compiler.
#pragma once

#include "bench/harness/inputs.hpp"

namespace halfway::bench {

template <class F>
F make_formulation() {
  if constexpr (requires { F::kProbeXi; })
    return F(F::kProbeXi);
  else
    return F{};
}

template <class F, Kind kind, class T = double>
auto make_joint(const reference::JointSpec& spec) {
  constexpr int n = strain_count(kind);
  const LinearLaw<T, n> law{std::get<reference::LinearSpec>(spec.law).matrix.template cast<T>()};
  const auto end = [](const JointEnd<double>& e) {
    return JointEnd<T>{e.o.template cast<T>(), e.H.template cast<T>()};
  };
  return Joint<kind, T, F, LinearLaw<T, n>>{make_formulation<F>(), law, end(spec.a), end(spec.b)};
}

template <class F>
Inputs inputs_of(Kind kind, bool ends = true) {
  constexpr bool block_diagonal = requires { F::kBlockDiagonalLawOnly; };
  double xi = 0.5;
  if constexpr (requires { F::kProbeXi; }) xi = F::kProbeXi;
  return inputs(kind, xi, block_diagonal, ends);
}

}  // namespace halfway::bench
