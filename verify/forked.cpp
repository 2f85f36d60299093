#include "verify/forked.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <stdexcept>

namespace halfway::verify {
namespace {

[[noreturn]] void run_to_end(const std::function<void(int)>& part, int output) {
  int code = 0;
  try {
    part(output);
  } catch (...) {
    code = 1;  // what goes further is the parent's stack, copied
  }
  _exit(code);
}

}  // namespace

Forked::Forked(const std::function<void(int output)>& part) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a child process");
  std::fflush(nullptr);  // or the child would print it once more
  id_ = fork();
  if (id_ == 0) close(ends[0]), run_to_end(part, ends[1]);
  close(ends[1]);
  input_ = ends[0];
  if (id_ > 0) return;
  close(input_);
  throw std::runtime_error("no child process");
}

Forked::~Forked() { status(), close(input_); }

void Forked::kill() { ::kill(id_, SIGKILL); }

int Forked::status() {
  if (id_ > 0)
    while (waitpid(id_, &status_, 0) < 0 && errno == EINTR) continue;
  id_ = -1;
  return status_;
}

bool write_all(int output, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(output, text.data(), text.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) text.remove_prefix(std::size_t(n));
  }
  return true;
}

}  // namespace halfway::verify
