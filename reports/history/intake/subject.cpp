#include "reports/history/intake/intake.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace halfway::history {

std::string subject_of(const std::string& commit) {
  // Nothing but a commit's own digits reaches the shell.
  if (commit.size() < 4 || commit.find_first_not_of("0123456789abcdef") != std::string::npos) return "";
  const std::string command = "git log -1 --format=%s " + commit + " -- 2>/dev/null";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string out;
  char part[256];
  while (pipe && std::fgets(part, sizeof part, pipe.get()) != nullptr) out += part;
  while (out.ends_with('\n')) out.pop_back();
  return out;
}

}  // namespace halfway::history
