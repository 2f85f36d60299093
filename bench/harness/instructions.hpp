// Instructions per evaluation, counted by valgrind: the one speed that no other program on the
// machine disturbs. valgrind 3.19 knows no AVX-512: what it runs is baseline or AVX2 code.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace halfway::bench {

struct InstructionCount {
  std::string name;         ///< of the case
  double instructions = 0;  ///< per evaluation, mean over the case's poses
};
using InstructionCounts = std::vector<InstructionCount>;

/// What the numbers depend on besides the code. Equal texts: comparable numbers.
struct MadeWith {
  std::string compiler, flags, eigen, libc, libm_code;
  friend bool operator==(const MadeWith&, const MadeWith&) = default;
};
MadeWith made_with();

/// Numbers kept in a file, to compare with.
struct InstructionBaseline {
  MadeWith with;
  InstructionCounts counts;
};

/// Throws std::runtime_error that names the file and what is wrong with it.
InstructionBaseline read_instructions(const std::filesystem::path& file);
/// The numbers of bench/instructions.json if they were made with what made this program; else none.
InstructionCounts kept_instructions();
/// To a temporary file that takes its name when complete.
void write_instructions(const std::filesystem::path& file, const InstructionBaseline& baseline);

bool valgrind_available();

/// @param program  an executable whose `evaluate` command is run_cases, see instructions_main.cpp.
/// Throws std::runtime_error when a name is no case, or valgrind or the program fails.
InstructionCounts count_instructions(const std::filesystem::path& program,
                                     const std::vector<std::string>& names);

/// Runs each case once to bind its library functions, then once to be counted.
void run_cases(const std::vector<std::string>& names);

}  // namespace halfway::bench
