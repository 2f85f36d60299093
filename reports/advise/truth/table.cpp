// A truth of the user's own: a file of comma-separated values, as `run` writes its curves.
#include "reports/advise/truth/truth.hpp"
#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace halfway::advise {
namespace {

using reports::BadInput;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    const auto first = cell.find_first_not_of(" \t\r"), last = cell.find_last_not_of(" \t\r");
    out.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return out;
}

double number_of(const std::string& cell, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw BadInput(fmt::format("{}: '{}' is not a finite number", where, cell));
  return value;
}

/// For `factor` and each output of the scene its column.
std::vector<std::size_t> columns_of(const std::vector<std::string>& heads, const reference::Scene& scene,
                                    const std::string& file, std::vector<std::string>& outputs) {
  std::vector<std::size_t> out;
  std::vector<std::string> wanted{"factor"};
  wanted.insert(wanted.end(), scene.outputs.begin(), scene.outputs.end());
  for (const std::string& name : wanted) {
    const auto found = std::ranges::find(heads, name);
    if (found == heads.end() && name == "factor")
      throw BadInput(fmt::format("{}: line 1: no column 'factor'; found: {}; needed: factor and some of {}",
                                 file, fmt::join(heads, ", "), fmt::join(scene.outputs, ", ")));
    if (found == heads.end()) continue;
    if (name != "factor") outputs.push_back(name);
    out.push_back(std::size_t(found - heads.begin()));
  }
  if (outputs.empty())
    throw BadInput(fmt::format("{}: line 1: no column of an output; found: {}; allowed: {}", file,
                               fmt::join(heads, ", "), fmt::join(scene.outputs, ", ")));
  return out;
}

void read_row(const std::vector<std::string>& cells, const std::vector<std::size_t>& columns,
              const std::string& where, Answers& out) {
  std::vector<double> row;
  for (const std::size_t column : columns) {
    if (column >= cells.size())
      throw BadInput(fmt::format("{}: {} cells, of which {} are needed", where, cells.size(), column + 1));
    row.push_back(number_of(cells[column], where));
  }
  if (row[0] == 0) return;  // at rest nothing is asked
  if (row[0] < 0 || (!out.factor.empty() && row[0] <= out.factor.back()))
    throw BadInput(fmt::format("{}: load factor {:g}: must ascend from 0", where, row[0]));
  out.factor.push_back(row[0]);
  out.value.emplace_back(row.begin() + 1, row.end());
}

Answers read_table(const reference::Scene& scene, const std::string& file) {
  std::istringstream text(reports::read_file(file));
  Answers out;
  std::vector<std::size_t> columns;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    if (columns.empty())
      columns = columns_of(cells_of(line), scene, file, out.outputs);
    else
      read_row(cells_of(line), columns, fmt::format("{}: line {}", file, number), out);
  }
  if (out.factor.empty()) throw BadInput(fmt::format("{}: no row with a load factor above 0", file));
  return out;
}

}  // namespace

Truth table_truth(const reference::Scene& scene, const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    throw BadInput(fmt::format("--truth {}: no such file; needed: columns factor, {}", file,
                               fmt::join(scene.outputs, ", ")));
  const Answers rows = read_table(scene, file);
  Truth out;
  out.kind = TruthKind::table;
  out.measure = Measure::each;
  out.described =
      fmt::format("{}, {} rows up to load factor {:g}", file, rows.factor.size(), rows.factor.back());
  out.scene = scene;
  out.scene.outputs = rows.outputs;
  out.rows = rows.factor;
  out.is_smooth = false;
  out.at = [rows](const std::vector<double>& factors) {
    Answers some = rows;
    some.factor.resize(std::min(factors.size(), rows.factor.size()));
    some.value.resize(some.factor.size());
    return some;
  };
  return out;
}

}  // namespace halfway::advise
