#include "reports/history/gate/reading.hpp"

#include "reports/cli/errors.hpp"
#include "reports/history/gate/process.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>

namespace halfway::gate {
namespace {

using nlohmann::json;

/// Google Benchmark writes numbers that are none as words that are no JSON.
std::string without_words(const std::string& text) {
  static const std::regex word(R"re((:\s*)-?(NaN|nan|Infinity|inf)\b)re");
  return std::regex_replace(text, word, "$1null");
}

double number(const json& row, const char* key) {
  const auto found = row.find(key);
  return found != row.end() && found->is_number() ? found->get<double>()
                                                  : std::numeric_limits<double>::quiet_NaN();
}

double ns_of(const json& row) {
  if (row.contains("per_evaluation")) return 1e9 * number(row, "per_evaluation");
  static const std::map<std::string, double> units{{"ns", 1}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}};
  return number(row, "cpu_time") * units.at(row.value("time_unit", "ns"));
}

void include(Timed& figure, const json& row) {
  if (row.value("error_occurred", false)) {
    figure.wrong = row.value("error_message", "no reason given");
    return;
  }
  const double ns = ns_of(row);
  if (!(std::isfinite(ns) && ns > 0)) figure.wrong = fmt::format("a time of {} ns", ns);
  if (!(figure.ns <= ns)) figure.ns = ns;
  figure.error = number(row, "max_error");
}

std::vector<std::string> words(const std::filesystem::path& program, const BenchOptions& o,
                               const std::filesystem::path& out) {
  const std::string file = program.filename();
  if (file == "halfway-suite")
    return {program,         "bench",
            "--filter",      o.filter,
            "--min-time",    fmt::format("{}", o.min_time),
            "--repetitions", fmt::format("{}", o.repetitions),
            "--json",        out};
  return {program,
          "--benchmark_filter=" + o.filter,
          fmt::format("--benchmark_min_time={}", o.min_time),
          fmt::format("--benchmark_repetitions={}", o.repetitions),
          "--benchmark_enable_random_interleaving=true",
          "--benchmark_out_format=json",
          "--benchmark_out=" + out.string()};
}

}  // namespace

Reading read_benchmarks(const std::string& text, const std::string& what) {
  Reading out;
  try {
    const json root = json::parse(without_words(text));
    for (const json& row : root.at("benchmarks")) {
      if (row.value("run_type", "iteration") == "iteration")
        include(out[row.value("run_name", row.at("name").get<std::string>())], row);
    }
  } catch (const std::exception& error) {
    throw reports::FailedRun(fmt::format("{}: no JSON of Google Benchmark: {}", what, error.what()));
  }
  if (out.empty())
    throw reports::FailedRun(fmt::format("{}: measured nothing: no figure matches the filter", what));
  for (auto& [name, figure] : out)
    if (!figure.wrong.empty()) figure.ns = std::numeric_limits<double>::quiet_NaN();
  return out;
}

Reading measure(const std::filesystem::path& program, const BenchOptions& options,
                const std::filesystem::path& folder) {
  const auto out = folder / "bench.json";
  std::filesystem::remove(out);
  // Checked before it is timed, in every process: at every fourth pose.
  std::map<std::string, std::string> environment{{"HALFWAY_EFFORT", "quick"}};
  if (options.slower >= 0) environment["HALFWAY_BENCH_SLOWER"] = fmt::format("{}", options.slower);
  const std::string failed =
      run(words(program, options, out), folder / "bench.log", options.time_limit, environment);
  if (!failed.empty()) throw reports::FailedRun(fmt::format("{} {}", program.string(), failed));
  if (!std::filesystem::exists(out))
    throw reports::FailedRun(fmt::format("{} wrote no JSON: is it a benchmark program?", program.string()));
  return read_benchmarks(reports::read_file(out), program.string());
}

std::string filter_of(const std::vector<std::string>& names) {
  static const std::regex special(R"re([.^$|()\[\]{}*+?\\])re");
  std::string out;
  for (const std::string& name : names)
    out += (out.empty() ? "" : "|") + std::regex_replace(name, special, R"(\$&)");
  return "^(" + out + ")$";
}

const std::vector<std::string>& fast_figures() {
  static const std::vector<std::string> names{
      "attached_a/angular/residual",
      "invariant/linear/residual_tangent",
      "intrinsic/linear_angular/residual",
      "attached_a/angular/residual/kernel",
      "invariant/linear/residual_tangent/kernel",
      "intrinsic/linear_angular/residual_tangent/kernel",
      "conformal/angular/residual_tangent/kernel",
      "invariant/angular/residual/batch/sse2/no_ends/256",
      "invariant/linear/residual_tangent/batch/avx2/no_ends/256",
      "intrinsic/angular/residual/batch/avx512/no_ends/256",
      "c1_skewed_torque/invariant/equilibrium_newton",
      "c1_skewed_torque/attached_a/equilibrium_newton/kernel",
  };
  return names;
}

}  // namespace halfway::gate
