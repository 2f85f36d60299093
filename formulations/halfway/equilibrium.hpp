// Equilibrium of one loaded node on a joint whose other node is clamped: Newton on the manifold
// with the analytic tangent and adaptive load steps.
#pragma once

#include "halfway/joint.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway {

/// Load on node b at load factor 1; the solver scales it.
template <class T>
struct NodeLoad {
  Vec3<T> force = Vec3<T>::Zero();            ///< fixed direction, global axes, N
  Vec3<T> point = Vec3<T>::Zero();            ///< where it acts, axes of node b, m
  Vec3<T> moment = Vec3<T>::Zero();           ///< fixed direction, global axes, N m
  Vec3<T> follower_moment = Vec3<T>::Zero();  ///< turns with node b, axes of node b, N m
};

/// What is unknown of node b: 3 rotations, 3 displacements (the orientation is held), or all 6.
constexpr int unknown_count(Kind kind) { return strain_count(kind); }

/// Load on node b in the unknown directions and its derivative by (dx_b, w_b).
template <class T, int n>
struct Balance {
  Eigen::Matrix<T, n, 1> load;
  Eigen::Matrix<T, n, n> tangent;
};

enum class Status {
  converged,
  singular_tangent,  ///< the tangent cannot be solved with: a limit point or a mechanism
  no_convergence     ///< no load step, however small, converges on the same branch
};

/// What the solver reached, whether it converged or not.
template <class T>
struct Outcome {
  Status status = Status::converged;
  T factor{0};         ///< load factor reached
  Pose<T> b{};         ///< equilibrium there
  int iterations = 0;  ///< Newton iterations of all steps, rejected ones included
  int steps = 0;       ///< accepted load steps
  T residual{0};       ///< |internal - applied| / |applied| at the pose reached
};

template <class T>
struct SolverOptions {
  T smallest_step = T(1e-9);  ///< of the load factor, relative to the whole advance
  T largest_turn = T(0.35);   ///< rad between accepted states; a longer step may change branch
  int iterations_per_step = 12;
  int most_iterations = 20000;  ///< of one advance, rejected steps included: a path that creeps has an end
};

/// The load on node b at a factor and pose, in the unknown directions.
template <Kind kind, class T>
Balance<T, unknown_count(kind)> applied(const NodeLoad<T>& load, const T& factor, const Pose<T>& b) {
  const Vec3<T> f = factor * load.force;
  Balance<T, unknown_count(kind)> out;
  if constexpr (kind == Kind::linear) {
    out.load = f;
    out.tangent.setZero();
  } else {
    const Vec3<T> arm = b.R * load.point;
    const Vec3<T> follower = factor * (b.R * load.follower_moment);
    const Vec3<T> m = factor * load.moment + follower + arm.cross(f);
    const Mat3<T> m_w = skew(f) * skew(arm) - skew(follower);
    out.tangent.setZero();
    if constexpr (kind == Kind::linear_angular)
      out.load << f, m;
    else
      out.load = m;
    out.tangent.template bottomRightCorner<3, 3>() = m_w;
  }
  return out;
}

/// b displaced by (dx, w), each where it is unknown.
template <Kind kind, class T>
Pose<T> displaced(const Pose<T>& b, const Eigen::Matrix<T, unknown_count(kind), 1>& step) {
  Pose<T> out = b;
  if constexpr (kind != Kind::angular) out.x += step.template head<3>();
  if constexpr (kind != Kind::linear) out.R = so3::exp<T>(step.template tail<3>()) * b.R;
  return out;
}

/// J^-1 r; not finite where J is singular. Three unknowns by cofactors, six by elimination: Newton
/// corrects what either loses, because the residual is computed afresh.
template <class T, int n>
Eigen::Matrix<T, n, 1> solved(const Eigen::Matrix<T, n, n>& J, const Eigen::Matrix<T, n, 1>& r) {
  if constexpr (n == 3)
    return J.inverse() * r;
  else
    return J.partialPivLu().solve(r);
}

/// Is the imbalance what the rounding of the loads and of the pose leaves of it, component by component?
/// Of 10 200 random scenes the worst rounding is 78 eps of these; what stopped too early is beyond 1000.
template <Kind kind, class T, int n>
bool is_rounding(const Eigen::Matrix<T, n, 1>& imbalance, const Eigen::Matrix<T, n, 1>& load,
                 const Eigen::Matrix<T, n, n>& J, const Pose<T>& b) {
  Eigen::Matrix<T, n, 1> reach = Eigen::Matrix<T, n, 1>::Ones();  // of a pose: 1 rad, |x| m
  if constexpr (kind != Kind::angular) reach.template head<3>().array() += T(b.x.norm());
  const Eigen::Matrix<T, n, 1> scale = load.cwiseAbs() + J.cwiseAbs() * reach;
  const T limit = T(100) * Eigen::NumTraits<T>::epsilon();
  for (int i = 0; i < n; ++i) {
    using std::abs;
    if (!(T(abs(imbalance[i])) <= limit * scale[i])) return false;
  }
  return true;
}

