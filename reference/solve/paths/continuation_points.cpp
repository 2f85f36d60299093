// Points asked for on a path that was followed, and the paths that cross it.
#include "reference/solve/paths/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfway::reference {

/// The point between two successive ones at a load factor that lies between theirs.
std::optional<ArcState<double>> Continuation::landed(const ArcState<double>& from, const ArcState<double>& to,
                                                     double factor) const {
  const ArcVector<double> whole = step_.difference(from, to);
  const auto n = whole.size() - 1;
  const double target = (factor - from.factor) / step_.scales().factor;
  const ArcState<double> guess = step_.moved(from, whole * (target / whole[n]));
  const auto correction = step_.corrected(from, ArcVector<double>::Unit(n + 1, n), target, guess);
  if (!correction.converged) return std::nullopt;
  return correction.state;
}

std::vector<EquilibriumPath> Continuation::other_path(const SingularPoint& branching) const {
  std::vector<EquilibriumPath> out;
  for (double side : {1.0, -1.0}) {
    const ArcVector<double> across = side * branching.across;
    const Correction<double> aside = step_.ahead(branching.state, across, options_.first_step / 2);
    if (!aside.converged) continue;
    const ArcVector<double> way = step_.difference(branching.state, aside.state);
    const bool on_it = std::abs(way.normalized().dot(branching.tangent)) < 0.99;
    if (on_it) out.push_back(from(aside.state, way));
  }
  return out;
}

std::vector<ArcState<double>> Continuation::at_factor(const EquilibriumPath& path, double factor) const {
  // Between the points and the folds the load factor rises or falls all the way.
  std::vector<std::pair<double, ArcState<double>>> way;
  for (const PathPoint& p : path.points) way.push_back({p.arc, p.state});
  for (const SingularPoint& s : path.singular) {
    if (s.type == Singularity::fold) way.push_back({s.arc, s.state});
  }
  std::ranges::sort(way, {}, [](const auto& w) { return w.first; });
  std::vector<ArcState<double>> out;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const ArcState<double>& to = way[i].second;
    if (to.factor == factor) out.push_back(to);
    if (i == 0) continue;
    const ArcState<double>& from = way[i - 1].second;
    if ((from.factor - factor) * (to.factor - factor) >= 0) continue;
    if (const auto state = landed(from, to, factor)) out.push_back(*state);
  }
  return out;
}

const char* to_string(PathEnd end) {
  switch (end) {
    case PathEnd::end_factor:
      return "the whole load is reached";
    case PathEnd::unloaded:
      return "unloaded again";
    case PathEnd::arc_limit:
      return "the longest path allowed ends";
    case PathEnd::step_limit:
      return "the largest number of steps is used up";
    case PathEnd::half_turn:
      return "half a turn: phi reaches pi, where rotation vectors jump";
    case PathEnd::pole:
      return "the loads grow without bound: a pole of the formulation";
    case PathEnd::singular_beyond_simple:
      return "several directions become singular at once";
    case PathEnd::singular_start:
      return "the tangent is singular where the path is to start";
    case PathEnd::jump_not_excluded:
      return "the smallest step may still change to another path";
    default:
      return "Newton does not converge at the smallest step";
  }
}

}  // namespace halfway::reference
