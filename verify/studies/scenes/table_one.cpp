// Table 1 of the paper, digit by digit, with the errata.
#include "reference/truth/data.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

/// Half a unit of the last digit of a printed decimal such as 0.00082223.
double half_unit(const std::string& printed) {
  const auto point = printed.find('.');
  return 0.5 * std::pow(10.0, -double(printed.size() - point - 1));
}

Finding digit(const std::string& column, const std::string& formulation, int row, const std::string& printed,
              double ours) {
  const char* rows[] = {"theta_x", "theta_y", "theta_z"};
  Finding f;
  f.name = fmt::format("table_1/{}/{}", column, rows[row]);
  f.formulation = formulation;
  f.subject = "table_1";
  f.unit = "rad";
  f.value = row == 0 ? -ours : ours;
  f.expected = std::stod(printed);
  // MSC/ADAMS: "computed from the Euler parameters output with 6-digit accuracy" (footnote 5).
  const bool adams = column.ends_with("_adams");
  f.high = printed == "0." ? 1e-17 : (adams ? 2 : 1) * half_unit(printed);
  f.comparison = Comparison::equal;
  f.oracle = Oracle::printed;
  f.uncertainty = half_unit(printed);
  f.reason =
      adams ? "one unit of the last printed digit: the print goes back to six-digit Euler parameters"
            : "half a unit of the last printed digit; theta_x is printed with the sign of the literal [36]";
  return f;
}

/// The printed text, or the right one where the errata correct it.
std::string corrected(const nlohmann::json& tables, const std::string& column, int row,
                      const std::string& printed) {
  const std::string where = fmt::format("table_1.columns.{}.printed[{}]", column, row);
  for (const auto& erratum : tables.at("errata")) {
    if (erratum.at("where") == where) return erratum.at("right");
  }
  return printed;
}

std::vector<Finding> compare_column(const std::string& column) {
  const nlohmann::json tables = reference::read_data("paper/tables.json");
  const auto& entry_json = tables.at("table_1").at("columns").at(column);
  const std::string formulation = entry_json.at("formulation");
  const auto& entry = *reference::find_formulation(formulation);
  const auto theta = rotation_at("c1_skewed_torque", entry, entry.probe_xi, 1);
  std::vector<Finding> findings;
  for (int row = 0; row < 3; ++row) {
    const std::string printed = entry_json.at("printed").at(row);
    const std::string right = corrected(tables, column, row, printed);
    findings.push_back(judged(digit(column, formulation, row, right, double(theta[row]))));
    if (right == printed) continue;
    Finding misprint = digit(column, formulation, row, printed, double(theta[row]));
    misprint.name += "/misprint";
    misprint.comparison = Comparison::within;  // the printed digits must stay visibly wrong
    misprint.value = std::abs(misprint.value - misprint.expected) / misprint.high;
    misprint.low = 10;
    misprint.high = 1e6;
    misprint.unit = "half units of the last printed digit";
    misprint.reason = "erratum of the paper: a zero is missing";
    findings.push_back(judged(misprint));
  }
  return findings;
}

}  // namespace

void table_one(Checks& checks) {
  for (const char* column : {"ground", "ground_adams", "node", "node_adams", "invariant"}) {
    checks.push_back(
        {fmt::format("table_1/{}", column), "cases", [column] { return compare_column(column); }});
  }
}

}  // namespace halfway::verify
