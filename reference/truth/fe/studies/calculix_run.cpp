#include "reference/truth/fe/studies/calculix_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "ccx";

std::optional<fs::path> find_program() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / kProgram;
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0)
      return fs::absolute(candidate);
  }
  return std::nullopt;
}

std::string last_lines(const fs::path& log) {
  constexpr std::size_t kLines = 8;
  std::deque<std::string> lines;
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > kLines) lines.pop_front();
  }
  std::string out;
  for (const std::string& line : lines) out += "\n  " + line;
  return out.empty() ? "\n  (it printed nothing)" : out;
}

/// This process's environment with one thread, whatever the caller's settings: the cost is then CPU time.
std::vector<std::string> environment() {
  std::vector<std::string> out;
  const std::vector<std::string> ours = {
      "OMP_NUM_THREADS=",     "OPENBLAS_NUM_THREADS=",      "CCX_NPROC_RESULTS=",
      "CCX_NPROC_STIFFNESS=", "CCX_NPROC_EQUATION_SOLVER=", "NUMBER_OF_CPUS="};
  for (char** entry = environ; *entry; ++entry) {
    bool overridden = false;
    for (const std::string& name : ours) overridden = overridden || std::string(*entry).starts_with(name);
    if (!overridden) out.emplace_back(*entry);
  }
  for (const std::string& name : ours) out.push_back(name + "1");
  return out;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> out;
  for (std::string& s : strings) out.push_back(s.data());
  out.push_back(nullptr);
  return out;
}

}  // namespace

CalculixFolder::CalculixFolder() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "halfway-ccx-XXXXXX").string();
  if (error || !mkdtemp(name.data()))
    throw std::runtime_error(fmt::format("ccx (CalculiX): no temporary folder can be made (TMPDIR): {}",
                                         error ? error.message() : std::strerror(errno)));
  path_ = name;
}

CalculixFolder::~CalculixFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

bool calculix_available() { return find_program().has_value(); }

void calculix_fail(const std::string& what, const CalculixFolder& folder) {
  throw std::runtime_error(
      fmt::format("ccx (CalculiX): {}; its last lines:{}", what, last_lines(folder / "log")));
}

int run_calculix(const CalculixFolder& folder, std::vector<std::string> arguments, CalculixCost& cost) {
  const std::optional<fs::path> program = find_program();
  if (!program) throw std::runtime_error("ccx (CalculiX, package calculix-ccx) is not on PATH");
  arguments.insert(arguments.begin(), kProgram);
  std::vector<std::string> variables = environment();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.path().c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "log", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t pid = 0;
  const int error = posix_spawn(&pid, program->c_str(), &actions, nullptr, pointers(arguments).data(),
                                pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error(
        fmt::format("ccx (CalculiX): {} does not start: {}", program->string(), std::strerror(error)));
  int status = 0;
  rusage usage{};
  while (wait4(pid, &status, 0, &usage) < 0) {
    if (errno != EINTR)
      throw std::runtime_error(fmt::format("ccx (CalculiX): lost: {}", std::strerror(errno)));
  }
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  cost.cpu += seconds(usage.ru_utime) + seconds(usage.ru_stime);
  ++cost.runs;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace halfway::reference::fe
