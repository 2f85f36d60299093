#include "reports/advise/truth/read_table.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace halfway::advise {
namespace {

using reference::shortened;
using reports::BadInput;

constexpr std::string_view kByteOrder = "\xEF\xBB\xBF";  // as spreadsheets begin a file

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
    throw BadInput(fmt::format("{}: '{}' is not a finite number", where, shortened(cell)));
  return value;
}

/// For `factor` and each output of the scene its column.
/// @param where  the head's file and line
std::vector<std::size_t> columns_of(const std::vector<std::string>& heads,
                                    const std::vector<std::string>& allowed, const std::string& where,
                                    std::vector<std::string>& outputs) {
  std::vector<std::size_t> out;
  std::vector<std::string> wanted{"factor"};
  wanted.insert(wanted.end(), allowed.begin(), allowed.end());
  const std::string found_heads = shortened(fmt::format("{}", fmt::join(heads, ", ")));
  for (const std::string& name : wanted) {
    const auto found = std::ranges::find(heads, name);
    if (found == heads.end() && name == "factor")
      throw BadInput(fmt::format("{}: no column 'factor'; found: {}; needed: factor and some of {}", where,
                                 found_heads, fmt::join(allowed, ", ")));
    if (found == heads.end()) continue;
    if (name != "factor") outputs.push_back(name);
    out.push_back(std::size_t(found - heads.begin()));
  }
  if (outputs.empty())
    throw BadInput(fmt::format("{}: no column of an output; found: {}; allowed: {}", where, found_heads,
                               fmt::join(allowed, ", ")));
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

}  // namespace

Answers read_table(const std::string& file_text, const std::vector<std::string>& outputs,
                   const std::string& name) {
  std::istringstream text(file_text.starts_with(kByteOrder) ? file_text.substr(kByteOrder.size())
                                                            : file_text);
  Answers out;
  std::vector<std::size_t> columns;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const std::string where = fmt::format("{}: line {}", name, number);
    if (columns.empty())
      columns = columns_of(cells_of(line), outputs, where, out.outputs);
    else
      read_row(cells_of(line), columns, where, out);
  }
  if (out.factor.empty()) throw BadInput(fmt::format("{}: no row with a load factor above 0", name));
  return out;
}

}  // namespace halfway::advise
