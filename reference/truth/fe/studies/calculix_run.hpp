// ccx as a process: its folder, its environment, its end.
#pragma once

#include "reference/truth/fe/studies/calculix.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace halfway::reference::fe {

/// A temporary folder of one call alone, gone with it. Throws std::runtime_error where none can be made.
class CalculixFolder {
 public:
  CalculixFolder();
  ~CalculixFolder();
  CalculixFolder(const CalculixFolder&) = delete;
  CalculixFolder& operator=(const CalculixFolder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs ccx in the folder, its output in `log`; the exit status, or 128 + the signal that ended it. Throws
/// std::runtime_error where ccx is missing or does not start.
int run_calculix(const CalculixFolder& folder, std::vector<std::string> arguments, CalculixCost& cost);

/// Throws std::runtime_error: what, and ccx's last lines.
[[noreturn]] void calculix_fail(const std::string& what, const CalculixFolder& folder);

}  // namespace halfway::reference::fe
