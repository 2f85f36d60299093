#include "reports/cli/paper_facts.hpp"

#include "reference/data.hpp"

#include <fmt/format.h>

#include <string>

namespace halfway::reports {
namespace {

using nlohmann::json;

/// {"corrected", "erratum"} of the place in the paper; nulls where the print stands.
json correction(const json& tables, const std::string& where) {
  for (const json& erratum : tables.at("errata")) {
    if (erratum.at("where") == where) return {{"corrected", erratum.at("right")}, {"erratum", erratum.at("seen")}};
  }
  return {{"corrected", nullptr}, {"erratum", nullptr}};
}

json table_one(const json& tables) {
  const json& table = tables.at("table_1");
  json cells = json::array();
  for (const auto& [key, column] : table.at("columns").items()) {
    for (int row = 0; row < 3; ++row) {
      json cell = correction(tables, fmt::format("table_1.columns.{}.printed[{}]", key, row));
      cell["formulation"] = column.at("formulation");
      cell["column"] = key.substr(0, key.find('_')) + ": " + column.at("programs").get<std::string>();
      cell["output"] = table.at("rows").at(row);
      cell["printed"] = column.at("printed").at(row);
      cells.push_back(cell);
    }
  }
  return cells;
}

json buckling(const json& tables) {
  json out = json::array();
  for (const auto& [key, formulation] : {std::pair{"node", "attached_b"}, std::pair{"invariant", "invariant"}}) {
    json value = correction(tables, fmt::format("buckling.printed.{}", key));
    value["formulation"] = formulation;
    value["printed"] = tables.at("buckling").at("printed").at(key);
    out.push_back(value);
  }
  return out;
}

/// MBDyn's path of one case as a curve.
json mbdyn_curve(const std::string& scene, const std::string& formulation, const json& path) {
  json rows = json::array();
  for (std::size_t i = 0; i < path.at("M").size(); ++i) {
    json row = path.at("theta").at(i);
    row.insert(row.begin(), path.at("M").at(i));
    rows.push_back(row);
  }
  return {{"scene", scene}, {"formulation", formulation}, {"source", "MBDyn 1.7.3"},
          {"columns", {"factor", "theta_x", "theta_y", "theta_z"}}, {"rows", rows}};
}

}  // namespace

json paper_facts() {
  const json tables = reference::read_data("paper/tables.json");
  const json mbdyn = reference::read_data("mbdyn/parallelepiped_angular.json");
  json curves = json::array();
  for (const auto& [figure, scene] :
       {std::pair{"fig3", "c2_parallelepiped_small"}, std::pair{"fig4", "c3_buckling"}}) {
    for (const auto& [key, formulation] : {std::pair{"att_gn", "attached_a"}, std::pair{"att_ng", "attached_b"},
                                           std::pair{"inv_gn", "invariant"}}) {
      curves.push_back(mbdyn_curve(scene, formulation, mbdyn.at(figure).at(key)));
    }
  }
  return {{"table1", table_one(tables)}, {"buckling", buckling(tables)}, {"reference_curves", curves}};
}

}  // namespace halfway::reports
