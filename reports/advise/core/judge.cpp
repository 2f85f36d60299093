#include "reference/record/worst.hpp"
#include "reports/advise/core/advice.hpp"
#include "reports/advise/core/fit_xi.hpp"
#include "reports/advise/core/theory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::advise {
namespace {

/// By second-order theory the error grows with the load.
void take_theory(double error, const Answers& truth, const Question& question, const Envelope& envelope,
                 Judged& out) {
  for (const double factor : truth.factor) out.errors.push_back(error * factor / envelope.end());
  out.error = error;
  out.reach = reach_of(out.errors, truth, question.tolerance);
  out.by_theory = true;
}

/// Without a truth: how far the farthest law that may be right is from each candidate.
void take_spread(const std::vector<Answers>& paths, Measure measure, const Envelope& envelope,
                 std::vector<Judged>& judged) {
  for (std::size_t i = 0; i < judged.size(); ++i) {
    judged[i].errors.assign(paths[i].value.size(), 0);
    for (std::size_t j = 0; j < judged.size(); ++j) {
      const Candidate& other = judged[j].candidate;
      const bool may_be_right = other.entry && judged[j].disqualified.empty() &&
                                other.kind == judged[i].candidate.kind && other.precision == "double" &&
                                other.variant.empty();
      if (!may_be_right || paths[i].value.empty()) continue;
      const std::vector<double> apart = errors_of(paths[j], paths[i], measure);
      for (std::size_t row = 0; row < apart.size(); ++row)
        if (row < envelope.rows || std::isfinite(apart[row]))
          reference::keep_largest(judged[i].errors[row], apart[row]);
    }
  }
}

}  // namespace

std::vector<Judged> judge(const Question& question, const Truth& truth, const Answers& answers,
                          const Envelope& envelope, Measure measure,
                          const std::map<std::string, Cost>& costs) {
  std::vector<Judged> out;
  std::vector<Answers> paths;
  std::vector<Candidate> candidates = candidates_of(truth.scene);
  if (const auto xi = fitted_xi(truth, envelope, answers, measure)) {
    candidates.push_back({reference::find_formulation("intrinsic"), *xi, true, truth.scene.joint.kind});
  }
  Question asked = question;
  asked.scene = truth.scene;
  for (const Candidate& c : candidates) {
    Judged j;
    j.candidate = c;
    if (const auto cost = costs.find(c.timing()); cost != costs.end()) j.cost = cost->second;
    const auto theory =
        measure == Measure::norm ? second_order_error(truth, c, envelope.end()) : std::nullopt;
    if (theory && *theory > kInDoubt * question.tolerance) {
      take_theory(*theory, answers, question, envelope, j);
      paths.emplace_back();
    } else {
      paths.push_back(follow(truth.scene, c, envelope.factors));
      j.defects = defects_of(asked, c, paths.back(), envelope.rows);
      j.disqualified = disqualified(asked, c, paths.back(), envelope, j.defects);
    }
    out.push_back(std::move(j));
  }
  const bool has_truth = truth.kind != TruthKind::none;
  if (!has_truth) take_spread(paths, measure, envelope, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    Judged& j = out[i];
    if (j.by_theory) continue;
    if (has_truth) j.errors = errors_of(paths[i], answers, measure);
    j.error = j.errors.size() < envelope.rows ? std::numeric_limits<double>::infinity()
                                              : worst_of(j.errors, envelope.rows);
    j.reach = reach_of(j.errors, answers, question.tolerance);
  }
  std::ranges::stable_sort(out, {}, [](const Judged& j) {
    return j.cost.ns > 0 ? j.cost.ns : std::numeric_limits<double>::infinity();
  });
  return out;
}

std::optional<std::size_t> choose(const std::vector<Judged>& judged, double tolerance) {
  std::optional<std::size_t> best;
  double cheapest = 0;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const Judged& j = judged[i];
    if (!(j.cost.ns > 0) || !j.suffices(tolerance)) continue;
    if (!best) best = i, cheapest = j.cost.ns;
    if (j.cost.ns <= kSameCost * cheapest && j.error < kMoreExact * judged[*best].error) best = i;
  }
  return best;
}

}  // namespace halfway::advise
