#include "reports/import/files.hpp"

#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace halfway::imports {

std::string read_up_to(const std::filesystem::path& file, std::size_t most) {
  const auto refuse = [&](const char* what) {
    throw reports::BadInput(fmt::format(
        "{}: cannot be read ({}); allowed: a readable file of another program", file.string(), what));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) refuse("it is a folder");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(std::strerror(errno));
  std::string text(most + 1, '\0');
  in.read(text.data(), std::streamsize(text.size()));
  if (in.bad()) refuse("it broke off");
  text.resize(std::size_t(in.gcount()));
  return text;
}

void refuse_existing(const std::filesystem::path& file, bool force) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw reports::BadInput(fmt::format("{}: is a folder; allowed: --out with a file's name", file.string()));
  if (!force && std::filesystem::exists(std::filesystem::symlink_status(file, ignored)))
    throw reports::BadInput(fmt::format(
        "{}: is there already; allowed: --force to replace it, or --out with another name", file.string()));
}

void write_new(const std::filesystem::path& file, const std::string& text) {
  try {
    reports::write_file(file, text);
  } catch (const reports::FileError& error) {
    throw reports::FailedRun(error.what());
  }
}

}  // namespace halfway::imports
