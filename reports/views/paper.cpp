#include "reports/views/paper.hpp"

#include "reference/truth/data.hpp"

#include <fmt/format.h>

#include <array>

namespace halfway::reports {
namespace {

using nlohmann::json;

constexpr const char* kTables = "paper/tables.json";
constexpr const char* kMbdynCurves = "mbdyn/parallelepiped_angular.json";
constexpr std::array kColumns = {"ground", "ground_adams", "node", "node_adams", "invariant"};  // as printed

/// MBDyn's cases that are one of our formulations; the other node orders are the same curves.
constexpr std::array<std::pair<const char*, const char*>, 3> kMbdynCases = {
    {{"att_gn", "attached_a"}, {"att_ng", "attached_b"}, {"inv_gn", "invariant"}}};

json erratum_at(const json& errata, const std::string& where) {
  for (const json& erratum : errata)
    if (erratum.at("where") == where) return erratum;
  return nullptr;
}

/// The cell with its corrections: of its digits, and of the sign of its row.
json cell(const json& errata, const std::string& key, const json& column, const json& outputs,
          std::size_t i) {
  const std::string printed = column.at("printed").at(i);
  const std::string output = outputs.at(i);
  json out = {{"formulation", column.at("formulation")},
              {"column",
               fmt::format("{}: {}", key.substr(0, key.find('_')), column.at("programs").get<std::string>())},
              {"output", output},
              {"printed", printed},
              {"corrected", nullptr},
              {"erratum", nullptr}};
  std::string right = printed, seen;
  if (const json digits = erratum_at(errata, fmt::format("table_1.columns.{}.printed[{}]", key, i));
      !digits.is_null()) {
    right = digits.at("right");
    seen = digits.at("seen");
  }
  const json sign = erratum_at(errata, "table_1, row " + output);
  if (!sign.is_null() && sign.at("right") == "negative" && std::stod(right) > 0) {
    right = "-" + right;
    seen += (seen.empty() ? "sign: " : "; sign: ") + sign.at("seen").get<std::string>();
  }
  if (right == printed) return out;
  out["corrected"] = right;
  out["erratum"] = seen;
  return out;
}

json table_1(const json& tables) {
  const json& table = tables.at("table_1");
  json cells = json::array();
  for (const char* key : kColumns)
    for (std::size_t i = 0; i < table.at("rows").size(); ++i)
      cells.push_back(cell(tables.at("errata"), key, table.at("columns").at(key), table.at("rows"), i));
  return cells;
}

json buckling(const json& tables) {
  json moments = json::array();
  for (const auto& [name, printed] : tables.at("buckling").at("printed").items()) {
    const json erratum = erratum_at(tables.at("errata"), "buckling.printed." + name);
    const std::string formulation = name == "node" ? "attached_b" : name;
    moments.push_back({{"formulation", formulation},
                       {"printed", printed},
                       {"corrected", erratum.is_null() ? json() : erratum.at("right")},
                       {"erratum", erratum.is_null() ? json() : erratum.at("seen")}});
  }
  return moments;
}

json mbdyn_curve(const json& points, const char* scene, const char* formulation) {
  json rows = json::array();
  for (std::size_t i = 0; i < points.at("M").size(); ++i) {
    const json& theta = points.at("theta").at(i);
    rows.push_back({points.at("M").at(i), theta.at(0), theta.at(1), theta.at(2)});
  }
  return {{"scene", scene},
          {"formulation", formulation},
          {"source", "MBDyn 1.7.3"},
          {"columns", {"factor", "theta_x", "theta_y", "theta_z"}},
          {"rows", rows}};
}

json mbdyn_curves(const json& data) {
  json curves = json::array();
  for (const auto& [key, formulation] : kMbdynCases) {
    curves.push_back(mbdyn_curve(data.at("fig3").at(key), "c2_parallelepiped_small", formulation));
    curves.push_back(mbdyn_curve(data.at("fig4").at(key), "c3_buckling", formulation));
  }
  return curves;
}

/// A field that is not there is a fault of the file, not of the program: named as such.
template <class Make>
json from_file(const char* file, Make make) {
  const json data = reference::read_data(file);
  try {
    return make(data);
  } catch (const std::exception& error) {
    throw reference::DataError(
        fmt::format("{}: {}", (reference::data_folder() / file).string(), error.what()));
  }
}

}  // namespace

json paper_record() {
  return {{"table1", from_file(kTables, table_1)},
          {"buckling", from_file(kTables, buckling)},
          {"reference_curves", from_file(kMbdynCurves, mbdyn_curves)}};
}

}  // namespace halfway::reports
