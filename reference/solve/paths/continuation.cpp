#include "reference/solve/paths/continuation.hpp"

#include "reference/numbers/linear_algebra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-9;      // corrections this short are mostly noise and need not contract
constexpr double kNeutral = 1e-10;      // eigenvalues this small, over the stiffness at rest, have no sign
constexpr double kGrown = 1e4;          // of the tangent over that at rest: nothing but a pole does it
constexpr double kNearHalfTurn = 1e-4;  // rad before pi at which a path that cannot go on has reached it

int sign(double x) { return x < 0 ? -1 : 1; }

/// What a path ran into that no smaller step gets over.
PathEnd named(PathEnd refused, double phi, double grown) {
  if (refused != PathEnd::jump_not_excluded && refused != PathEnd::no_convergence) return refused;
  if (phi > kPi - kNearHalfTurn) return PathEnd::half_turn;
  return grown > kGrown ? PathEnd::pole : refused;
}

}  // namespace

/// A step: where it leads, what lies on the way, and why it must not be taken.
struct Continuation::Trial {
  PathPoint point{};
  std::vector<SingularPoint> singular{};
  std::optional<PathEnd> refused{};
  std::optional<PathEnd> end{};  ///< the load factor at which the path is to end
  int iterations = 0;
  bool easy = false;  ///< the next one may be longer
};

/// A path on its way.
struct Continuation::Walk {
  EquilibriumPath path;
  double step;
};

Continuation::Continuation(const Scene& scene, const Entry& entry, double xi,
                           const ContinuationOptions& options, const Setting& setting)
    : options_(options),
      problem_(scene, entry, xi, setting),
      problem50_(scene, entry, xi, setting),
      step_(problem_, arc_scales(problem_, options.end_factor)),
      step50_(problem50_, step_.scales()) {}

PathPoint Continuation::described(const ArcState<double>& state, const ArcVector<double>& towards,
                                  double arc) const {
  const Direction<double> direction = step_.direction(state, towards);
  PathPoint out{state, arc, turn_from_rest(problem_, state.b), direction.tangent};
  out.branching_sign = sign(direction.determinant);
  out.eigenvalue = std::nan("");
  const int n = problem_.unknowns();
  for (const auto& value : eigenvalues(step_.equilibrium_rows(state).leftCols(n))) {
    if (value.imag() != 0) continue;
    out.negative += value.real() < -kNeutral;
    if (!(std::abs(out.eigenvalue) <= std::abs(value.real()))) out.eigenvalue = value.real();
  }
  const bool neutral = std::abs(out.eigenvalue) < kNeutral;
  out.stiffness_sign = neutral ? 0 : sign(direction.tangent_stiffness);
  return out;
}

std::optional<PathEnd> Continuation::looks_wrong(const PathPoint& from, const Correction<double>& correction,
                                                 const PathPoint& next, double distance) const {
  const Vec3<double> theta_from = so3::log<double>(from.state.b.R * problem_.start().R.transpose());
  const Vec3<double> theta_next = so3::log<double>(next.state.b.R * problem_.start().R.transpose());
  if ((theta_next - theta_from).norm() > kPi) return PathEnd::half_turn;
  const double angle = std::acos(std::clamp(from.tangent.dot(next.tangent), -1.0, 1.0));
  const bool smooth =
      angle <= options_.largest_angle && correction.first <= options_.largest_correction * distance &&
      (correction.first <= kRounding || correction.contraction <= options_.largest_contraction);
  if (!smooth) return PathEnd::jump_not_excluded;
  // One singular point changes one eigenvalue; two at once are two steps, or one point of higher order.
  if (std::abs(next.negative - from.negative) > 1 && next.stiffness_sign * from.stiffness_sign == 1 &&
      std::isfinite(next.eigenvalue) && std::isfinite(from.eigenvalue))
    return PathEnd::singular_beyond_simple;
  return std::nullopt;
}

