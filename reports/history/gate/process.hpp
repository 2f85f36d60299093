// Other programs, run to their end.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace halfway::gate {

/// Runs words[0] with the other words as its arguments; what it prints goes to `log`. A program that takes
/// longer than `seconds` is killed.
/// @return  "" when it ended with exit code 0, else how it ended and the last line of the log
/// Throws reports::FailedRun when it cannot be started, or when this process was interrupted
/// (reports::catch_interrupts()).
std::string run(const std::vector<std::string>& words, const std::filesystem::path& log, double seconds,
                const std::map<std::string, std::string>& environment = {});

}  // namespace halfway::gate
