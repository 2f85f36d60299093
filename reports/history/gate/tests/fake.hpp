// Benchmark programs that time nothing: shell scripts that print Google Benchmark's JSON with seeded noise.
#pragma once

#include "reports/history/gate/times.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace halfway::gate::test {

/// A folder that goes with the object.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Figures a, b, c of 100 ns with a noise of 1 % that differs in every process. `rows` is appended to the awk
/// program's END block: it may change time["a"], or print rows of its own. `first` is shell code at the
/// start. Every start appends a line to PROGRAM.starts.
std::filesystem::path fake_program(const std::filesystem::path& folder, const std::string& name,
                                   const std::string& change = "", const std::string& first = "");

/// How often it was started.
int starts(const std::filesystem::path& program);

/// A report: two findings of each comparison, a timing with flops.
nlohmann::json small_report();
std::filesystem::path write_report(const std::filesystem::path& folder, const nlohmann::json& report);

}  // namespace halfway::gate::test
