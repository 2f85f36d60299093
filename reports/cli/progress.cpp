#include "reports/cli/progress.hpp"

#include "reports/cli/streams.hpp"

#include <unistd.h>

#include <utility>

namespace halfway::reports {

Progress::Progress(std::string stage, Elsewhere elsewhere)
    : stage_(std::move(stage)),
      terminal_(isatty(STDERR_FILENO) == 1),
      silent_(!terminal_ && elsewhere == Elsewhere::silent) {}

Progress::~Progress() {
  if (line_open_) tell("\n");
}

void Progress::operator()(int done, int total, const std::string& item) {
  if (silent_) return;
  const int tenth = total > 0 ? 10 * done / total : 10;
  if (terminal_) {
    tell(fmt::format("\r\033[K{} {}/{} {}{}", stage_, done, total, printable(item.substr(0, 60)),
                     done == total ? "\n" : ""));
  } else if (tenth > last_tenth_) {
    tell(fmt::format("{} {}/{}\n", stage_, done, total));
  }
  line_open_ = terminal_ && done != total;
  last_tenth_ = tenth;
}

}  // namespace halfway::reports
