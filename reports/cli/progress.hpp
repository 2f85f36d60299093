// Progress of long work on stderr: one moving line on a terminal, plain lines otherwise.
#pragma once

#include <string>

namespace halfway::reports {

class Progress {
 public:
  enum class Elsewhere { tenths, silent };  ///< what is printed where there is no terminal
  explicit Progress(std::string stage, Elsewhere elsewhere = Elsewhere::tenths);
  /// After item `done` of `total`. On a terminal each call rewrites the line; elsewhere every tenth
  /// part prints one, or none does.
  void operator()(int done, int total, const std::string& item);
  /// Ends the line of work that stopped early.
  ~Progress();

 private:
  std::string stage_;
  bool terminal_;
  bool silent_;
  bool line_open_ = false;
  int last_tenth_ = 0;
};

}  // namespace halfway::reports
