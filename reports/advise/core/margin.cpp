// Where the advice changes: read off the errors already known for the load and the tolerance, solved again
// for the stiffness ratio.
#include "reports/advise/core/advice.hpp"

#include "reports/advise/core/ratio.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::advise {
namespace {

std::string name_of(const Advice& advice, std::optional<std::size_t> i) {
  return i ? advice.judged[*i].candidate.name(advice.truth.scene.joint.kind) : "";
}

/// Who would be chosen if the envelope were the first `rows`.
std::optional<std::size_t> chosen_at(const Advice& advice, std::size_t rows) {
  std::vector<Judged> shorter = advice.judged;
  for (Judged& j : shorter)
    j.error = j.errors.size() < rows ? std::numeric_limits<double>::infinity() : worst_of(j.errors, rows);
  return choose(shorter, advice.question.tolerance);
}

double rotation_of(const Advice& advice, std::size_t row) {
  return row < advice.answers.value.size() ? rotation_at(advice.answers, row).value_or(0) : 0;
}

/// A shorter envelope disqualifies less: what is out within the whole one stays out.
Change less_load(const Advice& advice) {
  for (std::size_t rows = advice.envelope.rows - 1; rows > 0; --rows) {
    const auto other = chosen_at(advice, rows);
    if (other != advice.choice)
      return {advice.envelope.factors[rows - 1], rotation_of(advice, rows - 1), name_of(advice, other)};
  }
  return {advice.envelope.factors.front(), rotation_of(advice, 0), "", true};
}

Change more_load(const Advice& advice) {
  const std::size_t known = advice.answers.value.size();
  for (std::size_t rows = advice.envelope.rows + 1; rows <= known; ++rows) {
    const auto other = chosen_at(advice, rows);
    if (other == advice.choice) continue;
    // The chosen one's own end where that is what changes, straight between the rows; else the row before.
    const double before = advice.envelope.factors[rows - 2];
    const Judged* chosen = advice.chosen();
    const bool ends = chosen && !chosen->reach.to_the_end && chosen->reach.factor >= before;
    return {ends ? chosen->reach.factor : before,
            ends ? chosen->reach.rotation : rotation_of(advice, rows - 2), name_of(advice, other)};
  }
  return {advice.envelope.factors[known - 1], rotation_of(advice, known - 1), "", true};
}

/// Tolerances nearer than this are one.
constexpr double kNear = 1e-2;

/// Disqualified are the same at every tolerance nearby: only errors are compared.
Change other_tolerance(const Advice& advice, bool looser) {
  std::vector<double> errors;
  for (const Judged& j : advice.judged)
    if (j.disqualified.empty() && std::isfinite(j.error)) errors.push_back(j.error);
  std::ranges::sort(errors);
  if (!looser) std::ranges::reverse(errors);
  double last = advice.question.tolerance;
  for (const double error : errors) {
    if (looser ? error <= last * (1 + kNear) : error > last) continue;
    // Just looser an error is allowed; just tighter it is not.
    const double tolerance = looser ? error : error * (1 - kNear);
    const auto other = choose(advice.judged, tolerance);
    if (other != advice.choice && tolerance < 1) return {error, 0, name_of(advice, other)};
    last = tolerance;
  }
  return {errors.empty() ? 0 : errors.back(), 0, "", true};
}

}  // namespace

Margin margin_of(const Advice& advice, const std::map<std::string, Cost>& costs) {
  Margin out;
  out.less_load = less_load(advice);
  out.more_load = more_load(advice);
  out.tighter = other_tolerance(advice, false);
  out.looser = other_tolerance(advice, true);
  add_ratio_margin(advice, costs, out);
  return out;
}

}  // namespace halfway::advise
