#include "reports/views/stability/range.hpp"

#include "reference/scene/joint/convexity.hpp"
#include "reports/eval/eval_line.hpp"
#include "reports/views/rounded.hpp"
#include "verify/studies/limits/conditioning.hpp"
#include "verify/studies/limits/turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace halfway::reports {
namespace {

using nlohmann::json;
using reference::Crossing, reference::ErrorRow, reference::ErrorRows, reference::Gimbal,
    reference::LargeRotation, reference::ProjectionCost, reference::TurnCurve, reference::TurnPoint,
    reference::axis_name, reference::errors, reference::errors_at_bad_stiffness,
    reference::errors_over_distance, reference::errors_over_drift, reference::errors_over_phi,
    reference::errors_over_ratio, reference::gimbal_locks, reference::kTurnAxes, reference::kTurnStiffness,
    reference::large_rotation, reference::projection_cost, reference::scene_refusal, reference::turn_curve,
    reference::unwrapped_curves;
using reference::Entry;

/// An order to four decimals: what is left of a limit is no order.
json order(double x) { return std::isfinite(x) ? json(std::round(x * 1e4) / 1e4) : json(); }

json curve(const TurnCurve& c) {
  return {{"formulation", c.formulation}, {"phi", rounded(c.phi, 8)}, {"moment", rounded(c.moment, 5)}};
}

json turns(const LargeRotation& l) {
  json points = json::array(), crossings = json::array();
  for (const TurnPoint& p : l.points) {
    points.push_back({{"angle", p.angle},
                      {"moment", p.is_finite ? json(rounded(p.moment, 5)) : json()},
                      {"smallest", p.is_finite ? json(rounded(p.smallest, 5)) : json()},
                      {"condition", p.is_finite ? json(rounded(p.condition, 5)) : json()}});
  }
  for (const Crossing& c : l.crossings) {
    crossings.push_back({{"angle", c.angle},
                         {"phi", c.phi},
                         {"behaviour", c.behaviour},
                         {"jump", rounded(c.jump, 5)},
                         {"moment", rounded(c.moment, 5)},
                         {"order", order(c.order)}});
  }
  return {{"formulation", l.formulation},
          {"axis", axis_name(l.axis)},
          {"points", points},
          {"crossings", crossings}};
}

json gimbal(const Gimbal& g) {
  return {{"formulation", g.formulation},       {"sequence", g.sequence},
          {"load_order", order(g.load_order)},  {"tangent_order", order(g.tangent_order)},
          {"lost_1e6", rounded(g.lost_1e6, 3)}, {"lost_1e3", rounded(g.lost_1e3, 3)},
          {"distance", rounded(g.distance, 3)}, {"error", rounded(g.error, 3)}};
}

/// Rows of one series, which stand together, as one record.
void add_series(json& out, const ErrorRows& rows) {
  for (const ErrorRow& row : rows) {
    if (out.empty() || out.back()["what"] != row.what || out.back()["formulation"] != row.formulation) {
      out.push_back({{"what", row.what},
                     {"formulation", row.formulation},
                     {"x", json::array()},
                     {"error", json::array()},
                     {"notes", json::array()}});
    }
    out.back()["x"].push_back(rounded(row.x, 3));
    out.back()["error"].push_back(rounded(row.error, 3));
    if (!row.note.empty()) out.back()["notes"].push_back(fmt::format("{:.0e}: {}", row.x, row.note));
  }
}

ErrorRows sorted(ErrorRows rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const ErrorRow& a, const ErrorRow& b) { return a.what < b.what; });
  return rows;
}

json conditioning(const Entry& entry) {
  json out = json::array();
  for (const auto measure : {errors_over_phi, errors_over_ratio, errors_at_bad_stiffness, errors_over_drift,
                             errors_over_distance}) {
    add_series(out, sorted(errors(entry, measure)));
  }
  return out;
}

/// A request whose node b has a quaternion of length 1 + drift: empty when it is read.
std::string eval_refusal(double drift) {
  const Entry& entry = reference::formulations().front();
  const json node = {{"x", {0, 0, 0}}, {"q", {1 + drift, 0, 0, 0}}},
             rest = {{"x", {0, 0, 0}}, {"q", {1, 0, 0, 0}}};
  json request = {{"formulation", entry.name},
                  {"kind", "angular"},
                  {"law", {{"type", "linear"}, {"K", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}},
                  {"a", rest},
                  {"b", node}};
  if (entry.needs_xi) request["xi"] = entry.probe_xi;
  const json answer = json::parse(eval_line(request.dump()));
  if (!answer.contains("error")) return "";
  const json& error = answer.at("error");
  return fmt::format("{}: {}", error.at("code").get<std::string>(), error.at("message").get<std::string>());
}

/// Energies that are convex up to a rotation alone, of the joint that is turned; asked for twice that
/// rotation about its first axis.
json convexity() {
  json out = json::array();
  for (const Entry& entry : reference::formulations()) {
    const double radius = reference::convex_radius(entry, reference::turn_joint(entry));
    if (!std::isfinite(radius)) continue;
    const json origin = {0, 0, 0};
    json request = {{"formulation", entry.name},
                    {"kind", "angular"},
                    {"law", {{"type", "linear"}, {"K", kTurnStiffness}}},
                    {"a", {{"x", origin}, {"q", {1, 0, 0, 0}}}},
                    {"b", {{"x", origin}, {"q", {std::cos(radius), std::sin(radius), 0, 0}}}}};
    if (entry.needs_length) request["length"] = entry.probe.length;
    const json answer = json::parse(eval_line(request.dump()));
    out.push_back({{"formulation", entry.name},
                   {"radius", rounded(radius, 5)},
                   {"says", answer.contains("error") ? answer["error"]["message"] : json("")}});
  }
  return out;
}

json refusals() {
  Mat3<double> indefinite, singular;
  indefinite << 1, 2, 0, 2, 1, 0, 0, 0, 1;
  singular << 1, 1, 0, 1, 1, 0, 0, 0, 1;
  json out = {{{"what", "indefinite stiffness"}, {"who", "scenes"}, {"says", scene_refusal(indefinite)}},
              {{"what", "singular stiffness"}, {"who", "scenes"}, {"says", scene_refusal(singular)}}};
  for (int decade = -12; decade <= -1; ++decade) {  // the smallest drift that is refused
    const std::string says = eval_refusal(std::pow(10., decade));
    if (says.empty()) continue;
    out.push_back(
        {{"what", fmt::format("quaternion too long by 1e{}", decade)}, {"who", "eval"}, {"says", says}});
    break;
  }
  return out;
}

}  // namespace

json stability_range_record() {
  json out = {{"stiffness", kTurnStiffness},     {"curves", json::array()},
              {"unwrapped", json::array()},      {"gimbal", json::array()},
              {"large_rotation", json::array()}, {"conditioning", json::array()},
              {"refusals", refusals()},          {"convexity", convexity()}};
  for (const Entry& entry : reference::formulations()) {
    out["curves"].push_back(curve(turn_curve(entry)));
    for (const int axis : kTurnAxes) out["large_rotation"].push_back(turns(large_rotation(entry, axis)));
    for (const Gimbal& g : gimbal_locks(entry)) out["gimbal"].push_back(gimbal(g));
    for (const json& series : conditioning(entry)) out["conditioning"].push_back(series);
  }
  for (const TurnCurve& c : unwrapped_curves()) out["unwrapped"].push_back(curve(c));
  const ProjectionCost cost = projection_cost();
  out["projection"] = {{"quaternion", cost.quaternion.flops()}, {"polar", cost.polar.flops()}};
  return out;
}

}  // namespace halfway::reports
