#include "reports/identify/tests/promises.hpp"

#include "reports/identify/read_other.hpp"
#include "reports/tests/fuzz/refusal_promise.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reports::test {
namespace {

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
