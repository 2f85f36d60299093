// A part of this program in a process apart: what it computes, breaks or leaves behind stays there; what it
// writes is read here.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string_view>

namespace halfway::verify {

class Forked {
 public:
  /// Runs `part`, which writes to `output`, in a child process that ends with it, exit code 0; 1 where it
  /// throws. Throws std::runtime_error where there is no pipe or no process.
  explicit Forked(const std::function<void(int output)>& part);
  /// Waits for its end.
  ~Forked();
  Forked(const Forked&) = delete;
  Forked& operator=(const Forked&) = delete;

  int input() const { return input_; }
  void kill();
  /// As of waitpid.
  int status();

 private:
  pid_t id_ = -1;
  int input_ = -1, status_ = 0;
};

/// All of a text, however often that is interrupted; false where the reader is gone.
bool write_all(int output, std::string_view text);

}  // namespace halfway::verify
