#include "reports/history/intake/intake.hpp"

#include <fmt/format.h>

#include <fstream>

namespace halfway::history {
namespace {

/// The first "KEY : VALUE" of /proc/cpuinfo.
std::string cpuinfo(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

std::string first_word(const std::string& file) {
  std::string word;
  std::ifstream(file) >> word;
  return word;
}

}  // namespace

std::string cpu_here() { return cpuinfo("model name"); }
std::string microcode_here() { return cpuinfo("microcode"); }

std::string cache_text(int level, const std::string& type, long bytes) {
  const std::string letter = type == "Data" ? "d" : type == "Instruction" ? "i" : "";
  const bool is_large = bytes % (1 << 20) == 0;
  return fmt::format("L{}{} {} {}", level, letter, bytes >> (is_large ? 20 : 10), is_large ? "MiB" : "KiB");
}

std::string caches_here() {
  std::string out;
  for (int i = 0;; ++i) {
    const std::string folder = fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/", i);
    const std::string level = first_word(folder + "level"), size = first_word(folder + "size");
    if (level.empty() || size.empty()) return out;
    const long unit = size.back() == 'M' ? 1 << 20 : size.back() == 'K' ? 1 << 10 : 1;
    out += (out.empty() ? "" : ", ") +
           cache_text(std::atoi(level.c_str()), first_word(folder + "type"), unit * std::atol(size.c_str()));
  }
}

std::string isa_here() {
  const std::string flags = " " + cpuinfo("flags") + " ";
  if (flags.find(" avx512f ") != std::string::npos) return "avx512";
  if (flags.find(" avx2 ") != std::string::npos) return "avx2";
  return flags.find(" sse2 ") != std::string::npos ? "sse2" : "";
}

double load_here() {
  double load = kNone;
  std::ifstream file("/proc/loadavg");
  return file >> load ? load : kNone;
}

}  // namespace halfway::history
