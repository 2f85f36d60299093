#include "reports/eval/suggest.hpp"

#include "reference/face/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace halfway::reports {
namespace {

constexpr std::size_t kLongestShown = 60;

/// Levenshtein's distance to the nearest beginning of b, and to all of it: who abbreviates is understood.
std::pair<std::size_t, std::size_t> edit_distances(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return {*std::ranges::min_element(row), row.back()};
}

}  // namespace

std::string_view closest(std::string_view name, const std::vector<std::string_view>& allowed) {
  const auto shown = name.substr(0, kLongestShown);
  const auto best = std::ranges::min_element(
      allowed, {}, [&](std::string_view candidate) { return edit_distances(shown, candidate); });
  return best == allowed.end() ? std::string_view{} : *best;
}

std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& allowed) {
  const std::string_view more = name.size() > kLongestShown ? "..." : "";
  return fmt::format("unknown {} '{}{}', did you mean '{}'? allowed: {}", what, name.substr(0, kLongestShown),
                     more, closest(name, allowed), fmt::join(allowed, ", "));
}

std::vector<std::string_view> formulation_names() {
  std::vector<std::string_view> names;
  for (const auto& entry : reference::formulations()) names.push_back(entry.name);
  return names;
}

}  // namespace halfway::reports
