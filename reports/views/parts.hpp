// A record of the report made part by part, each told when it is there.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <span>
#include <string>

namespace halfway::reports {

struct RecordPart {
  const char* name;
  nlohmann::json (*record)();
};

/// @param progress  told after each part: done, of how many, which
inline nlohmann::json record_of(std::span<const RecordPart> parts,
                                const std::function<void(int, int, const std::string&)>& progress) {
  nlohmann::json out = nlohmann::json::object();
  int done = 0;
  for (const RecordPart& part : parts) {
    out[part.name] = part.record();
    progress(++done, int(parts.size()), part.name);
  }
  return out;
}

}  // namespace halfway::reports
