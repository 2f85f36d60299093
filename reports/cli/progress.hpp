// Progress of long work on stderr: one moving line on a terminal, plain lines otherwise.
#pragma once

#include <string>

namespace halfway::reports {

class Progress {
 public:
  explicit Progress(std::string stage);
  /// After item `done` of `total`. On a terminal each call rewrites the line; elsewhere every tenth
  /// part prints one.
  void operator()(int done, int total, const std::string& item);

 private:
  std::string stage_;
  bool terminal_;
  int last_tenth_ = 0;
};

}  // namespace halfway::reports
