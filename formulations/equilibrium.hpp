// Equilibrium of one loaded node on a joint whose other node is clamped: Newton on the manifold
// with the analytic tangent and adaptive load steps.
#pragma once

#include "formulations/joint.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway {

/// Load on node b at load factor 1; the solver scales it.
template <class T> struct NodeLoad {
  Vec3<T> force = Vec3<T>::Zero();            ///< fixed direction, global axes, N
  Vec3<T> point = Vec3<T>::Zero();            ///< where it acts, axes of node b, m
  Vec3<T> moment = Vec3<T>::Zero();           ///< fixed direction, global axes, N m
  Vec3<T> follower_moment = Vec3<T>::Zero();  ///< turns with node b, axes of node b, N m
};

enum class Status {
  converged,
  singular_tangent,    ///< a limit point or a mechanism: the tangent cannot be factored
  step_too_small,      ///< no load step converges: the path turns back or jumps here
  too_many_iterations
};

/// What the solver reached, whether it converged or not.
template <class T> struct Outcome {
  Status status = Status::converged;
  T factor{0};          ///< load factor reached
  Pose<T> b{};          ///< equilibrium there
  int iterations = 0;   ///< of all steps
  int steps = 0;
  T residual{0};        ///< largest component over the largest load component
};

template <class T> struct SolverOptions {
  T first_step{1};               ///< of the load factor
  T smallest_step{1e-9};
  int iterations_per_step = 12;
  T largest_rotation{0.3};       ///< rad per Newton step; larger ones mean a step that is too long
  T largest_turn{0.35};          ///< rad between two accepted states: keeps to the branch
};

/// What is unknown of node b: rotation only, position only, or both.
enum class Unknowns { rotation, position, both };

constexpr Unknowns unknowns_of(Kind kind) {
  return kind == Kind::angular ? Unknowns::rotation : kind == Kind::linear ? Unknowns::position : Unknowns::both;
}

/// Internal load on node b and its tangent by (dx_b, w_b), of which the unknown rows count.
template <class T, int n> struct Residual {
  Eigen::Matrix<T, n, 1> load;
  Eigen::Matrix<T, n, n> tangent;
};

}  // namespace halfway
