#include "reports/check/child/child_process.hpp"

#include "reports/cli/errors.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

namespace halfway::check {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kStep{2};  // between looks at what ends
constexpr milliseconds kBetweenTermAndKill{500};
constexpr milliseconds kAfterKill{5000};  // a process in the kernel cannot be waited for for ever

/// Two ends, neither of which another program inherits.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0)
      throw reports::FailedRun(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  }
  ~Pipe() {
    for (const int end : ends_)
      if (end >= 0) close(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  /// Ours from here on: calls on it return at once.
  int keep(int end) {
    const int kept = std::exchange(ends_[std::size_t(end)], -1);
    fcntl(kept, F_SETFL, fcntl(kept, F_GETFL) | O_NONBLOCK);
    return kept;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// How a program is started: a group of its own, its signals as they were at first.
class Manner {
 public:
  Manner(int input, int output, int log) {
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, log, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
  }
  ~Manner() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  Manner(const Manner&) = delete;
  Manner& operator=(const Manner&) = delete;

  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
};

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

/// How a child ended can be asked, and what it starts and leaves behind becomes ours to reap: no zombie
/// stays.
void keep_ended_children() {
  struct sigaction now = {};
  if (sigaction(SIGCHLD, nullptr, &now) == 0 && now.sa_handler == SIG_IGN) std::signal(SIGCHLD, SIG_DFL);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
}

template <class Condition>
bool comes_true_within(milliseconds most, Condition condition) {
  const auto until = Clock::now() + most;
  while (!condition()) {
    if (Clock::now() >= until) return false;
    std::this_thread::sleep_for(kStep);
  }
  return true;
}

}  // namespace

Process::Process(std::vector<std::string> words, int log) {
  keep_ended_children();
  Pipe input, output;
  const Manner manner(input.reader(), output.writer(), log);
  const int error = posix_spawnp(&leader_, words[0].c_str(), &manner.files, &manner.attributes,
                                 pointers(words).data(), environ);
  if (error != 0)
    throw reports::BadInput(fmt::format("cannot start {}: {}; no shell is run, the first word is a program",
                                        words[0], std::strerror(error)));
  input_ = input.keep(1);
  output_ = output.keep(0);
}

Process::~Process() {
  end();
  if (output_ >= 0) close(output_);
}

void Process::wait(bool to_write, milliseconds most) const {
  std::array<pollfd, 2> ends{{{.fd = output_, .events = POLLIN, .revents = 0},
                              {.fd = to_write ? input_ : -1, .events = POLLOUT, .revents = 0}}};
  poll(ends.data(), ends.size(), int(most.count()));  // whoever interrupts it is seen by the caller
}

std::size_t Process::write(std::string_view bytes) {
  std::size_t done = 0;
  while (input_ >= 0 && done < bytes.size()) {
    const ssize_t n = ::write(input_, bytes.data() + done, bytes.size() - done);
    if (n > 0) {
      done += std::size_t(n);
    } else if (errno == EAGAIN) {
      break;
    } else if (errno != EINTR) {
      close_input();
    }
  }
  return done;
}

void Process::close_input() {
  if (input_ >= 0) close(std::exchange(input_, -1));
}

std::size_t Process::unread() const {
  int bytes = 0;
  return input_ >= 0 && ioctl(input_, FIONREAD, &bytes) == 0 ? std::size_t(bytes) : 0;
}

bool Process::read(std::string& bytes) {
  constexpr std::size_t kMost = 1 << 20;
  std::array<char, 1 << 16> buffer;
  for (std::size_t all = 0; output_ >= 0 && all < kMost;) {
    const ssize_t n = ::read(output_, buffer.data(), buffer.size());
    if (n > 0) {
      bytes.append(buffer.data(), std::size_t(n));
      all += std::size_t(n);
    } else if (n < 0 && errno == EAGAIN) {
      break;
    } else if (n == 0 || errno != EINTR) {
      close(std::exchange(output_, -1));
    }
  }
  return output_ >= 0;
}

bool Process::has_ended() const {
  if (is_gone_) return true;
  siginfo_t info = {};
  // It stays a zombie until end(), so that its number is no other group's meanwhile.
  return waitid(P_PID, id_t(leader_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == leader_;
}

bool Process::ends_within(milliseconds most) const {
  return comes_true_within(most, [this] { return has_ended(); });
}

void Process::end(milliseconds leave) {
  close_input();
  if (!is_gone_within(leave)) {
    kill(-leader_, SIGTERM);
    if (!is_gone_within(kBetweenTermAndKill)) {
      kill(-leader_, SIGKILL);
      is_gone_within(kAfterKill);
    }
    is_gone_ = true;
  }
}

std::string Process::how() const {
  if (!WIFSIGNALED(status_)) return fmt::format("ended with exit code {}", WEXITSTATUS(status_));
  const int signal = WTERMSIG(status_);
  const char* const name = sigabbrev_np(signal);
  return fmt::format("ended by SIG{} ({})", name != nullptr ? name : std::to_string(signal),
                     sigdescr_np(signal) != nullptr ? sigdescr_np(signal) : "unknown signal");
}

/// @return  is nobody left?
bool Process::reap() {
  int status = 0;
  for (pid_t pid; (pid = waitpid(-leader_, &status, WNOHANG)) > 0;)
    if (pid == leader_) status_ = status;
  return kill(-leader_, 0) != 0;
}

bool Process::is_gone_within(milliseconds most) {
  if (!is_gone_) is_gone_ = comes_true_within(most, [this] { return reap(); });
  return is_gone_;
}

QuietPipes::QuietPipes() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
QuietPipes::~QuietPipes() { std::signal(SIGPIPE, before_); }

}  // namespace halfway::check
