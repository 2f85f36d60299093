// The equilibrium path of a loaded joint: load steps, each from a prediction, and what is known at the end.
#pragma once

#include "halfway/equilibrium/balance.hpp"
#include "halfway/equilibrium/load_steps.hpp"

#include <algorithm>

namespace halfway {

/// (dx, psi) of any kind of joint; zero where nothing is unknown.
template <class T>
using Motion = Eigen::Matrix<T, 6, 1>;

template <Kind kind, class T>
Motion<T> widened(const Eigen::Matrix<T, unknown_count(kind), 1>& v) {
  Motion<T> out = Motion<T>::Zero();
  if constexpr (kind == Kind::angular)
    out.template tail<3>() = v;
  else
    out.template head<unknown_count(kind)>() = v;
  return out;
}

template <Kind kind, class T>
Eigen::Matrix<T, unknown_count(kind), 1> narrowed(const Motion<T>& v) {
  if constexpr (kind == Kind::angular)
    return v.template tail<3>();
  else
    return v.template head<unknown_count(kind)>();
}

/// A point of the path and its direction there.
template <class T>
struct PathKnot {
  T factor{0};
  Pose<T> joint{};                      ///< joint frame b seen from joint frame a: x = P_a^T d, R = P_a^T P_b
  Motion<T> slope = Motion<T>::Zero();  ///< d(dx, psi) / d factor
};

/// What the solver reached, whether it converged or not; the default is the unloaded, unstrained joint.
template <class T>
struct Outcome {
  Status status = Status::converged;
  T factor{0};                          ///< load factor reached
  Pose<T> joint{};                      ///< equilibrium there, as in PathKnot
  Motion<T> error = Motion<T>::Zero();  ///< estimated, of (dx, psi), m and rad
  int iterations = 0;                   ///< Newton's corrections of all steps, rejected ones included
  int steps = 0;                        ///< accepted load steps
  T residual{0};                        ///< |internal - applied| / |applied| there
  PathKnot<T> last{}, before{};         ///< from which the next step is predicted
  int sign = 0;                         ///< of the tangent's determinant there; 0: not known
};

/// Cubic through the last two points and their slopes; straight on while they are one.
template <class T>
Motion<T> predicted(const PathKnot<T>& before, const PathKnot<T>& last, const T& factor) {
  const T h = last.factor - before.factor;
  if (h == T(0)) return (factor - last.factor) * last.slope;
  const Vec3<T> turn = so3::log<T>(before.joint.R * last.joint.R.transpose());
  Motion<T> back, slope = before.slope;  // before, seen from last
  back << before.joint.x - last.joint.x, turn;
  slope.template tail<3>() = so3::gamma_inverse(turn) * before.slope.template tail<3>();
  const T u = (factor - last.factor) / h;
  const Motion<T> a = h * (slope + T(2) * last.slope) + T(3) * back;
  const Motion<T> b = h * (slope + last.slope) + T(2) * back;
  return u * (h * last.slope + u * (a + u * b));
}

/// Is the error small beside the motion of its direction, or beside the rounding of the node's own pose?
/// A rotation may also be small beside displacements, seen at the joint's own length, and a displacement
/// beside rotations: what is zero by symmetry has no relative error.
/// @param reach, length  m; LoadedJoint::length
template <class T>
bool is_small(const Motion<T>& error, const Pose<T>& joint, const T& relative, const T& reach,
              const T& length) {
  const T noise = T(64) * Eigen::NumTraits<T>::epsilon();
  const T turn = so3::log<T>(joint.R).norm(), shift = joint.x.norm();
  const T seen = length > T(0) ? T(shift / length) : T(0);
  return error.template tail<3>().norm() <= relative * std::max(turn, seen) + noise &&
         error.template head<3>().norm() <= relative * std::max(shift, T(length * turn)) + noise * reach;
}

/// Load steps on the way from one load factor to another.
/// @tparam Internal  callable joint pose -> Balance<T, n>: the joint's load and tangent, axes of P_a
/// The loads act as those of LoadedJoint.
template <Kind kind, class T, class Internal>
class PathFollower {
 public:
  using System = LoadedJoint<kind, T, Internal>;

