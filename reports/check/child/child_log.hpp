// What a program writes to its standard error: a file, of which messages quote the end.
#pragma once

#include <filesystem>
#include <string>

namespace halfway::check {

class Log {
 public:
  /// Appends to `file`; without one, to a temporary file that goes with the object. Throws
  /// reports::FailedRun.
  explicit Log(std::filesystem::path file = {});
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  int descriptor() const { return descriptor_; }
  /// What comes from here on is another program's.
  void mark();
  /// Empties a file that would fill the disk.
  void bound();
  /// The last three lines since the mark, "; its last words: ..."; "" where it was silent.
  std::string last_words() const;

 private:
  std::filesystem::path file_;
  bool is_temporary_;
  int descriptor_ = -1;
  long mark_ = 0;  ///< bytes
};

}  // namespace halfway::check
