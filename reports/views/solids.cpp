#include "reports/views/solids.hpp"

#include "reference/truth/coupling_fit.hpp"
#include "reference/truth/data.hpp"
#include "reference/truth/fe/studies/bearing_fit.hpp"
#include "reference/truth/fe/studies/studies.hpp"

#include <fmt/format.h>

#include <array>

namespace halfway::reports {
namespace {

namespace fe = reference::fe;
using nlohmann::json;

/// Of loaded axes; the paper's own first.
constexpr std::array<std::array<int, 2>, 3> kPairs = {{{0, 2}, {1, 2}, {0, 1}}};

json estimate(const fe::Characterisation& c, const std::string& name, const std::string& unit,
              const fe::Figure& figure) {
  const fe::Estimate e = converged(c, fe::ElementKind::hex20, figure);
  return {
      {"name", name}, {"unit", unit}, {"value", e.value}, {"uncertainty", e.uncertainty}, {"order", e.order}};
}

json compliances(const fe::Characterisation& c) {
  json out = json::array();
  for (int k = 0; k < 6; ++k) {
    out.push_back(estimate(c, fmt::format("{}_{}", k < 3 ? "linear" : "angular", k % 3 + 1),
                           k < 3 ? "m/N" : "rad/(N m)",
                           [k](const fe::SecondOrder& s) { return s.compliance(k, k); }));
  }
  return out;
}

/// xi per law, from each pair of moments and of forces, and the least-squares ones.
json xis(const fe::Characterisation& c) {
  json out = json::array();
  for (fe::SolidLaw law : fe::kLaws) {
    json row = {{"law", to_string(law)}};
    for (const auto& loads : kPairs) {
      const int i = loads[0], j = loads[1];
      const std::string pair = fmt::format("{}{}", i + 1, j + 1);
      row["moments"].push_back(
          estimate(c, pair, "", [&](const auto& s) { return xi_of_moments(s, law, i, j); }));
      row["forces"].push_back(
          estimate(c, pair, "", [&](const auto& s) { return xi_of_forces(s, law, i, j); }));
    }
    const fe::SecondOrder* finest = nullptr;
    for (const auto& run : c.runs) {
      if (run.element == fe::ElementKind::hex20) finest = &run.result;
    }
    for (auto group : reference::kCouplingGroups) {
      const auto best = best_xi(finest->couplings[std::size_t(law)], finest->compliance, group);
      row["best"].push_back({{"group", to_string(group)}, {"xi", best.xi}, {"remainder", best.remainder}});
    }
    out.push_back(row);
  }
  return out;
}

/// Accuracy against cost: each mesh's xi (of the paper's pair and each law) and compliance.
json runs(const fe::Characterisation& c) {
  json out = json::array();
  for (const auto& run : c.runs) {
    json xi;
    for (fe::SolidLaw law : fe::kLaws)
      xi[to_string(law)] = xi_of_moments(run.result, law, kPairs[0][0], kPairs[0][1]);
    json compliance = json::array();
    for (int k = 0; k < 6; ++k) compliance.push_back(run.result.compliance(k, k));
    out.push_back({{"element", to_string(run.element)},
                   {"level", run.level},
                   {"unknowns", run.unknowns},
                   {"seconds", run.seconds},
                   {"xi", xi},
                   {"compliance", compliance}});
  }
  return out;
}

/// Families and scans as kept, without the raw runs.
json bearing() {
  const auto kept = fe::kept("bearing");
  if (!kept) return json::object();
  const json printed = reference::read_data("paper/tables.json").at("table_4");
  json out = {{"printed_xi", std::stod(printed.at("fitted_xi").get<std::string>())},
              {"limit", fe::kAdmissible},
              {"families", kept->at("families")},
              {"scans", kept->at("scans")}};
  for (std::size_t i = 0; i < fe::kTable4.size(); ++i)
    out["data"].push_back({{"name", fe::kDatumNames[i]}, {"printed", fe::kTable4[i]}});
  for (json& family : out["families"]) family.erase("characterisation");
  return out;
}

}  // namespace

json solids_record() {
  json bodies = json::array(), missing = json::array();
  for (const fe::Study& study : fe::studies()) {
    if (!fe::kept(study)) missing.push_back({{"study", study.name}, {"what", study.what}});
  }
  for (const auto& c : fe::kept_characterisations()) {
    const fe::Body& body = fe::body_named(c.body);
    bodies.push_back({{"name", body.name},
                      {"title", body.title},
                      {"geometry", body.geometry},
                      {"joint_point", {c.joint_point[0], c.joint_point[1], c.joint_point[2]}},
                      {"compliances", compliances(c)},
                      {"xis", xis(c)},
                      {"runs", runs(c)}});
  }
  return {{"bodies", bodies},
          {"bearing", bearing()},
          {"calculix", fe::kept("cost_calculix").value_or(json::array())},
          {"newton", fe::kept("cost_newton").value_or(json::array())},
          {"shapes", fe::kept("shapes").value_or(json::array())},
          {"missing", missing}};
}

json solid_reference_curves() {
  json out = json::array();
  for (const auto& curve : fe::kept_curves()) {
    json rows = json::array();
    for (const auto& p : curve.points)
      rows.push_back({p.factor, p.theta[0], p.theta[1], p.theta[2], p.d[0], p.d[1], p.d[2]});
    out.push_back({{"scene", curve.scene},
                   {"formulation", fmt::format("{}, {}", curve.body, to_string(curve.law))},
                   {"source", "3D finite elements"},
                   {"columns", {"factor", "theta_x", "theta_y", "theta_z", "u_x", "u_y", "u_z"}},
                   {"rows", rows}});
  }
  return out;
}

}  // namespace halfway::reports
