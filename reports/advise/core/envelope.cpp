#include "reports/advise/core/question.hpp"
#include "reports/advise/model/candidate.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::advise {
namespace {

constexpr int kRows = 24;   // errors are smooth in the load: the worst of a path is near its end
constexpr int kBeyond = 8;  // rows of the same spacing, by a third of the envelope
constexpr double kDegree = std::numbers::pi / 180;

std::optional<double> turned(const Truth& truth, double factor) {
  const Answers answers = leading(truth, {factor});
  return answers.value.empty() ? std::nullopt : rotation_at(answers, 0);
}

/// The load factor at which it has turned by `goal` rad: rotations grow with the load until they pass half a
/// turn. The last of data that end before.
double factor_of(const Question& question, const Truth& truth, double goal) {
  const auto refuse = [&](const std::string& why) {
    throw reports::BadInput(
        fmt::format("--degrees {:g}: scene {}: {}", goal / kDegree, question.scene.name, why));
  };
  double low = 0, high = std::min(question.scene.factor_end, truth.last());
  const auto first = turned(truth, high);
  if (!first) refuse("its outputs are not all of theta_x, theta_y, theta_z, or its path ends early");
  if (*first == 0) refuse("nothing turns");
  for (int grown = 0; grown < 60 && turned(truth, high).value_or(0) < goal; ++grown) {
    if (high == truth.last()) return high;
    const double at = turned(truth, high).value_or(0);
    if (!(at > 0.5 * *first)) refuse("no load in this direction turns it so far");
    low = high, high = std::min(high * std::clamp(1.05 * goal / at, 1.01, 2.), truth.last());
  }
  for (int halved = 0; halved < 60 && high - low > 1e-13 * high; ++halved) {
    const double middle = (low + high) / 2;
    (turned(truth, middle).value_or(goal) < goal ? low : high) = middle;
  }
  if (!(std::abs(turned(truth, high).value_or(0) - goal) < 1e-6))
    refuse("no load in this direction turns it so far");
  return high;
}

/// Of a table its own rows: those up to the load or the rotation asked for.
Envelope of_rows(const Question& question, const Truth& truth) {
  Envelope out{truth.rows};
  const Answers answers = truth.at(truth.rows);
  const double goal = question.degrees.value_or(0) * kDegree;
  for (std::size_t i = 0; i < truth.rows.size(); ++i) {
    const bool inside = question.degrees ? rotation_at(answers, i).value_or(0) <= goal
                                         : truth.rows[i] <= question.scene.factor_end * (1 + 1e-9);
    if (inside) out.rows = i + 1;
  }
  if (out.rows == 0)
    throw reports::BadInput(
        fmt::format("scene {}: the first row of its truth, load factor {:g}, lies beyond what is asked",
                    question.scene.name, truth.rows.front()));
  const double last = rotation_at(answers, truth.rows.size() - 1).value_or(0);
  out.is_cut = question.degrees ? last < goal : truth.rows.back() < question.scene.factor_end * (1 - 1e-9);
  return out;
}

}  // namespace

Answers leading(const Truth& truth, const std::vector<double>& factors) {
  if (truth.at) return truth.at(factors);
  return follow(truth.scene, {reference::find_formulation("invariant"), 0.5, false, truth.scene.joint.kind},
                factors);
}

Envelope envelope_of(const Question& question, const Truth& truth) {
  if (!truth.is_smooth) return of_rows(question, truth);
  const double asked =
      question.degrees ? factor_of(question, truth, *question.degrees * kDegree) : question.scene.factor_end;
  Envelope out;
  // Below the first row of data small outputs are small differences: what they would be is not known.
  const double first = truth.rows.empty() ? 0 : truth.rows.front();
  const double end = std::max(std::min(asked, truth.last()), first);
  for (int i = 1; i <= kRows + kBeyond; ++i) {
    const double factor = i == kRows ? end : end * i / kRows;
    if (factor < first || (i > kRows && factor > truth.last())) continue;
    out.factors.push_back(factor);
    if (i <= kRows) out.rows = out.factors.size();
  }
  out.is_cut = question.degrees ? turned(truth, end).value_or(0) < *question.degrees * kDegree * (1 - 1e-6)
                                : end < asked * (1 - 1e-9);
  return out;
}

}  // namespace halfway::advise
