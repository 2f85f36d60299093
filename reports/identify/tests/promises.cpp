#include "reports/identify/tests/promises.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/identify/read_other.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reports::test {
namespace {

std::string broken_by(const reference::Refusal& refusal, std::string_view text) {
  const std::string said = refusal.what();
  if (said.empty() || said.size() > 2000) return fmt::format("a refusal of {} bytes", said.size());
  const auto lines = 1 + std::ranges::count(text, '\n');
  if (refusal.line < 1 || refusal.line > lines)
    return fmt::format("line {} of {}: {}", refusal.line, lines, said);
  return "";
}

std::string broken_by(const reference::identify::Data& data) {
  if (data.cases.empty()) return "no case and no refusal";
  for (const double sigma : data.sigma)
    if (!(sigma >= 0) || !std::isfinite(sigma)) return fmt::format("a noise of {}", sigma);
  for (const auto& one : data.cases) {
    if (one.loads.empty() || one.loads.size() != one.motions.size())
      return fmt::format("{} loads and {} motions", one.loads.size(), one.motions.size());
    for (std::size_t row = 0; row < one.loads.size(); ++row)
      if (!one.loads[row].allFinite() || !one.motions[row].allFinite())
        return fmt::format("row {} of {} is not finite", row + 1, one.name);
  }
  return "";
}

}  // namespace

std::string broken_promise(std::string_view text) {
  try {
    return broken_by(read_data_file(text, "").data);
  } catch (const reference::Refusal& refusal) {
    return broken_by(refusal, text);
  } catch (const std::exception& error) {
    return fmt::format("another exception: {}", error.what());
  }
}

}  // namespace halfway::reports::test
