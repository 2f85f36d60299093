// halfway_instructions: counts instructions per evaluation, and compares them with kept numbers.
//   halfway_instructions count NAME...           prints them
//   halfway_instructions record FILE [NAME...]   keeps them in FILE; without names, of the cases in FILE
//   halfway_instructions check [FILE]            compares, with bench/instructions.json by default; exit code
//   77 where no comparison is possible halfway_instructions evaluate NAME...        what valgrind runs
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>

#include "bench/harness/instructions.hpp"

namespace {

using namespace halfway::bench;

constexpr int kLeftOut = 77;
/// The code is the same and so is the compiler: what remains is where the poses lie in the branches of
/// library functions of another patch level.
constexpr double kTolerance = 0.02;

const char* const kUsage =
    "usage: halfway_instructions count NAME... | record FILE [NAME...] | check [FILE] | evaluate NAME...\n";

std::vector<std::string> names_of(const InstructionCounts& counts) {
  std::vector<std::string> names;
  for (const InstructionCount& count : counts) names.push_back(count.name);
  return names;
}

InstructionCounts count(const std::vector<std::string>& names) {
  return count_instructions(std::filesystem::read_symlink("/proc/self/exe"), names);
}

void print(const InstructionCounts& counts) {
  for (const auto& [name, instructions] : counts) fmt::print("{:<50} {:>10.1f}\n", name, instructions);
}

void record(const std::string& file, std::vector<std::string> names) {
  if (names.empty()) names = names_of(read_instructions(file).counts);
  const InstructionBaseline baseline{made_with(), count(names)};
  print(baseline.counts);
  write_instructions(file, baseline);
}

/// What of `mine` is not as in `theirs`; empty when all is.
std::string difference(const MadeWith& mine, const MadeWith& theirs) {
  std::string out;
  const auto add = [&](const char* what, const std::string& a, const std::string& b) {
    if (a != b) out += fmt::format("{}{}: {} here, {} in the file", out.empty() ? "" : "; ", what, a, b);
  };
  add("compiler", mine.compiler, theirs.compiler);
  add("flags", mine.flags, theirs.flags);
  add("Eigen", mine.eigen, theirs.eigen);
  add("libc", mine.libc, theirs.libc);
  add("libm's code", mine.libm_code, theirs.libm_code);
  return out;
}

int check(const std::string& file) {
  const InstructionBaseline kept = read_instructions(file);
  const std::string other = difference(made_with(), kept.with);
  if (!other.empty()) return fmt::print("left out: not comparable ({})\n", other), kLeftOut;
  if (!valgrind_available()) return fmt::print("left out: valgrind is not installed\n"), kLeftOut;
  const InstructionCounts found = count(names_of(kept.counts));
  bool failed = found.empty();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double change = found[i].instructions / kept.counts[i].instructions - 1;
    const bool ok = std::abs(change) <= kTolerance;
    failed = failed || !ok;
    fmt::print("{} {:<46} {:>10.1f}, kept {:>10.1f} ({:+.2f} %)\n", ok ? "pass" : "FAIL", found[i].name,
               found[i].instructions, kept.counts[i].instructions, 100 * change);
  }
  if (failed)
    fmt::print("limit 2 % either way; a change that is meant: halfway_instructions record {}\n", file);
  return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::string command = words.empty() ? "" : words[0];
  const std::vector<std::string> rest(words.begin() + !words.empty(), words.end());
  if (command == "check" && rest.size() <= 1)
    return check(rest.empty() ? HALFWAY_INSTRUCTIONS_FILE : rest[0]);
  if (rest.empty()) return std::fputs(kUsage, stderr), 1;
  if (command == "evaluate") return run_cases(rest), 0;
  if (command == "count") return print(count(rest)), 0;
  if (command == "record") return record(rest[0], {rest.begin() + 1, rest.end()}), 0;
  return std::fputs(kUsage, stderr), 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "halfway_instructions: %s\n", error.what());
  return 1;
}
