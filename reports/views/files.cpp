#include "reports/views/files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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

void try_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    fail(folder, "cannot be a folder", error ? error.message() : "it is a file");
  }
  const auto probe = folder / ("try." + std::to_string(::getpid()) + ".part");
  write_file(probe, "written and removed");
  std::filesystem::remove(probe, error);
}

FolderLock::FolderLock(const std::filesystem::path& folder) : file_(folder / ".lock"), descriptor_(-1) {
  while (descriptor_ < 0) {
    const int opened = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (opened < 0) fail(file_, "cannot lock", std::strerror(errno));
    if (::flock(opened, LOCK_EX | LOCK_NB) != 0) {
      char pid[32] = {};
      const auto length = ::read(opened, pid, sizeof pid - 1);
      ::close(opened);
      fail(folder, "is being written by another process",
           length > 0 ? std::string("process ") + pid : "it has just begun");
    }
    // The one before may have removed the file after it was opened here: then it locks nobody out.
    struct stat here, there;
    const bool is_there = ::fstat(opened, &here) == 0 && ::stat(file_.c_str(), &there) == 0;
    if (is_there && here.st_ino == there.st_ino)
      descriptor_ = opened;
    else
      ::close(opened);
  }
  const std::string pid = std::to_string(::getpid());
  if (::ftruncate(descriptor_, 0) != 0 || ::write(descriptor_, pid.data(), pid.size()) < 0) {
    ::close(descriptor_);
    fail(file_, "cannot lock", std::strerror(errno));
  }
}

FolderLock::~FolderLock() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  ::close(descriptor_);
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