/// A sign that changes must do so through a singular point that is there at 50 digits.
std::optional<PathEnd> Continuation::add_singular(Trial& trial, const PathPoint& from) const {
  const int n = problem_.unknowns();
  const bool folds = sign(trial.point.tangent[n]) != sign(from.tangent[n]);
  const bool branches = trial.point.branching_sign != from.branching_sign;
  const double distance = from.tangent.dot(step_.difference(from.state, trial.point.state));
  for (Singularity type : {Singularity::branching, Singularity::fold}) {
    if (!(type == Singularity::fold ? folds : branches)) continue;
    Located found = locate(step50_, type, from.state, from.tangent, distance, trial.point.state);
    if (found.change == SignChange::pole) return PathEnd::pole;
    if (found.change == SignChange::jump) return PathEnd::jump_not_excluded;
    if (found.change == SignChange::none) continue;
    found.point.arc = from.arc + from.tangent.dot(step_.difference(from.state, found.point.state));
    trial.singular.push_back(found.point);
  }
  std::ranges::sort(trial.singular, {}, &SingularPoint::arc);
  return std::nullopt;
}

Continuation::Trial Continuation::attempt(const PathPoint& from, double distance) const {
  const Correction<double> correction = step_.ahead(from.state, from.tangent, distance);
  Trial out;
  out.iterations = correction.iterations;
  if (!correction.finite) out.refused = PathEnd::pole;
  if (correction.finite && !correction.converged) out.refused = PathEnd::no_convergence;
  if (out.refused) return out;
  const double moved = step_.difference(from.state, correction.state).norm();
  out.point = described(correction.state, from.tangent, from.arc + moved);
  out.refused = looks_wrong(from, correction, out.point, distance);
  out.easy = correction.first <= 0.3 * options_.largest_correction * distance &&
             from.tangent.dot(out.point.tangent) >= std::cos(0.5 * options_.largest_angle);
  return out;
}

/// A step over the last load factor ends at it.
void Continuation::land(Trial& trial, const PathPoint& from) const {
  const double factor = trial.point.state.factor;
  const bool above = factor > options_.end_factor;
  const bool below = factor < options_.lowest_factor && factor < from.state.factor;
  if (!above && !below) return;
  trial.end = above ? PathEnd::end_factor : PathEnd::unloaded;
  const auto end =
      landed(from.state, trial.point.state, above ? options_.end_factor : options_.lowest_factor);
  if (!end) {
    trial.refused = PathEnd::no_convergence;
    return;
  }
  trial.point = described(*end, from.tangent, from.arc + step_.difference(from.state, *end).norm());
  std::erase_if(trial.singular, [&](const SingularPoint& s) { return s.arc > trial.point.arc; });
}

void Continuation::close(Walk& walk, PathEnd end) const {
  const PathPoint& last = walk.path.points.back();
  walk.path.end = named(end, last.phi, step_.equilibrium_rows(last.state).norm());
  walk.path.outcome = fmt::format("{} at load factor {:.6g}, phi = {:.4f} rad", to_string(walk.path.end),
                                  last.state.factor, last.phi);
}

void Continuation::take(Walk& walk, const Trial& trial) const {
  walk.path.singular.insert(walk.path.singular.end(), trial.singular.begin(), trial.singular.end());
  walk.path.points.push_back(trial.point);
  if (trial.easy) walk.step = std::min(1.5 * walk.step, options_.largest_step);
  const bool beyond = std::ranges::any_of(trial.singular, [](const auto& s) { return !s.simple; });
  if (trial.end)
    close(walk, *trial.end);
  else if (beyond)
    close(walk, PathEnd::singular_beyond_simple);
  else if (trial.point.arc > options_.largest_arc)
    close(walk, PathEnd::arc_limit);
  else if (int(walk.path.points.size()) > options_.largest_count)
    close(walk, PathEnd::step_limit);
}

EquilibriumPath Continuation::from(const ArcState<double>& start, const ArcVector<double>& towards) const {
  Walk walk{{}, options_.first_step};
  walk.path.points.push_back(described(start, towards, 0));
  if (!walk.path.points.front().tangent.allFinite()) close(walk, PathEnd::singular_start);
  while (walk.path.outcome.empty()) {
    const PathPoint& last = walk.path.points.back();
    Trial trial = attempt(last, walk.step);
    walk.path.iterations += trial.iterations;
    if (!trial.refused) trial.refused = add_singular(trial, last);
    if (!trial.refused) land(trial, last);
    if (!trial.refused) {
      take(walk, trial);
      continue;
    }
    ++walk.path.rejected;
    walk.step /= 2;
    if (walk.step < options_.smallest_step) close(walk, *trial.refused);
  }
  return std::move(walk.path);
}

EquilibriumPath Continuation::from_rest() const {
  const int n = problem_.unknowns();
  const ArcState<double> rest{problem_.initial().joint, 0};
  return from(rest, ArcVector<double>::Unit(n + 1, n));
}

}  // namespace halfway::reference