/// Newton at one load factor, until the steps stop shrinking: to rounding, not to a tolerance.
/// @return iterations used, or 0 when it did not converge; `b` is the solution.
template <Kind kind, class T, class Internal>
int newton(const Internal& internal, const NodeLoad<T>& load, const T& factor,
           const SolverOptions<T>& options, Pose<T>& b, bool& singular) {
  using std::isfinite;
  const T start_of_rounding = T(1e-5);  // quadratic convergence: the next step is at 1e-10, then rounding
  const T nothing = Eigen::NumTraits<T>::epsilon() * Eigen::NumTraits<T>::epsilon();  // of any angle, rad
  T previous(0);
  for (int i = 1; i <= options.iterations_per_step; ++i) {
    const auto inside = internal(b);
    const auto outside = applied<kind>(load, factor, b);
    const Eigen::Matrix<T, unknown_count(kind), unknown_count(kind)> J = inside.tangent - outside.tangent;
    const Eigen::Matrix<T, unknown_count(kind), 1> imbalance = outside.load - inside.load;
    const Eigen::Matrix<T, unknown_count(kind), 1> step = solved(J, imbalance);
    const T size = step.norm();
    singular = !isfinite(size);
    if (singular) return 0;
    const bool is_noise = is_rounding<kind, T, unknown_count(kind)>(imbalance, outside.load, J, b);
    if (i > 1 && is_noise && size <= start_of_rounding && size >= previous / T(4)) return i;
    if (i > 2 && size > previous) return 0;
    b = displaced<kind>(b, step);
    if (size <= nothing && is_noise) return i;
    previous = size;
  }
  return 0;
}

/// Follows the equilibrium from `state` (at factor_from) to factor_to in load steps that are halved
/// when Newton fails or turns node b too far, and doubled after quick ones.
/// @param internal  callable Pose -> Balance: load of the joint on node b and its tangent.
template <Kind kind, class T, class Internal>
Outcome<T> follow(const Internal& internal, const NodeLoad<T>& load, const Pose<T>& state,
                  const T& factor_from, const T& factor_to, const SolverOptions<T>& options = {}) {
  const T span = factor_to - factor_from;
  Outcome<T> out;
  out.b = state;
  T done(0), step(1);
  bool singular = false;
  while (done < T(1)) {
    using std::min;
    step = min(step, T(T(1) - done));
    const T target = done + step;
    Pose<T> b = out.b;
    const int used = newton<kind>(internal, load, T(factor_from + target * span), options, b, singular);
    const T turn = kind == Kind::linear ? T(0) : T(so3::log<T>(b.R * out.b.R.transpose()).norm());
    out.iterations += used > 0 ? used : options.iterations_per_step;
    if (used > 0 && turn <= options.largest_turn) {
      out.b = b;
      done = target;
      ++out.steps;
      if (used <= 6) step *= T(2);
      continue;
    }
    step /= T(2);
    if (step < options.smallest_step || out.iterations > options.most_iterations) {
      out.status = singular ? Status::singular_tangent : Status::no_convergence;
      break;
    }
  }
  out.factor = factor_from + done * span;
  const auto outside = applied<kind>(load, out.factor, out.b).load;
  const T scale = outside.norm();
  out.residual = (internal(out.b).load - outside).norm() / (scale > T(0) ? scale : T(1));
  return out;
}

/// The joint's load on node b in the unknown directions, from a statically typed joint.
template <Kind kind, class T, class F, class L>
auto internal_of(const Joint<kind, T, F, L>& joint, const Pose<T>& a) {
  return [&joint, a](const Pose<T>& b) {
    Balance<T, unknown_count(kind)> out;
    const auto q = loads<true>(joint, a, b);
    if constexpr (kind == Kind::angular) {
      out.load = q.m_b;
      out.tangent = q.m_b_wb;
    } else {
      constexpr int n = unknown_count(kind);
      out.load = q.q.template segment<n>(6);
      out.tangent = q.tangent.template block<n, n>(6, 6);
    }
    return out;
  };
}

/// The unstrained pose of node b for node a at `a`.
template <class T>
Pose<T> unstrained(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a) {
  Pose<T> b;
  b.R = a.R * end_a.H * end_b.H.transpose();
  b.x = a.x + a.R * end_a.o - b.R * end_b.o;
  return b;
}

}  // namespace halfway
