#include "reports/check/child/child_log.hpp"

#include "reports/check/child/child_lines.hpp"
#include "reports/cli/errors.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace halfway::check {
namespace {

namespace fs = std::filesystem;

constexpr long kMost = 32'000'000;  // bytes
constexpr long kQuoted = 4096;
constexpr std::size_t kQuotedLines = 3;

long size_of(int descriptor) {
  struct stat status = {};
  return fstat(descriptor, &status) == 0 ? long(status.st_size) : 0;
}

}  // namespace

Log::Log(fs::path file) : file_(std::move(file)), is_temporary_(file_.empty()) {
  if (is_temporary_) {
    std::string name = fs::temp_directory_path() / "halfway_check_XXXXXX";
    descriptor_ = mkostemp(name.data(), O_CLOEXEC | O_APPEND);
    file_ = name;
  } else {
    descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  }
  if (descriptor_ < 0)
    throw reports::FailedRun(fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
  mark();
}

Log::~Log() {
  close(descriptor_);
  std::error_code ignored;
  if (is_temporary_) fs::remove(file_, ignored);
}

void Log::mark() { mark_ = size_of(descriptor_); }

void Log::bound() {
  if (size_of(descriptor_) > kMost && ftruncate(descriptor_, 0) == 0) mark_ = 0;
}

std::string Log::last_words() const {
  const long size = size_of(descriptor_);
  const long begin = std::max(std::min(mark_, size), size - kQuoted);
  std::string text(std::size_t(size - begin), '\0');
  text.resize(std::size_t(std::max(0L, long(pread(descriptor_, text.data(), text.size(), begin)))));
  Lines lines;
  lines.add(text + "\n");
  std::vector<std::string> last;
  while (const auto line = lines.next()) last.push_back(readable(line->text));
  if (last.empty()) return "";
  if (last.size() > kQuotedLines) last.erase(last.begin(), last.end() - kQuotedLines);
  return fmt::format("; its last words: {}", fmt::join(last, " | "));
}

}  // namespace halfway::check
