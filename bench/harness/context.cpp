#include "bench/harness/context.hpp"

#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "build_commit.hpp"  // generated at every build
#include "build_flags.hpp"   // generated at configuration

namespace halfway::bench {
namespace {

/// /proc/cpuinfo names the model on x86; arm64 gives numbers only.
std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown CPU (" HALFWAY_PROCESSOR ")";
}

std::string compiler() {
#ifdef __clang__
  return "clang++ " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

Context context() {
  return {fmt::format("{}, {} cores", cpu_model(), std::thread::hardware_concurrency()),
          compiler(),
          HALFWAY_FLAGS,
          HALFWAY_COMMIT,
          now(),
          HALFWAY_BUILD_TYPE};
}

}  // namespace halfway::bench
