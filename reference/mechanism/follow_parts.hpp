// What follow.hpp declares; included by the units of its scalars alone.
#pragma once

#include "reference/mechanism/follow.hpp"
#include "reference/record/worst.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reference::mechanism {

/// Multipliers of a load or a motion on the stage that ends at step k: 0 is the one before the path.
template <class T>
Line<T> line_of(const Factors& factors, bool is_held, int k) {
  if (is_held) return k == 0 ? Line<T>{T(0), T(1)} : Line<T>{T(1), T(0)};
  if (k == 0) return {};
  if (factors.empty()) return {T(0), T(1)};
  const T before(k == 1 ? 0.0 : factors[std::size_t(k - 2)]), after(factors[std::size_t(k - 1)]);
  return {before - T(k - 1) * (after - before), after - before};
}

/// @param k  0 before the path, 1 ... the steps, or 1 alone
template <class T>
Stage<T> stage_of(const MechanismScene& scene, int k) {
  Stage<T> out;
  if (k > 0) out.begin = T(k - 1), out.end = scene.steps > 0 ? T(k) : T(scene.factor_end);
  for (const BodyLoad& load : scene.loads) out.loads.push_back(line_of<T>(load.factors, load.held, k));
  for (const SceneMotion& motion : scene.motions) out.motions.push_back(line_of<T>(motion.factors, false, k));
  if (k == 0) out.holding = {T(1), T(-1)};
  return out;
}

template <class T>
Matrix<double> as_double(const Matrix<T>& m) {
  return m.template cast<double>();
}

template <class T>
Follower<T>::Follower(const Model<T>& model) : model_(model) {
  const std::size_t bodies = model.bodies().size();
  reached_.state = {Poses<T>(bodies), Vector<T>::Zero(model.prescribed())};
  reached_.error = Vector<T>::Zero(model.unknowns() + model.prescribed());
  reached_.last = reached_.before = std::vector<PathKnot<T>>(bodies);
  reached_.exerted_slope = Vector<T>::Zero(model.prescribed());
  resting_ = internal(model, reached_.state.at).load;
  stage_ = stage_of<T>(model.scene(), 0);
  settle_holds();
  if (!floats_.empty()) return;
  const auto is_held = [](const BodyLoad& load) { return load.held; };
  if (!resting_.isZero(T(0)) || std::ranges::any_of(model.scene().loads, is_held)) {
    look_at_start();
    const Reached<T> initial = follow(reached_, stage_, T(1));
    held_reached_ = initial.factor;
    reached_ = initial;
    reached_.factor = T(0);
  }
  enter(stage_of<T>(model.scene(), 1));
}

template <class T>
void Follower<T>::enter(const Stage<T>& stage) {
  stage_ = stage;
  look_at_start();
}

/// On a new stage the path has another slope.
template <class T>
void Follower<T>::look_at_start() {
  const Equations<T> here = equations();
  Vector<T> slope = here.slope();
  if (!slope.allFinite()) slope.setZero();
  for (std::size_t i = 0; i < reached_.last.size(); ++i)
    reached_.last[i] = {stage_.begin, reached_.state.at[i], model_.of_body(slope, model_.bodies()[i])};
  reached_.before = reached_.last;
  reached_.exerted_slope = slope.tail(model_.prescribed());
  reached_.sign = here.sign();
}

