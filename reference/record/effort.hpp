// How much a study or a check samples. Full: what a proof needs. Quick (HALFWAY_EFFORT=quick): every line
// reached with fewer samples, for sanitizers and smoke runs; limits are the same, so a quick run fails only
// where a full one does.
#pragma once

#include <cstdlib>
#include <string_view>
#include <vector>

namespace halfway::reference {

inline bool is_quick() {
  const char* effort = std::getenv("HALFWAY_EFFORT");
  return effort != nullptr && std::string_view(effort) == "quick";
}

/// `full`, or `quick` where HALFWAY_EFFORT says so.
inline int by_effort(int full, int quick) { return is_quick() ? quick : full; }

/// All that a full run samples, or every so many of them: the same draws, so that a quick run fails only
/// where a full one does.
template <class T>
std::vector<T> sampled(const std::vector<T>& all, int quick_step) {
  const auto step = std::size_t(by_effort(1, quick_step));
  std::vector<T> out;
  for (std::size_t i = 0; i < all.size(); i += step) out.push_back(all[i]);
  return out;
}

}  // namespace halfway::reference
