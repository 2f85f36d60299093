#include "reports/views/cheapest.hpp"

#include "reference/record/worst.hpp"
#include "reports/advise/core/advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace halfway::reports {
namespace {

using advise::Advice, advise::Candidate, advise::Judged;
using bench::Timing;
using Costs = std::map<std::string, advise::Cost>;

constexpr double kTolerances[] = {1e-2, 1e-4, 1e-8};

/// Kernels' loads and analytic tangent of one joint, as they were timed for this report; the linear analysis
/// now.
Costs costs_of(const std::vector<Timing>& timings) {
  Costs out;
  for (const Timing& t : timings) {
    if (!t.wrong && t.ns > 0) out[t.name] = {t.ns, t.spread, t.error, t.flops};
  }
  for (const Kind kind : {Kind::angular, Kind::linear, Kind::linear_angular}) {
    const Candidate linear{nullptr, 0.5, false, kind};
    out[linear.timing()] = advise::linear_cost(kind);
  }
  return out;
}

/// The formulation of the truth by its kernel in double, every digit and end.
const Judged* most_exact(const Advice& advice) {
  const bool symmetric = advice.truth.described.starts_with("invariant");
  for (const Judged& j : advice.judged) {
    const Candidate& c = j.candidate;
    if (c.formulation() == (symmetric ? "invariant" : "intrinsic") &&
        c.kind == advice.truth.scene.joint.kind && c.precision == "double" && c.variant.empty() && c.ends &&
        j.cost.ns > 0 && j.disqualified.empty())
      return &j;
  }
  return nullptr;
}

/// Flops of the same formulation where every kind of load is needed, less these.
double flops_saved(const Judged& chosen, const Costs& costs) {
  Candidate whole = chosen.candidate;
  whole.kind = Kind::linear_angular, whole.precision = "double", whole.variant = "", whole.ends = true;
  const auto found = costs.find(whole.timing());
  if (found == costs.end() || !(found->second.flops > 0) || !(chosen.cost.flops > 0)) return 0;
  return std::max(found->second.flops - chosen.cost.flops, 0.);
}

std::string note_of(const Advice& advice) {
  std::set<std::string> ended;
  for (const Judged& j : advice.judged)
    if (j.disqualified.starts_with("ends")) ended.insert(j.candidate.name(advice.truth.scene.joint.kind));
  std::string note = "truth: " + advice.truth.described;
  if (!ended.empty()) note += fmt::format("; do not reach the end: {}", fmt::join(ended, ", "));
  return note;
}

nlohmann::json row(const Advice& advice, const Costs& costs) {
  const double tolerance = advice.question.tolerance;
  nlohmann::json json = {{"scene", advice.question.scene.name},
                         {"tolerance", tolerance},
                         {"kind", to_string(advice.truth.scene.joint.kind)}};
  std::string note = note_of(advice);
  const Judged* chosen = advice.chosen();
  if (chosen == nullptr) {
    json["formulation"] = "";
    json["note"] = fmt::format("none of {} candidates meets {:g}; {}", advice.judged.size(), tolerance, note);
    return json;
  }
  const Candidate& c = chosen->candidate;
  if (c.entry && c.entry->needs_xi) note += fmt::format("; chosen with xi = {}", c.xi);
  if (c.precision == "float")
    note += "; float: node a is the identity here, elsewhere rounded poses add 6e-8 rad";
  if (!c.entry) note += "; the linear analysis: loads alone, its tangent is one matrix";
  const Judged* exact = most_exact(advice);
  // At least what rounding leaves of the truth.
  const double error = reference::larger(chosen->error, std::numeric_limits<double>::epsilon() / 2);
  json["kind"] = to_string(c.kind);
  json.update({{"formulation", c.formulation()},
               {"implementation", "kernel"},
               {"precision", c.precision},
               {"variant", c.ends ? c.variant : "no_ends"},
               {"method", "analytic"},
               {"error", error},
               {"margin", tolerance / error},
               {"ns", chosen->cost.ns},
               {"relative_cost", exact ? nlohmann::json(chosen->cost.ns / exact->cost.ns) : nlohmann::json()},
               {"flops", chosen->cost.flops},
               {"flops_saved", flops_saved(*chosen, costs)},
               {"note", note}});
  return json;
}

/// What `halfway advise --truth form` answers, with the costs of the report; the truth is solved once.
nlohmann::json rows_of(const reference::Scene& scene, const Costs& costs) {
  nlohmann::json rows = nlohmann::json::array();
  Advice advice{{scene, kTolerances[0], "form"}, advise::form_truth(scene)};
  advice.envelope = advise::envelope_of(advice.question, advice.truth);
  advice.answers = advise::leading(advice.truth, advice.envelope.factors);
  for (const double tolerance : kTolerances) {
    advice.question.tolerance = tolerance;
    advise::answer(advice, costs);
    rows.push_back(row(advice, costs));
  }
  return rows;
}

}  // namespace

nlohmann::json cheapest(const Results& results) {
  nlohmann::json rows = nlohmann::json::array();
  if (results.timings.empty()) return rows;
  const Costs costs = costs_of(results.timings);
  for (const reference::Scene& scene : reference::canonical_scenes()) {
    const bool wanted =
        std::ranges::any_of(results.scenes, [&](const SceneInfo& info) { return info.name == scene.name; });
    if (!wanted) continue;
    for (nlohmann::json& one : rows_of(scene, costs)) rows.push_back(std::move(one));
  }
  return rows;
}

}  // namespace halfway::reports
