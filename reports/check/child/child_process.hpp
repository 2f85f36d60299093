// A program started without a shell, in a process group of its own, with pipes to its input and from its
// output.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::check {

class Process {
 public:
  /// @param log  descriptor of its standard error
  /// Throws reports::BadInput when it cannot be started.
  Process(std::vector<std::string> words, int log);
  ~Process();  ///< ends it
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t group() const { return leader_; }

  /// Waits until it wrote something, or there is room to write, or the time is over.
  void wait(bool to_write, std::chrono::milliseconds most) const;
  /// What fits now. It may have closed its input: takes_input() says so afterwards.
  /// @return  bytes written
  std::size_t write(std::string_view bytes);
  bool takes_input() const { return input_ >= 0; }
  void close_input();
  /// Bytes that were written and that it has not read.
  std::size_t unread() const;

  /// Appends what is there, at most a megabyte.
  /// @return  will there be more? Not after it closed its output
  bool read(std::string& bytes);

  /// Is the program itself over? What it has started may go on.
  bool has_ended() const;
  /// The same, waiting for it.
  bool ends_within(std::chrono::milliseconds most) const;
  /// Ends the whole group: its input is closed; after `leave`, in which it may go by itself, SIGTERM; after
  /// another 0.5 s SIGKILL. What it had written can still be read.
  void end(std::chrono::milliseconds leave = {});
  /// After end(): "ended with exit code 3", "ended by SIGSEGV (Segmentation fault)".
  std::string how() const;
  bool failed() const { return status_ != 0; }

 private:
  bool reap();
  bool is_gone_within(std::chrono::milliseconds most);

  pid_t leader_ = 0;
  int input_ = -1, output_ = -1;
  int status_ = 0;  ///< of the leader, once reaped
  bool is_gone_ = false;
};

/// While it lives a write to a closed pipe fails instead of ending this process.
class QuietPipes {
 public:
  QuietPipes();
  ~QuietPipes();
  QuietPipes(const QuietPipes&) = delete;
  QuietPipes& operator=(const QuietPipes&) = delete;

 private:
  void (*before_)(int);
};

}  // namespace halfway::check
