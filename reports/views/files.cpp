#include "reports/views/files.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace halfway::reports {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what, const std::string& why) {
  throw FileError(file.string() + ": " + what + ": " + why);
}

}  // namespace

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  if (error) fail(file, "cannot make its folder", error.message());

  // The process id keeps two runs that write to one folder apart.
  const std::filesystem::path part = file.string() + "." + std::to_string(::getpid()) + ".part";
  errno = 0;
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) {
    const std::string why = errno ? std::strerror(errno) : "write failed";
    std::filesystem::remove(part, error);
    fail(file, "cannot write", why);
  }
  std::filesystem::rename(part, file, error);
  if (error) {
    const std::string why = error.message();
    std::filesystem::remove(part, error);
    fail(file, "cannot replace", why);
  }
}

std::string read_file(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) fail(file, "cannot read", "it is a folder");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in) fail(file, "cannot read", errno ? std::strerror(errno) : "read failed");
  return text.str();
}

}  // namespace halfway::reports