template <class T>
void Follower<T>::settle_holds() {
  if constexpr (std::is_same_v<T, double>) {
    const auto& at = reached_.state.at;
    const Stage<T> path = stage_of<T>(model_.scene(), 1);
    const auto multipliers = [&](const Stage<T>& stage) {
      std::vector<T> out;
      for (const Line<T>& line : stage.loads) out.push_back(line.at_zero + line.rate);
      return out;
    };
    const Internal<T> inside = internal(model_, at), held = external(model_, at, multipliers(stage_));
    const Internal<T> full = external(model_, at, multipliers(path));
    Equations<T> equations(model_, stage_, resting_, holds_, T(0), reached_.state);
    equations.look();
    const Matrix<T>& G = equations.held_directions();
    holds_.c = Matrix<T>(model_.unknowns(), 0);
    const auto floats = [&](const FreeDirections& free, const Vector<T>& load) {
      for (int i = 0; i < free.motion.cols(); ++i) {
        if (!works_on(load, free.motion.col(i))) continue;
        floats_ = fmt::format("a load works on a direction without stiffness, {}: nothing balances it there",
                              named_direction(model_, free, i));
        return true;
      }
      return false;
    };
    // Held loads meet the joints alone; what grows after them meets the stiffness that they give.
    const FreeDirections free = free_directions(model_, inside.tangent, G);
    if (free.hold.cols() == 0 || floats(free, held.load)) return;
    const FreeDirections still = free_directions(model_, inside.tangent - held.tangent, G);
    if (still.hold.cols() == 0 || floats(still, full.load - held.load)) return;
    holds_.c = free_directions(model_, inside.tangent - full.tangent, G).hold;
  } else {
    const Model<double> model(model_.scene(), model_.entry(), model_.joints().front().spec.xi);
    const Follower<double> follower(model);
    floats_ = follower.floats();
    holds_.c = follower.holds().template cast<T>();
  }
}

template <class T>
bool Follower<T>::is_held_by_nothing() const {
  return holds_.c.cols() > 0 && !(reached_.carried <= T(1e-9));
}

template <class T>
T Follower<T>::largest_turn(const Poses<T>& from, const Poses<T>& to) const {
  T out(0);
  for (std::size_t i = 0; i < from.size(); ++i)
    keep_largest(out, T(so3::log<T>(Mat3<T>(to[i].R * from[i].R.transpose())).norm()));
  return out;
}

template <class T>
State<T> Follower<T>::ahead_of(const Reached<T>& from, const T& factor) const {
  State<T> ahead = from.state;
  for (std::size_t i = 0; i < ahead.at.size(); ++i)
    ahead.at[i] =
        displaced<Kind::linear_angular, T>(from.state.at[i], predicted(from.before[i], from.last[i], factor));
  ahead.exerted += (factor - from.factor) * from.exerted_slope;
  return ahead;
}

/// So near that a change of sign on the way is a branching on the path, and not the other side of a fold.
template <class T>
bool Follower<T>::is_near(const Reached<T>& from, const State<T>& found, const Vector<T>& error,
                          const Moved<T>& moved) const {
  T shift(0), turn_error(0), shift_error(0);
  for (std::size_t i = 0; i < from.state.at.size(); ++i) {
    const Vec6<T> own = model_.of_body(error, model_.bodies()[i]);
    keep_largest(turn_error, T(own.template tail<3>().norm()));
    keep_largest(shift_error, T(own.template head<3>().norm()));
    keep_largest(shift, T((found.at[i].x - from.state.at[i].x).norm()));
  }
  const T share = SolverOptions<T>{}.crossing;
  return largest_turn(from.state.at, found.at) <= share * std::min(T(1), moved.turn) + turn_error &&
         shift <= share * moved.shift + shift_error;
}

/// Newton's method ends within rounding as it is estimated, direction by direction; beside stiff directions
/// that is wide, and one more correction gets to what double holds.
template <class T>
NewtonRun<T> corrected(Equations<T>& system, int most_corrections) {
  NewtonRun<T> run = newton<T>(system, most_corrections);
  if (run.stop != NewtonStop::rounding) return run;
  system.move();
  const NewtonLook<T> look = system.look();
  ++run.corrections;
  if (!look.is_rounding && !look.may_be_rounding) run.stop = NewtonStop::stalled;
  return run;
}

template <class T>
Moved<T> moved_until(Moved<T> moved, const Poses<T>& at) {
  for (const Pose<T>& pose : at) {
    keep_largest(moved.turn, T(so3::log<T>(pose.R).norm()));
    keep_largest(moved.shift, T(pose.x.norm()));
  }
  return moved;
}

