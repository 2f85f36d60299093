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

/// The whole file. Throws FileError.
std::string read_file(const std::filesystem::path& file);

}  // namespace halfway::reports
