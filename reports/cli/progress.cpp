#include "reports/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace halfway::reports {

Progress::Progress(std::string stage) : stage_(std::move(stage)), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::operator()(int done, int total, const std::string& item) {
  const int tenth = total > 0 ? 10 * done / total : 10;
  if (terminal_) {
    fmt::print(stderr, "\r\033[K{} {}/{} {}{}", stage_, done, total, item.substr(0, 60),
               done == total ? "\n" : "");
  } else if (tenth > last_tenth_) {
    fmt::print(stderr, "{} {}/{}\n", stage_, done, total);
  }
  last_tenth_ = tenth;
  std::fflush(stderr);
}

}  // namespace halfway::reports