/// Is the estimated error small beside what the bodies have moved on their way, or beside rounding of it?
/// Displacements count beside rotations at the mechanism's own length: what is zero by symmetry has no
/// relative error, and neither has what comes back to where it was.
template <class T>
bool is_within(const Model<T>& model, const Equations<T>& system, const Vector<T>& error,
               const Moved<T>& moved, const T& relative) {
  T turn = moved.turn, shift = moved.shift, turn_error(0), shift_error(0), reach(0);
  for (std::size_t i = 0; i < model.bodies().size(); ++i) {
    const Vec6<T> own = model.of_body(error, model.bodies()[i]);
    keep_largest(turn_error, T(own.template tail<3>().norm()));
    keep_largest(shift_error, T(own.template head<3>().norm()));
    keep_largest(reach, T(model.bodies()[i].point.norm()));
  }
  const T noise = T(64) * Eigen::NumTraits<T>::epsilon(), length = system.length();
  const T seen = length > T(0) ? T(shift / length) : T(0);
  return turn_error <= relative * std::max(turn, seen) + noise &&
         shift_error <= relative * std::max(shift, T(length * turn)) + noise * reach;
}

template <class T>
NewtonRun<T> Follower<T>::attempt(Reached<T>& out, const Stage<T>& stage, const T& factor) const {
  constexpr double kCoarse = 1e-5;  // as of one joint
  const SolverOptions<T> options;
  const State<T> ahead = ahead_of(out, factor);
  // The prediction, where it is near enough to be trusted.
  const T foretold = largest_turn(out.state.at, ahead.at);
  Equations<T> system(model_, stage, resting_, holds_, factor,
                      foretold <= options.largest_turn ? ahead : out.state);
  NewtonRun<T> run = corrected(system, options.corrections_per_step);
  out.iterations += run.corrections;
  if (run.stop != NewtonStop::rounding && run.stop != NewtonStop::stalled) return run;
  const Vector<T> error = system.error();
  const Moved<T> moved = moved_until(out.moved, system.state().at);
  const auto within = [&](const T& relative) { return is_within(model_, system, error, moved, relative); };
  const bool is_state = run.stop == NewtonStop::rounding || within(T(kCoarse));
  const bool is_ours = largest_turn(out.state.at, system.state().at) <= options.largest_turn &&
                       is_foretold(largest_turn(ahead.at, system.state().at), foretold, options) &&
                       (system.sign() * out.sign >= 0 || is_near(out, system.state(), error, moved));
  run.stop = is_state && is_ours ? NewtonStop::rounding : NewtonStop::stalled;
  if (run.stop != NewtonStop::rounding) return run;
  out.status = within(options.accuracy) ? Status::converged : Status::inaccurate;
  out.factor = factor;
  out.moved = moved;
  out.state = system.state();
  out.error = error;
  out.residual = system.residual();
  out.sign = system.sign();
  out.carried = system.carried_by_holds();
  out.before = out.last;
  const Vector<T> slope = system.slope();
  for (std::size_t i = 0; i < out.last.size(); ++i)
    out.last[i] = {factor, out.state.at[i], model_.of_body(slope, model_.bodies()[i])};
  out.exerted_slope = slope.tail(model_.prescribed());
  ++out.steps;
  return run;
}

template <class T>
Reached<T> Follower<T>::follow(const Reached<T>& from, const Stage<T>& stage, const T& to) const {
  Reached<T> out = from;
  const auto stopped = in_load_steps<T>(from.factor, to, SolverOptions<T>{},
                                        [&](const T& factor) { return attempt(out, stage, factor); });
  if (stopped) out.status = *stopped;
  return out;
}

template <class T>
const Reached<T>& Follower<T>::advance(const T& factor) {
  if (!floats_.empty()) reached_.status = Status::singular_tangent;
  if (!floats_.empty() || held_reached_ < T(1)) return reached_;
  const int steps = model_.scene().steps;
  for (;;) {
    const T to = steps > 0 && stage_.end < factor ? stage_.end : factor;
    reached_ = follow(reached_, stage_, to);
    if (reached_.factor < to || !(to < factor)) return reached_;
    enter(stage_of<T>(model_.scene(), int(double(to)) + 1));
  }
}

template <class T>
Equations<T> Follower<T>::equations() const {
  Equations<T> out(model_, stage_, resting_, holds_, reached_.factor, reached_.state);
  out.look();
  return out;
}

template <class T>
int Follower<T>::sign_at(const T& factor) const {
  Follower there = *this;  // it may have to enter the next step
  const Reached<T>& reached = there.advance(factor);
  return reached.factor == factor ? reached.sign : 0;
}

}  // namespace halfway::reference::mechanism
