#include "reference/solve/paths/singular.hpp"

#include "reference/numbers/linear_algebra.hpp"
#include "reference/numbers/zeros.hpp"
#include "reference/record/worst.hpp"
#include "reference/solve/paths/branching.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

ArcVector<Real50> widened(const ArcVector<double>& v) { return v.cast<Real50>(); }
ArcVector<double> narrowed(const ArcVector<Real50>& v) { return v.cast<double>(); }

ArcState<double> narrowed(const ArcState<Real50>& s) { return {cast<double>(s.b), double(s.factor)}; }
ArcState<Real50> widened(const ArcState<double>& s) {
  // Double rotations are orthonormal to 1e-16 only; the path is followed in exact ones.
  const Mat3<Real50> R = so3::exp<Real50>(so3::log<Real50>(s.b.R.cast<Real50>()));
  return {{s.b.x.cast<Real50>(), R}, Real50(s.factor)};
}

/// A point of the path at a distance, with the function whose zero is looked for.
struct Trial {
  Real50 distance{0};
  ArcState<Real50> state{};
  ArcVector<double> tangent{};
  Real50 value{0};
  bool converged = false;
};

class Search {
 public:
  Search(const ContinuationStep<Real50>& step, Singularity type, const ArcState<double>& base,
         const ArcVector<double>& tangent)
      : step_(step), type_(type), base_(widened(base)), tangent_(widened(tangent)) {}

  Trial at(const Real50& distance, const ArcState<Real50>& start) const {
    const Correction<Real50> corrected = step_.corrected(base_, tangent_, distance, start);
    Trial out{distance, corrected.state, {}, Real50(0), corrected.converged};
    if (!out.converged) return out;
    const Direction<Real50> direction = step_.direction(out.state, tangent_);
    out.tangent = narrowed(direction.tangent);
    out.value =
        type_ == Singularity::fold ? direction.tangent[direction.tangent.size() - 1] : direction.determinant;
    using std::isfinite;
    out.converged = isfinite(out.value);
    return out;
  }

  Trial at(const Real50& distance, const Trial& near) const {
    return at(distance, step_.moved(near.state, ArcVector<Real50>((distance - near.distance) * tangent_)));
  }
  Trial at_base() const { return at(Real50(0), base_); }

 private:
  const ContinuationStep<Real50>& step_;
  Singularity type_;
  ArcState<Real50> base_;
  ArcVector<Real50> tangent_;
};

double change(const Trial& a, const Trial& b, const EquilibriumProblem<Real50>& problem) {
  const double factor = double(abs(a.state.factor - b.state.factor)) / std::abs(double(b.state.factor));
  return larger(factor, double(abs(turn_from_rest(problem, a.state.b) - turn_from_rest(problem, b.state.b))));
}

/// The direction that is singular beside the tangent, and whether there is a third.
void complete_branching(const ContinuationStep<Real50>& step, const ArcState<Real50>& at,
                        SingularPoint& point) {
  constexpr double kRegular = 1e-6;  // singular values are of the order of one in the path's scales
  const SingularValues s = singular_values(step.equilibrium_rows(at).cast<double>());
  const Eigen::Index n = s.values.size();
  point.simple = n < 3 || s.values[n - 3] > kRegular;
  ArcVector<double> best = ArcVector<double>::Zero(n);
  for (Eigen::Index k : {n - 1, n - 2}) {
    const ArcVector<double> rest = s.v.col(k) - point.tangent.dot(s.v.col(k)) * point.tangent;
    if (rest.norm() > best.norm()) best = rest;
  }
  point.across = best.normalized();
}

SingularPoint described(const ContinuationStep<Real50>& step, Singularity type, const ArcState<Real50>& state,
                        const ArcVector<double>& tangent, double located_to) {
  SingularPoint out;
  out.type = type;
  out.state = narrowed(state);
  out.phi = double(turn_from_rest(step.problem(), state.b));
  out.located_to = located_to;
  out.tangent = tangent;
  if (type == Singularity::branching) complete_branching(step, state, out);
  return out;
}

/// The branching between two points: crossed, where rounding alone parts its paths; else they turn off before
/// it and the two points lie on different ones. Nothing where there is none.
std::optional<Located> branching_between(const ContinuationStep<Real50>& step, const Trial& base,
                                         const Trial& end, const ArcVector<Real50>& tangent) {
  const Real50 share = base.value / (base.value - end.value);
  const ArcVector<Real50> way = step.difference(base.state, end.state);
  const auto found = defined_branching(step, step.moved(base.state, ArcVector<Real50>(share * way)));
  if (!found) return std::nullopt;
  const ArcVector<Real50> gone = step.difference(base.state, found->state);
  const Real50 along = tangent.dot(gone), aside = (gone - along * tangent).norm();
  const bool between = along >= Real50(0) && along <= end.distance && aside <= end.distance / Real50(4);
  if (!between) return std::nullopt;
  if (!(found->defect <= found->rounding)) return Located{SignChange::jump, {}};
  const ArcVector<double> towards = narrowed(way);
  const auto& [one, other] = found->tangents;
  const ArcVector<double> own = std::abs(one.dot(towards)) > std::abs(other.dot(towards)) ? one : other;
  SingularPoint out = described(step, Singularity::branching, found->state,
                                own.dot(towards) < 0 ? ArcVector<double>(-own) : own, found->change);
  out.defect = found->defect;
  return Located{SignChange::zero, out};
}

}  // namespace

const char* to_string(Singularity singularity) {
  return singularity == Singularity::fold ? "fold" : "branching";
}

Located locate(const ContinuationStep<Real50>& step, Singularity type, const ArcState<double>& base,
               const ArcVector<double>& tangent, double distance, const ArcState<double>& end) {
  constexpr int kTrials = 60;
  constexpr double kSamePoint = 1e-9;  // double against 50 digits at one point of one path
  const Real50 close(1e-24 * distance), gone(1e-12);
  const Search search(step, type, base, tangent);
  Bracket bracket(search.at_base(), search.at(Real50(distance), widened(end)));
  if (!bracket.low().converged || !bracket.high().converged) return {};
  if (narrowed(step.difference(bracket.high().state, widened(end))).norm() > kSamePoint) return {};
  if (!opposite(bracket.low().value, bracket.high().value)) return {SignChange::none, {}};
  if (type == Singularity::branching) {
    const auto found = branching_between(step, bracket.low(), bracket.high(), widened(tangent));
    if (found) return *found;
  }
  // A load factor that stays the same along a whole path turns back nowhere.
  const Real50 least(type == Singularity::fold ? 1e-12 : 0);
  const Real50 highest = larger<Real50>(abs(bracket.low().value), abs(bracket.high().value));
  if (highest < least) return {SignChange::none, {}};
  Trial before = bracket.low();
  for (int i = 0; i < kTrials; ++i) {
    const Real50 guess = bracket.guess();
    const Trial trial = search.at(guess, bracket.nearer(guess));
    if (!trial.converged) return {};
    const bool settled = abs(trial.distance - before.distance) < close || trial.value == Real50(0);
    if (settled && abs(trial.value) <= gone * highest)
      return {SignChange::zero,
              described(step, type, trial.state, trial.tangent, change(before, trial, step.problem()))};
    if (settled) break;
    bracket.narrow(trial);
    before = trial;
  }
  return {abs(before.value) > highest ? SignChange::pole : SignChange::jump, {}};
}

}  // namespace halfway::reference
