#include "reports/advise/trial/trial.hpp"

#include "bench/harness/flops.hpp"
#include "reference/scene/joint/free_strains.hpp"
#include "reports/advise/core/ratio.hpp"
#include "reports/advise/trial/other_road.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace halfway::advise {
namespace {

/// What two roads to the same number differ by: paths to 1e-9 of the motion, and a chain's iteration.
constexpr double kRoads = 1e-7;

/// Load factors between those of the advice, and its end.
std::vector<double> between(const Advice& advice) {
  std::vector<double> out;
  for (const double row : advice.truth.rows)
    if (row <= advice.envelope.end()) out.push_back(row);
  if (!out.empty()) return out;
  for (const double share : {0.11, 0.37, 0.61, 0.83, 0.97, 1.}) out.push_back(share * advice.envelope.end());
  return out;
}

double error_again(const Advice& advice, const Candidate& c, const Answers& truth) {
  const Answers model = model_again(advice.truth.scene, c, truth.factor);
  if (model.value.size() < truth.factor.size()) return std::numeric_limits<double>::infinity();
  // Seven digits of a float are the kernel's own check; here it is its formulation.
  return worst_of(errors_of(model, truth, advice.measure()), truth.factor.size());
}

/// Is it out by what no error excuses? Asked once more of candidates that theory left out.
bool is_out(const Advice& advice, const Judged& j) {
  if (!j.by_theory) return !j.disqualified.empty();
  Question asked = advice.question;
  asked.scene = advice.truth.scene;
  const Answers path = follow(asked.scene, j.candidate, advice.envelope.factors);
  const Defects defects = defects_of(asked, j.candidate, path, advice.envelope.rows);
  return !disqualified(asked, j.candidate, path, advice.envelope, defects).empty();
}

std::string cheaper_of(const Advice& advice, const Answers& truth) {
  const double limit =
      advice.chosen() ? advice.chosen()->cost.ns / kSameCost : std::numeric_limits<double>::infinity();
  for (const Judged& j : advice.judged) {
    if (!(j.cost.ns > 0) || j.cost.ns >= limit) continue;
    const double error = error_again(advice, j.candidate, truth);
    if (error <= advice.question.tolerance * (1 - 1e-3) - kRoads && !is_out(advice, j))
      return j.candidate.name(advice.truth.scene.joint.kind);
  }
  return "";
}

}  // namespace

bool Tried::is_right() const { return cheaper.empty() && (advised.empty() || error <= tolerance + kRoads); }

Tried tried(int number, const std::map<std::string, Cost>& costs, const std::function<void(Advice&)>& spoil) {
  const Question question = random_question(number);
  Advice advice = advise(question, costs);
  if (spoil) spoil(advice);
  Tried out;
  out.number = number;
  out.truth = to_string(advice.truth.kind);
  out.tolerance = question.tolerance;
  out.degrees = rotation_at(advice.answers, advice.envelope.rows - 1).value_or(0) * 180 / std::numbers::pi;
  out.ratio = stiffness_ratio(advice.truth.scene).value_or(0);
  const Answers truth = truth_again(advice, between(advice));
  if (const Judged* chosen = advice.chosen()) {
    out.advised = chosen->candidate.name(advice.truth.scene.joint.kind);
    out.error = error_again(advice, chosen->candidate, truth);
  }
  out.cheaper = cheaper_of(advice, truth);
  return out;
}

std::map<std::string, Cost> trial_costs() {
  std::vector<Candidate> all;
  const auto add = [&](const reference::Scene& scene) {
    std::ranges::copy(candidates_of(scene), std::back_inserter(all));
  };
  reference::Scene scene;
  scene.outputs = {"theta_x", "theta_y", "theta_z"};
  scene.loads.resize(1);
  scene.xis = {0.4};
  for (const Kind kind : {Kind::angular, Kind::linear, Kind::linear_angular}) {
    scene.joint.kind = kind;
    scene.has_length = kind == Kind::linear_angular;
    const int n = strain_count(kind);
    scene.joint.law = reference::LinearSpec{Eigen::MatrixXd::Identity(n, n), false};
    add(scene);
  }
  return counted_costs(all);
}

nlohmann::ordered_json trial_json(const std::vector<Tried>& all) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Tried& t : all) {
    rows.push_back(
        {{"number", t.number},
         {"truth", t.truth},
         {"tolerance", t.tolerance},
         {"degrees", t.degrees},
         {"ratio", t.ratio},
         {"advised", t.advised},
         {"error", std::isfinite(t.error) ? nlohmann::ordered_json(t.error) : nlohmann::ordered_json()},
         {"cheaper", t.cheaper},
         {"right", t.is_right()}});
  }
  return {{"schema", "halfway-advice-trial-1"},
          {"right", std::ranges::count_if(all, &Tried::is_right)},
          {"of", all.size()},
          {"scenes", rows}};
}

}  // namespace halfway::advise
