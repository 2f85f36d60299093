#include "reports/advise/views/json.hpp"

#include "reports/advise/views/words.hpp"

#include <cmath>
#include <numbers>

namespace halfway::advise {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(); }

Json change_json(const Change& change, const char* what) {
  Json out = {{what, number(change.at)}};
  if (change.rotation > 0) out["degrees"] = change.rotation / kDegree;
  if (change.beyond)
    out["changes"] = false;
  else
    out["instead"] = change.instead.empty() ? Json() : Json(change.instead);
  return out;
}

Json judged_json(const Advice& advice, std::size_t i) {
  const Judged& j = advice.judged[i];
  const Candidate& c = j.candidate;
  Json out = {{"name", c.name(advice.truth.scene.joint.kind)},
              {"formulation", c.formulation()},
              {"kind", to_string(c.kind)},
              {"precision", c.precision},
              {"variant", c.variant},
              {"ends", c.ends}};
  if (c.entry && c.entry->needs_xi) out["xi"] = c.xi, out["xi_fitted"] = c.fitted;
  out["ns"] = j.cost.ns > 0 ? Json(j.cost.ns) : Json();
  out["spread_of_ns"] = number(j.cost.spread);
  out["flops"] = j.cost.flops > 0 ? Json(j.cost.flops) : Json();
  out[word_for_error(advice)] = number(j.error);
  out["within_to"] = {{"factor", j.reach.factor}, {"degrees", j.reach.rotation / kDegree}};
  out["suffices"] = j.suffices(advice.question.tolerance);
  out["disqualified"] = j.disqualified;
  out["by_second_order_theory"] = j.by_theory;
  out["defects"] = {{"node_order", number(j.defects.node_order)},
                    {"moment_balance", number(j.defects.balance)},
                    {"energy", number(j.defects.energy)},
                    {"spin", number(j.defects.spin)}};
  out["remark"] = remark(advice, i);
  return out;
}

Json margin_json(const Advice& advice) {
  const Margin& m = advice.margin;
  Json out = {{"less_load", change_json(m.less_load, "factor")},
              {"more_load", change_json(m.more_load, "factor")},
              {"tighter", change_json(m.tighter, "tolerance")},
              {"looser", change_json(m.looser, "tolerance")}};
  if (m.ratio > 0) {
    out["stiffness_ratio"] = m.ratio;
    out["less_ratio"] = change_json(m.less_ratio, "ratio");
    out["more_ratio"] = change_json(m.more_ratio, "ratio");
  }
  return out;
}

Json advice_of(const Advice& advice) {
  const Judged* chosen = advice.chosen();
  if (!chosen) return {{"formulation", nullptr}, {"instead", instead_of_none(advice)}};
  Json out = judged_json(advice, *advice.choice);
  out["reason"] = reason(advice);
  if (advice.plain) out["in_full_ns"] = advice.judged[*advice.plain].cost.ns;
  return out;
}

}  // namespace

Json advice_json(const Advice& advice) {
  Json out = {{"schema", "halfway-advice-1"},
              {"scene", advice.question.scene.name},
              {"title", advice.question.scene.title},
              {"tolerance", advice.question.tolerance},
              {"measure", to_string(advice.measure())},
              {"outputs", advice.truth.scene.outputs},
              {"kind", to_string(advice.truth.scene.joint.kind)}};
  out["truth"] = {{"kind", to_string(advice.truth.kind)}, {"described", advice.truth.described}};
  if (const auto known = known_to(advice)) out["truth"]["known_to"] = *known;
  out["envelope"] = {{"factor_end", advice.envelope.end()}, {"data_end_before", advice.envelope.is_cut}};
  if (advice.envelope.rows <= advice.answers.value.size())
    if (const auto rotation = rotation_at(advice.answers, advice.envelope.rows - 1))
      out["envelope"]["degrees"] = *rotation / kDegree;
  out["advice"] = advice_of(advice);
  out["margin"] = margin_json(advice);
  out["candidates"] = Json::array();
  for (std::size_t i = 0; i < advice.judged.size(); ++i) out["candidates"].push_back(judged_json(advice, i));
  return out;
}

}  // namespace halfway::advise
