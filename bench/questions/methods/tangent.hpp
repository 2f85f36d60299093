// How long does the tangent of a joint take, and how right is it, by each way of differentiating?
//
// A method is a type with
//   name                                  the label of the timing
//   limit                                 of the tangent's error at the timed poses, with its reason
//   Scalar<kind>                          in which it evaluates the joint
//   evaluate<kind>(joint, a, b)           loads and tangent in double from poses in double
// The unknowns are (dx_a, w_a, dx_b, w_b), spins in global axes; an angular joint has (w_a, w_b) only. Every
// method differentiates with respect to all of them, and uses nothing that is known of the joint.
#pragma once

#include "bench/questions/methods/problem.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "halfway/systems/potentials.hpp"

#include <array>

namespace halfway::bench {

template <Kind kind, class T = double>
using Loads = std::conditional_t<kind == Kind::angular, AngularLoads<T>, NodeLoads<T>>;

constexpr int unknowns(Kind kind) { return kind == Kind::angular ? 6 : 12; }

/// Unknown k of a joint: a spin or a displacement of node a or b about or along an axis.
struct Direction {
  int node;  ///< 0: a, 1: b
  bool spin;
  int axis;
};

constexpr Direction direction(Kind kind, int k) {
  if (kind == Kind::angular) return {k / 3, true, k % 3};
  return {k / 6, k % 6 >= 3, k % 3};
}

template <class T>
Vec3<T>& vector_of(AngularLoads<T>& r) {
  return r.m_b;
}
template <class T>
Eigen::Matrix<T, 12, 1>& vector_of(NodeLoads<T>& r) {
  return r.q;
}

/// Entry (i, k) of the derivative of the loads by unknown k.
inline double& entry(AngularLoads<double>& r, int i, int k) {
  return k < 3 ? r.m_b_wa(i, k) : r.m_b_wb(i, k - 3);
}
inline double& entry(NodeLoads<double>& r, int i, int k) { return r.tangent(i, k); }

/// R turned by the infinitesimal spin e about an axis: (1 + e [axis]) R, which is exact where e^2 = 0.
template <class T>
void turn(Mat3<T>& R, int axis, const T& e) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Eigen::Matrix<T, 1, 3> row = R.row(j);
  R.row(j) -= e * R.row(k);
  R.row(k) += e * row;
}

/// For scalars with one infinitesimal part: one residual for each unknown.
/// @param e         the infinitesimal
/// @param parts     callable T -> {value, derivative}
template <Kind kind, class T, class J, class Parts>
Loads<kind> one_unknown_at_a_time(const J& joint, const Pose<double>& a, const Pose<double>& b, const T& e,
                                  const Parts& parts) {
  const std::array<Pose<T>, 2> nodes{reference::cast<T>(a), reference::cast<T>(b)};
  Loads<kind> out;
  for (int k = 0; k < unknowns(kind); ++k) {
    const Direction d = direction(kind, k);
    std::array<Pose<T>, 2> moved = nodes;
    if (d.spin)
      turn(moved[d.node].R, d.axis, e);
    else
      moved[d.node].x[d.axis] += e;
    auto r = loads<false>(joint, moved[0], moved[1]);
    for (int i = 0; i < vector_of(r).size(); ++i) {
      std::tie(vector_of(out)[i], entry(out, i, k)) = parts(vector_of(r)[i]);
    }
  }
  return out;
}

