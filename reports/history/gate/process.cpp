#include "reports/history/gate/process.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/interrupts.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>

namespace halfway::gate {
namespace {

std::string last_line(const std::filesystem::path& log) {
  std::ifstream in(log);
  std::string line, last = "it printed nothing";
  while (std::getline(in, line)) {
    if (!line.empty()) last = line.substr(0, 300);
  }
  return last;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& more) {
  std::vector<std::string> out;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text(*entry);
    if (!more.contains(text.substr(0, text.find('=')))) out.push_back(text);
  }
  for (const auto& [name, value] : more) out.push_back(fmt::format("{}={}", name, value));
  return out;
}

pid_t start(std::vector<std::string> words, const std::filesystem::path& log,
            std::vector<std::string> environment) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawnp(&child, words[0].c_str(), &files, nullptr, pointers(words).data(),
                                 pointers(environment).data());
  posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw reports::FailedRun(fmt::format("cannot start {}: {}", words[0], std::strerror(error)));
  return child;
}

}  // namespace

std::string run(const std::vector<std::string>& words, const std::filesystem::path& log, double seconds,
                const std::map<std::string, std::string>& environment) {
  const pid_t child = start(words, log, environment_with(environment));
  const auto begin = std::chrono::steady_clock::now();
  int status = 0;
  bool late = false;
  while (waitpid(child, &status, WNOHANG) == 0) {
    late = late || std::chrono::steady_clock::now() - begin > std::chrono::duration<double>(seconds);
    if (late || reports::interrupted()) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (reports::interrupted()) throw reports::FailedRun("interrupted; the same command goes on from there");
  if (late) return fmt::format("took longer than {:g} s", seconds);
  if (WIFSIGNALED(status))
    return fmt::format("ended by signal {} ({}): {}", WTERMSIG(status), strsignal(WTERMSIG(status)),
                       last_line(log));
  if (WEXITSTATUS(status) != 0)
    return fmt::format("ended with exit code {}: {}", WEXITSTATUS(status), last_line(log));
  return "";
}

}  // namespace halfway::gate
