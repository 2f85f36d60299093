// The joint of a spec as a static type: formulation, law and kind are known to the compiler.
#pragma once

#include "bench/harness/inputs.hpp"
#include "reference/face/make_formulation.hpp"

namespace halfway::bench {

template <class F>
F make_formulation() {
  return reference::make_formulation<F>(reference::probe_parameters<F>());
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
  double (*radius)(const Eigen::MatrixXd&) = nullptr;
  if constexpr (requires(const Eigen::MatrixXd& K) { F::convex_radius(K); }) radius = &F::convex_radius;
  return inputs(kind, reference::probe_parameters<F>(), block_diagonal, ends, radius);
}

}  // namespace halfway::bench
