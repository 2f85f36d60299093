// How much a study samples. Full: what a proof needs. Quick (HALFWAY_EFFORT=quick): every line reached with
// fewer samples, for sanitizers and smoke runs; limits are the same, so a quick run fails only where a full
// one does.
#pragma once

#include <cstdlib>
#include <string_view>

namespace halfway::verify {

/// `full`, or `quick` where HALFWAY_EFFORT says so.
inline int by_effort(int full, int quick) {
  const char* effort = std::getenv("HALFWAY_EFFORT");
  return effort != nullptr && std::string_view(effort) == "quick" ? quick : full;
}

}  // namespace halfway::verify
