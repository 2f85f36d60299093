#include "reports/advise/tests/promises.hpp"

#include "reports/advise/truth/read_table.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halfway::advise::test {
namespace {

std::string broken_by(const std::string& said, std::string_view text) {
  if (said.size() > 2000 || said.find('\n') != std::string::npos)
    return fmt::format("a refusal of {} bytes", said.size());
  if (said == "f.csv: no row with a load factor above 0") return "";
  constexpr std::string_view kHead = "f.csv: line ";
  if (!said.starts_with(kHead)) return "no file and line: " + said;
  long line = 0;
  std::from_chars(said.data() + kHead.size(), said.data() + said.size(), line);
  return line >= 1 && line <= 1 + std::ranges::count(text, '\n') ? "" : "a line that is not there: " + said;
}

std::string broken_by(const Answers& read) {
  double before = 0;
  for (std::size_t row = 0; row < read.factor.size(); ++row) {
    if (!(read.factor[row] > before) || !std::isfinite(read.factor[row]))
      return fmt::format("load factor {} after {}", read.factor[row], before);
    before = read.factor[row];
    if (read.value[row].size() != read.outputs.size()) return fmt::format("row {} has another length", row);
    if (!std::ranges::all_of(read.value[row], [](double x) { return std::isfinite(x); }))
      return fmt::format("row {} is not finite", row);
  }
  return read.factor.empty() || read.outputs.empty() ? "nothing read, and no refusal" : "";
}

}  // namespace

std::string broken_table_promise(std::string_view text) {
  try {
    return broken_by(read_table(std::string(text), {"theta_x", "theta_y", "theta_z"}, "f.csv"));
  } catch (const reports::BadInput& refusal) {
    return broken_by(refusal.what(), text);
  } catch (const std::exception& error) {
    return fmt::format("another exception: {}", error.what());
  }
}

}  // namespace halfway::advise::test