/// For scalars T that carry a derivative for each unknown: one residual.
/// @tparam Make   T make(value, derivative by all unknowns)
/// @param parts   callable T -> {value, derivatives}
template <Kind kind, class T, class J, class Make, class Parts>
Loads<kind> all_unknowns_at_once(const J& joint, const Pose<double>& a, const Pose<double>& b,
                                 const Make& make, const Parts& parts) {
  constexpr int n = unknowns(kind);
  using Derivatives = Eigen::Matrix<double, n, 1>;
  const auto seeded = [&](const Pose<double>& pose, int node) {
    std::array<Mat3<double>, 3> turned;  // dR by each spin
    for (int axis = 0; axis < 3; ++axis) turned[axis] = skew<double>(Vec3<double>::Unit(axis)) * pose.R;
    Pose<T> out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Derivatives d = Derivatives::Zero();
        for (int axis = 0; axis < 3; ++axis) d[(node + 1) * n / 2 - 3 + axis] = turned[axis](i, j);
        out.R(i, j) = make(pose.R(i, j), d);
      }
      Derivatives d = Derivatives::Zero();
      if (kind != Kind::angular) d[node * n / 2 + i] = 1;
      out.x[i] = make(pose.x[i], d);
    }
    return out;
  };
  auto r = loads<false>(joint, seeded(a, 0), seeded(b, 1));
  Loads<kind> out;
  for (int i = 0; i < vector_of(r).size(); ++i) {
    const auto& [value, derivatives] = parts(vector_of(r)[i]);
    vector_of(out)[i] = value;
    for (int k = 0; k < n; ++k) entry(out, i, k) = derivatives[k];
  }
  return out;
}

template <class T, Kind kind, class F>
auto joint_in(const reference::JointSpec& spec) {
  constexpr int n = strain_count(kind);
  const auto end = [](const JointEnd<double>& e) {
    return JointEnd<T>{e.o.template cast<T>(), e.H.template cast<T>()};
  };
  const LinearLaw<T, n> law{std::get<reference::LinearSpec>(spec.law).matrix.template cast<T>()};
  return Joint<kind, T, F, LinearLaw<T, n>>{F{}, law, end(spec.a), end(spec.b)};
}

/// What is checked and what is timed, compiled once.
template <class Method, Kind kind, class J>
[[gnu::noinline]] Loads<kind> loads_by(const J& joint, const Pose<double>& a, const Pose<double>& b) {
  return Method::template evaluate<kind>(joint, a, b);
}

template <class Method, class F, Kind kind>
Case tangent_case() {
  using T = typename Method::template Scalar<kind>;
  const auto problem = tangent_problem(F::name, kind);
  Case c;
  c.formulation = F::name;
  c.kind = to_string(kind);
  c.what = "residual_tangent";
  c.method = Method::name;
  c.name = c.formulation + '/' + c.kind + '/' + c.what + '/' + c.method;
  c.evaluations = kPoses;
  c.check = [problem] {
    const auto joint = joint_in<T, kind, F>(problem->timed.inputs().spec);
    const auto evaluate = [&joint](const Pose<double>& a, const Pose<double>& b) {
      return evaluated<true>(loads_by<Method, kind>(joint, a, b));
    };
    return check_tangent(*problem, evaluate, Method::limit);
  };
  c.timed = [problem](benchmark::State& state) {
    const Inputs& in = problem->timed.inputs();
    const auto joint = joint_in<T, kind, F>(in.spec);
    const Pose<double>* const a = in.a.data();
    const Pose<double>* const b = in.b.data();
    for (auto _ : state) {
      for (int i = 0; i < kPoses; ++i) {
        auto result = loads_by<Method, kind>(joint, a[i], b[i]);
        benchmark::DoNotOptimize(result);
      }
    }
  };
  return c;
}

/// Two of them, for scalars whose templates cost seconds of compilation a joint.
template <class Method>
Cases invariant_tangents_by() {
  return {tangent_case<Method, Invariant, Kind::angular>(),
          tangent_case<Method, Invariant, Kind::linear_angular>()};
}

/// The joints of the comparison, by one method.
template <class Method>
Cases tangents_by() {
  return {tangent_case<Method, AttachedA, Kind::angular>(), tangent_case<Method, Invariant, Kind::angular>(),
          tangent_case<Method, Conformal, Kind::angular>(),
          tangent_case<Method, Invariant, Kind::linear_angular>()};
}

/// Limit of the methods that do not truncate: what the project asks of any tangent, some twenty roundings.
inline constexpr double kRoundingLimit = 5e-15;

}  // namespace halfway::bench
