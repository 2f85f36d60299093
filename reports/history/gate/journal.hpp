// Measurements as they come, a line each, so that what was interrupted goes on.
#pragma once

#include "reports/history/gate/reading.hpp"

#include <nlohmann/json_fwd.hpp>

#include <fstream>

namespace halfway::gate {

/// Which process of a comparison.
struct Turn {
  int run = 0;    ///< of several comparisons
  int round = 0;  ///< 0; 1: figures that gave an alarm, once more
  int pair = 0;
  bool head = false;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the comparison's 0 for a pointer
  friend auto operator<=>(const Turn&, const Turn&) = default;
};

class Journal {
 public:
  /// Reads what is there. A file of another comparison (its first line, `about`, differs) is begun again; a
  /// last line that was cut short is dropped. Throws reports::FileError.
  Journal(std::filesystem::path file, const nlohmann::json& about);
  /// What was measured at that turn; nullptr: nothing yet.
  const Reading* find(const Turn& turn) const;
  /// Appends, and has it on the disk before it returns.
  const Reading& add(const Turn& turn, const Reading& reading);
  std::size_t size() const { return readings_.size(); }

 private:
  std::filesystem::path file_;
  std::map<Turn, Reading> readings_;
  std::ofstream out_;
};

}  // namespace halfway::gate
