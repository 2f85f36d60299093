// A program of commands: what each of them says of bad input, a failed run and lost output.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace halfway::reports {

struct Program {
  const char* title;
  const char* exit_codes;           ///< last line of --help
  void (*add_commands)(CLI::App&);  ///< registers them
  /// The complaint of a name that is none of these; without it they are listed.
  std::string (*unknown)(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& allowed) = nullptr;
  /// Is it the input's fault, beside BadInput?
  bool (*is_bad_input)(const std::exception&) = nullptr;
};

/// @return  0 done; 1 the run failed, or something could not be written; 2 the input is wrong. What is wrong
/// is one line on stderr.
int run_program(const Program& program, int argc, char** argv);

}  // namespace halfway::reports
