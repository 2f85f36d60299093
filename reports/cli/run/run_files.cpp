#include "reports/cli/run/run_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace halfway::reports {
namespace {

bool has_free_xi(const reference::Curve& curve) {
  const auto* entry = reference::find_formulation(curve.formulation);
  return entry && entry->needs_xi;
}

nlohmann::ordered_json critical_json(const reference::SceneHead& scene, const reference::Curve& curve) {
  if (!curve.critical) return nullptr;
  return {{"axis", scene.critical_axis},
          {"moment", double(curve.critical->moment)},
          {"angle", double(curve.critical->angle)}};
}

/// The linear analysis knows no critical state: it is not asked.
std::string critical_cells(const reference::Curve& curve) {
  if (curve.critical)
    return fmt::format(" {:>15.9g} {:>15.9g}", double(curve.critical->moment), double(curve.critical->angle));
  const char* none = curve.formulation == reference::kLinearized ? "-" : "none";
  return fmt::format(" {:>15} {:>15}", none, none);
}

}  // namespace

std::string curve_label(const reference::Curve& curve) {
  return has_free_xi(curve) ? fmt::format("{} xi={:g}", curve.formulation, curve.xi) : curve.formulation;
}

std::string xi_text(const reference::Curve& curve) {
  return has_free_xi(curve) ? fmt::format("{:.17g}", curve.xi) : "";
}

std::string curves_csv(const std::vector<reference::Curve>& curves) {
  if (curves.empty()) return "";
  std::string out = fmt::format("formulation,xi,{},error,outcome\n", fmt::join(curves.front().columns, ","));
  for (const auto& curve : curves) {
    for (std::size_t i = 0; i < curve.rows.size(); ++i) {
      const std::string error = i < curve.errors.size() ? fmt::format("{:.2g}", curve.errors[i]) : "";
      const bool is_last = i + 1 == curve.rows.size();
      fmt::format_to(std::back_inserter(out), "{},{},{:.17g},{},\"{}\"\n", curve.formulation, xi_text(curve),
                     fmt::join(curve.rows[i], ","), error, is_last ? curve.outcome : "");
    }
  }
  return out;
}

std::string critical_csv(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves) {
  std::string out = "formulation,xi,axis,critical_moment,critical_angle\n";
  for (const auto& curve : curves) {
    if (curve.formulation == reference::kLinearized) continue;
    const std::string state = curve.critical ? fmt::format("{:.17g},{:.17g}", double(curve.critical->moment),
                                                           double(curve.critical->angle))
                                             : ",";
    fmt::format_to(std::back_inserter(out), "{},{},{},{}\n", curve.formulation, xi_text(curve),
                   scene.critical_axis, state);
  }
  return out;
}

std::string curves_json(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves,
                        const std::vector<NotRun>& left_out) {
  nlohmann::ordered_json out = {{"schema", "halfway-run-1"},
                                {"scene", scene.name},
                                {"title", scene.title},
                                {"curves", nlohmann::ordered_json::array()}};
  for (const auto& curve : curves) {
    nlohmann::ordered_json item = {{"formulation", curve.formulation}};
    if (has_free_xi(curve)) item["xi"] = curve.xi;
    item["converged"] = curve.converged;
    item["outcome"] = curve.outcome;
    item["iterations"] = curve.iterations;
    item["residual"] = curve.residual;
    if (scene.critical_axis != 0) item["critical"] = critical_json(scene, curve);
    item["columns"] = curve.columns;
    item["rows"] = curve.rows;
    item["errors"] = curve.errors;
    out["curves"].push_back(std::move(item));
  }
  out["left_out"] = nlohmann::ordered_json::array();
  for (const auto& [name, reason] : left_out)
    out["left_out"].push_back({{"formulation", name}, {"reason", reason}});
  return out.dump(1) + "\n";
}

std::string curves_table(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves,
                         const std::vector<NotRun>& left_out) {
  if (curves.empty()) return "";
  std::size_t width = 11;
  for (const auto& curve : curves) width = std::max(width, curve_label(curve).size());
  std::string out = fmt::format("{:<{}}", "formulation", width);
  for (const auto& column : curves.front().columns)
    fmt::format_to(std::back_inserter(out), " {:>15}", column);
  if (scene.critical_axis != 0) out += " critical_moment  critical_angle";
  out += "     error  iterations  residual  outcome\n";
  for (const auto& curve : curves) {
    fmt::format_to(std::back_inserter(out), "{:<{}}", curve_label(curve), width);
    for (std::size_t i = 0; i < curve.columns.size(); ++i) {
      // Nothing but the unstrained point is no answer: its zeros would be read as one.
      const std::string value = curve.rows.size() < 2 ? "-" : fmt::format("{:.9g}", curve.rows.back()[i]);
      fmt::format_to(std::back_inserter(out), " {:>15}", value);
    }
    if (scene.critical_axis != 0) out += critical_cells(curve);
    const std::string error = curve.errors.empty() ? "-" : fmt::format("{:.1e}", curve.errors.back());
    fmt::format_to(std::back_inserter(out), "  {:>8}  {:>10}  {:>8.1e}  {}\n", error, curve.iterations,
                   curve.residual, curve.outcome);
  }
  for (const auto& [name, reason] : left_out)
    fmt::format_to(std::back_inserter(out), "{:<{}}  left out: {}\n", name, width, reason);
  return out;
}

}  // namespace halfway::reports
