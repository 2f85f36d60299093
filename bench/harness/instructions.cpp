#include "bench/harness/instructions.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "bench/harness/case.hpp"
#include "bench/harness/context.hpp"

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

/// What callgrind counts, found by its name: one dump of the counters for each call.
extern "C" void halfway_counted(const std::function<void(int)>& evaluate, int iterations) {
  evaluate(iterations);
}

namespace halfway::bench {
namespace {

namespace fs = std::filesystem;

/// The cases of the names, in the order of the names.
Cases cases_of(const std::vector<std::string>& names) {
  const Cases all = all_cases();
  Cases out;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, &Case::name);
    if (found == all.end()) throw std::runtime_error(fmt::format("there is no benchmark '{}'", name));
    if (!found->evaluate)
      throw std::runtime_error(fmt::format("benchmark '{}' cannot be evaluated without a clock", name));
    out.push_back(*found);
  }
  return out;
}

/// A folder that goes with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = fs::temp_directory_path() / "halfway_instructions_XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string last_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line, last = "no output";
  while (std::getline(in, line)) {
    if (!line.empty()) last = line;
  }
  return last;
}

/// The total of one dump of callgrind.
double total(const fs::path& dump) {
  std::ifstream in(dump);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("totals: ")) return std::stod(line.substr(8));
  }
  throw std::runtime_error("valgrind wrote no " + dump.filename().string());
}

/// glibc chooses among codes of its functions by these: so do the numbers.
std::string libm_code() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "avx2, fma";
  return "baseline";
#else
  return "not x86-64";
#endif
}

}  // namespace

MadeWith made_with() {
  const Context c = context();
  MadeWith out{
      .compiler = c.compiler, .flags = c.flags, .eigen = {}, .libc = "unknown", .libm_code = libm_code()};
  out.eigen = fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
#ifdef __GLIBC__
  out.libc = fmt::format("glibc {}", gnu_get_libc_version());
#endif
  return out;
}

bool valgrind_available() { return std::system("command -v valgrind >/dev/null 2>&1") == 0; }

void run_cases(const std::vector<std::string>& names) {
  auto* volatile counted = halfway_counted;  // through a pointer: no clone of another name is called
  for (const Case& c : cases_of(names)) {
    c.evaluate(1);
    counted(c.evaluate, 1);
  }
}

InstructionCounts count_instructions(const fs::path& program, const std::vector<std::string>& names) {
  const Cases cases = cases_of(names);
  const Scratch scratch;
  const fs::path out = scratch.folder() / "out", log = scratch.folder() / "log";
  std::string command = fmt::format(
      "valgrind --tool=callgrind --callgrind-out-file={} --toggle-collect=halfway_counted "
      "--dump-after=halfway_counted {} evaluate",
      quoted(out), quoted(program));
  for (const std::string& name : names) command += ' ' + quoted(name);
  if (std::system(fmt::format("{} >{} 2>&1", command, quoted(log)).c_str()) != 0)
    throw std::runtime_error("valgrind failed: " + last_line(log));
  InstructionCounts counts;
  for (const Case& c : cases) {
    const fs::path dump = out.string() + fmt::format(".{}", counts.size() + 1);
    counts.push_back({c.name, total(dump) / c.evaluations});
  }
  return counts;
}

}  // namespace halfway::bench
