// Table 1 of the paper, digit by digit, with the errata.
#include "reference/numbers/digits.hpp"
#include "reference/truth/data.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

/// Half a unit of the last digit of a printed decimal such as 0.00082223.
double half_unit(const std::string& printed) { return 0.5 * reference::last_digit(printed); }

constexpr const char* kRows[] = {"theta_x", "theta_y", "theta_z"};

/// MSC/ADAMS: "computed from the Euler parameters output with 6-digit accuracy" (footnote 5).
bool is_adams(const std::string& column) { return column.ends_with("_adams"); }

double tolerance(const std::string& column, const std::string& printed) {
  return printed == "0." ? 1e-17 : (is_adams(column) ? 2 : 1) * half_unit(printed);
}

Draft named(const std::string& column, const std::string& formulation, int row, const std::string& printed,
            const char* suffix = "") {
  return finding(fmt::format("table_1/{}/{}{}", column, kRows[row], suffix))
      .of(formulation)
      .about("table_1")
      .by(Oracle::printed, half_unit(printed));
}

Finding digit(const std::string& column, const std::string& formulation, int row, const std::string& printed,
              double ours) {
  return named(column, formulation, row, printed)
      .measured(ours)
      .in("rad")
      .equal(std::stod(printed), tolerance(column, printed),
             is_adams(column)
                 ? "one unit of the last printed digit: the print goes back to six-digit Euler parameters"
                 : "half a unit of the last printed digit; theta_x is printed with the sign of the literal "
                   "[36]");
}

/// The printed digits must stay visibly wrong.
Finding misprint(const std::string& column, const std::string& formulation, int row,
                 const std::string& printed, double ours) {
  return named(column, formulation, row, printed, "/misprint")
      .measured(std::abs(ours - std::stod(printed)) / tolerance(column, printed))
      .in("half units of the last printed digit")
      .within(10, 1e6, "erratum of the paper: a zero is missing");
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
    const double ours = double(row == 0 ? -theta[row] : theta[row]);
    findings.push_back(digit(column, formulation, row, right, ours));
    if (right != printed) findings.push_back(misprint(column, formulation, row, printed, ours));
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