  PathFollower(const Internal& internal, const JointLoad<T>& load, const SolverOptions<T>& options,
               const Outcome<T>& from, const JointLoad<T>* held = nullptr)
      : internal_(internal), load_(load), held_(held), options_(options), out_(from) {
    out_.status = Status::converged;
    out_.iterations = out_.steps = 0;
  }

  Outcome<T> to(const T& end) {
    const T start = out_.factor;
    if (out_.sign == 0) look_at_start();
    const auto stopped = in_load_steps<T>(start, end, options_, [this](const T& factor) {
      const NewtonRun<T> run = attempt(factor);
      out_.iterations += run.corrections;
      return run;
    });
    if (stopped) out_.status = *stopped;
    return out_;
  }

 private:
  static constexpr double kCoarse =
      1e-5;  // what stalls at such an error is a state; the outcome says how good

  /// The slope and the sign where nothing has been solved for yet.
  void look_at_start() {
    System system(internal_, load_, out_.factor, out_.joint, held_);
    system.look();
    const Motion<T> slope = widened<kind, T>(system.slope());
    out_.last = {out_.factor, out_.joint, slope.allFinite() ? slope : Motion<T>::Zero()};
    out_.before = out_.last;
    out_.sign = system.sign();
  }

  /// One load step; NewtonStop::rounding says that it was taken.
  NewtonRun<T> attempt(const T& factor) {
    const Pose<T> ahead =
        displaced<kind>(out_.joint, narrowed<kind>(predicted(out_.before, out_.last, factor)));
    // The prediction, where it is near enough to be trusted.
    const T foretold = turn_between(out_.joint, ahead);
    System system(internal_, load_, factor, foretold <= options_.largest_turn ? ahead : out_.joint, held_);
    NewtonRun<T> run = newton<T>(system, options_.corrections_per_step);
    if (run.stop != NewtonStop::rounding && run.stop != NewtonStop::stalled) return run;
    const Motion<T> error = widened<kind, T>(system.error());
    const auto within = [&](const T& relative) {
      return is_small(error, system.joint(), relative, load_.reach, system.length());
    };
    const bool is_state = run.stop == NewtonStop::rounding || within(T(kCoarse));
    const bool is_ours = turn_between(out_.joint, system.joint()) <= options_.largest_turn &&
                         is_foretold(turn_between(ahead, system.joint()), foretold, options_) &&
                         (system.sign() * out_.sign >= 0 || is_near(system.joint(), error));
    run.stop = is_state && is_ours ? NewtonStop::rounding : NewtonStop::stalled;
    if (run.stop == NewtonStop::rounding) accept(factor, system, error, within(options_.accuracy));
    return run;
  }

  void accept(const T& factor, const System& system, const Motion<T>& error, bool is_accurate) {
    out_.status = is_accurate ? Status::converged : Status::inaccurate;
    out_.factor = factor;
    out_.joint = system.joint();
    out_.error = error;
    out_.residual = system.residual();
    out_.sign = system.sign();
    out_.before = out_.last;
    out_.last = {factor, out_.joint, widened<kind, T>(system.slope())};
    ++out_.steps;
  }

  /// So near to the last accepted state that a change of sign between them is a branching on the path, and
  /// not the other side of a fold.
  bool is_near(const Pose<T>& joint, const Motion<T>& error) const {
    const T turned = std::max(turn_between({}, joint), turn_between({}, out_.joint));
    const T moved = std::max(T(joint.x.norm()), T(out_.joint.x.norm()));
    return turn_between(out_.joint, joint) <=
               options_.crossing * std::min(T(1), turned) + error.template tail<3>().norm() &&
           T((joint.x - out_.joint.x).norm()) <= options_.crossing * moved + error.template head<3>().norm();
  }

  /// rad
  static T turn_between(const Pose<T>& from, const Pose<T>& to) {
    if constexpr (kind == Kind::linear) return T(0);
    return so3::log<T>(to.R * from.R.transpose()).norm();
  }

  const Internal& internal_;
  const JointLoad<T>& load_;
  const JointLoad<T>* held_;
  const SolverOptions<T>& options_;
  Outcome<T> out_;
};

}  // namespace halfway
