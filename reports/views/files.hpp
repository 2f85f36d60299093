// Output files: complete or not there at all.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace halfway::reports {

/// A file that could not be read or written; the message names it and says why.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes `text` to a temporary file beside `file`, then renames it; missing folders are made.
/// A reader never sees half a file. Throws FileError.
void write_file(const std::filesystem::path& file, const std::string& text);

/// Makes the folder and writes a file into it for a moment: an output that cannot be kept is refused
/// before the work. Throws FileError.
void try_folder(const std::filesystem::path& folder);

/// A folder for one writer at a time: a second one is told whose it is. The lock goes with the process,
/// however that ends. Throws FileError.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);  ///< which must be there
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_;
};

/// The whole file. Throws FileError.
std::string read_file(const std::filesystem::path& file);

}  // namespace halfway::reports
