#include "reports/history/gate/tests/fake.hpp"

#include "reports/views/files.hpp"

#include <stdlib.h>

#include <algorithm>
#include <stdexcept>

namespace halfway::gate::test {

namespace fs = std::filesystem;

Scratch::Scratch() {
  std::string name = fs::temp_directory_path() / "halfway_gate_XXXXXX";
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  folder_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path fake_program(const fs::path& folder, const std::string& name, const std::string& change,
                      const std::string& first) {
  const fs::path program = folder / name / "halfway_bench";
  reports::write_file(program, R"(#!/bin/sh
echo start >> "$0.starts"
seed=$(wc -l < "$0.starts")
)" + first + R"(
for word in "$@"; do
  case $word in
    --benchmark_out=*) out=${word#*=} ;;
    --benchmark_filter=*) filter=${word#*=} ;;
  esac
done
awk -v seed="$seed" -v name=")" + name +
                                   R"(" -v filter="$filter" '
  function row(figure, ns) {
    if (figure !~ filter) return
    printf "%s{\"name\": \"%s\", \"run_type\": \"iteration\", \"time_unit\": \"ns\", \"cpu_time\": %s, \"max_error\": %s}",
           comma, figure, ns, error[figure]
    comma = ",\n"
  }
  BEGIN {
    srand(1000 * length(name) + seed)
    for (i = 1; i <= 3; ++i) { f = substr("abc", i, 1); time[f] = 100 * (1 + 0.02 * (rand() - 0.5)); error[f] = "1e-16" }
    )" + change + R"(
    print "{\"context\": {}, \"benchmarks\": ["
    for (i = 1; i <= 3; ++i) if (substr("abc", i, 1) in time) row(substr("abc", i, 1), time[substr("abc", i, 1)])
    print "]}"
  }' > "$out"
)");
  fs::permissions(program, fs::perms::owner_all);
  return program;
}

int starts(const fs::path& program) {
  const std::string file = program.string() + ".starts";
  if (!fs::exists(file)) return 0;
  const std::string text = reports::read_file(file);
  return int(std::ranges::count(text, '\n'));
}

nlohmann::json small_report() {
  const auto finding = [](const char* name, const char* comparison, double value, double low, double high) {
    return nlohmann::json{{"name", name},     {"formulation", ""}, {"unit", ""}, {"comparison", comparison},
                          {"value", value},   {"expected", 1.0},   {"low", low}, {"high", high},
                          {"verdict", "pass"}};
  };
  return {{"schema", "halfway-results"},
          {"version", 1},
          {"command", "./halfway report"},
          {"context",
           {{"machine", "m, 2 cores"},
            {"compiler", "g++"},
            {"flags", "-O3"},
            {"build_type", "Release"},
            {"commit", "c0ffee"},
            {"date", "2026-01-02T03:04:05Z"}}},
          {"findings",
           {finding("most", "at_most", 1e-14, 0, 1e-12), finding("equal", "equal", 1 + 1e-10, 0, 1e-8),
            finding("least", "at_least", 5, 4, 0), finding("band", "within", 0.5, 0.4, 0.6),
            finding("shown", "report", 7, 0, 0)}},
          {"timings",
           {{{"name", "t"},
             {"formulation", ""},
             {"isa", "avx2"},
             {"wrong", false},
             {"ns", 50.0},
             {"error", 1e-16},
             {"flops", 306.5}}}},
          {"curves", {{{"scene", "s"}, {"formulation", "f"}, {"xi", 0.5}, {"iterations", 20}}}}};
}

fs::path write_report(const fs::path& folder, const nlohmann::json& report) {
  reports::write_file(folder / "results.json", report.dump());
  return folder;
}

}  // namespace halfway::gate::test
