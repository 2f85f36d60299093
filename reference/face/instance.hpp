// Makes the registry entry of one formulation; included only by generated units.
#pragma once

#include "halfway/joint/formulation.hpp"
#include "reference/face/instantiations.hpp"
#include "reference/face/make_formulation.hpp"

namespace halfway::reference {

template <class F, Kind kind, class T>
auto make_joint(const JointSpec& spec) {
  using L = AnyLaw<T, strain_count(kind)>;
  const auto end = [](const JointEnd<double>& e) {
    return JointEnd<T>{e.o.template cast<T>(), e.H.template cast<T>()};
  };
  return Joint<kind, T, F, L>{make_formulation<F>(spec), L(spec.law), end(spec.a), end(spec.b)};
}

template <Kind kind>
using KindTag = std::integral_constant<Kind, kind>;

template <class Fn>
auto dispatch(Kind kind, Fn&& fn) {
  switch (kind) {
    case Kind::angular:
      return fn(KindTag<Kind::angular>{});
    case Kind::linear:
      return fn(KindTag<Kind::linear>{});
    default:
      return fn(KindTag<Kind::linear_angular>{});
  }
}

template <class F, class T>
Evaluators<T> evaluators() {
  Evaluators<T> e;
  e.strain = [](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    return dispatch(spec.kind, [&](auto kind) -> Eigen::Matrix<T, Eigen::Dynamic, 1> {
      return strain(make_joint<F, kind(), T>(spec), a, b);
    });
  };
  e.angular = [](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b, bool with_tangent) {
    const auto joint = make_joint<F, Kind::angular, T>(spec);
    return with_tangent ? loads<true>(joint, a, b) : loads<false>(joint, a, b);
  };
  e.point = [](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b, bool with_tangent) {
    const auto evaluate = [&](auto kind) {
      const auto joint = make_joint<F, kind(), T>(spec);
      return with_tangent ? loads<true>(joint, a, b) : loads<false>(joint, a, b);
    };
    return spec.kind == Kind::linear ? evaluate(KindTag<Kind::linear>{})
                                     : evaluate(KindTag<Kind::linear_angular>{});
  };
  e.energy = [](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) -> std::optional<T> {
    if (!F::has_potential(spec.kind)) return std::nullopt;
    return dispatch(spec.kind, [&](auto kind) {
      const auto joint = make_joint<F, kind(), T>(spec);
      return std::optional<T>(energy(joint, a, b));
    });
  };
  return e;
}

template <class F>
Entry make_entry(std::string_view type, std::string_view header, bool wide) {
  check_formulation<F>();
  Entry entry{F::name,
              F::stands_for,
              type,
              header,
              F::facts,
              false,
              0.5,
              wide,
              false,
              &F::has_potential,
              evaluators<F, double>(),
              evaluators<F, Real50>(),
              {},
              {}};
  if constexpr (requires { F::kProbeXi; }) {
    entry.needs_xi = true;
    entry.probe_xi = F::kProbeXi;
  }
  entry.needs_length = requires { F::kProbeLength; };
  entry.probe = probe_parameters<F>();
  if constexpr (requires(const Eigen::MatrixXd& K) { F::convex_radius(K); })
    entry.convex_radius = &F::convex_radius;
  if constexpr (requires { F::kBlockDiagonalLawOnly; }) entry.block_diagonal_law_only = true;
  return entry;
}

}  // namespace halfway::reference
