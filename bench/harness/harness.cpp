#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "bench/harness/case.hpp"
#include "bench/harness/context.hpp"
#include "bench/harness/timing.hpp"
#include "bench/peak/parallel.hpp"

namespace halfway::bench {
namespace {

/// Median and coefficient of variation.
struct Statistics {
  double median = 0, spread = 0;
};

Statistics statistics(std::vector<double> times) {
  std::ranges::sort(times);
  const std::size_t n = times.size();
  const double median = (times[(n - 1) / 2] + times[n / 2]) / 2;
  double sum = 0, squares = 0;
  for (const double t : times) sum += t;
  for (const double t : times) squares += (t - sum / n) * (t - sum / n);
  return {median, n > 1 ? std::sqrt(squares / (n - 1)) / (sum / n) : 0};
}

/// Google Benchmark's own JSON, written to a temporary file that takes its name when complete.
class JsonFile {
 public:
  explicit JsonFile(const std::string& file) : file_(file), part_(file + ".part") {
    if (file_.empty()) return;
    stream_.open(part_);
    if (!stream_) throw std::runtime_error(fmt::format("cannot write {}", part_));
    json_.SetOutputStream(&stream_);
    json_.SetErrorStream(&stream_);
  }
  benchmark::BenchmarkReporter* reporter() { return file_.empty() ? nullptr : &json_; }
  void finish() {
    if (file_.empty()) return;
    stream_.close();
    if (!stream_) throw std::runtime_error(fmt::format("cannot write {}", part_));
    std::filesystem::rename(part_, file_);
  }

 private:
  std::string file_, part_;
  std::ofstream stream_;
  benchmark::JSONReporter json_;
};

/// Turns the runs of each case into a Timing, and hands them on to the JSON reporter.
class Collector : public benchmark::BenchmarkReporter {
 public:
  Collector(const Cases& cases, benchmark::BenchmarkReporter* json,
            std::function<void(const std::string&)> done)
      : json_(json), done_(std::move(done)) {
    for (const Case& c : cases) cases_[c.name] = &c;
  }

  bool ReportContext(const Context& context) override {
    return json_ == nullptr || json_->ReportContext(context);
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    if (json_ != nullptr) json_->ReportRuns(runs);
    // The aggregates of the repetitions come in a second call: medians are taken here.
    if (runs.empty() || runs.front().run_type == Run::RT_Aggregate) return;
    const Case& c = *cases_.at(runs.front().run_name.function_name);
    Timing timing;
    static_cast<Label&>(timing) = c;
    timing.flops = c.flops, timing.products = c.products, timing.bytes = c.bytes;
    timing.error = checked(c).error, timing.errors = c.errors ? c.errors() : checked(c).errors;
    std::vector<double> times;
    for (const Run& run : runs) {
      if (run.error_occurred)
        timing.wrong = true, timing.message = run.error_message;
      else if (run.run_type == Run::RT_Iteration)
        times.push_back((c.wall_time ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime()) / c.evaluations);
    }
    if (!times.empty() && !timing.wrong) {
      const auto [median, spread] = statistics(times);
      timing.ns = median, timing.spread = spread;
    }
    timings_[c.name] = timing;
    done_(c.name);
  }

  void Finalize() override {
    if (json_ != nullptr) json_->Finalize();
  }

  const std::map<std::string, Timing>& timings() const { return timings_; }

 private:
  benchmark::BenchmarkReporter* json_;
  std::function<void(const std::string&)> done_;
  std::map<std::string, const Case*> cases_;
  std::map<std::string, Timing> timings_;
};

/// Google Benchmark has no other face for these than its command line.
void set_flags(const Options& options) {
  // Google Benchmark keeps the name of the program and writes it into its JSON at the end.
  static std::vector<std::string> arguments;
  arguments = {"halfway_bench", fmt::format("--benchmark_repetitions={}", options.repetitions),
               fmt::format("--benchmark_min_time={}", options.min_time),
               "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int argc = int(arguments.size());
  benchmark::Initialize(&argc, argv.data());
}

/// Throws std::logic_error of two cases of one name: results and histories know figures by it.
Cases selected_cases(const std::string& filter) {
  const std::regex pattern(filter);
  Cases cases = all_cases();
  std::set<std::string> names;
  for (const Case& c : cases)
    if (!names.insert(c.name).second) throw std::logic_error("two benchmarks are called '" + c.name + "'");
  std::erase_if(cases, [&](const Case& c) { return !std::regex_search(c.name, pattern); });
  return cases;
}

}  // namespace

Run run(const Options& options, const std::function<void(int, int, const std::string&)>& progress) {
  static bool ran = false;
  if (std::exchange(ran, true)) throw std::logic_error("bench::run: once in a process");
  register_all();
  set_flags(options);
  const Cases cases = selected_cases(options.filter);
  const int total = int(cases.size());
  int done = 0;
  JsonFile json(options.json_file);
  Collector collector(cases, json.reporter(),
                      [&](const std::string& name) { progress(++done, total, name); });
  // Checked here and not at the first timing, so that the long part of the run shows progress.
  for (const Case& c : cases) {
    progress(0, total, "checking " + c.name);
    checked(c);
  }
  const Peaks before = measured_peaks();
  const double parallel = measured_parallel();
  benchmark::RunSpecifiedBenchmarks(&collector, options.filter);
  json.finish();

  Run out;
  out.context = context();
  out.peaks = larger(before, measured_peaks());
  out.parallel = std::min(parallel, measured_parallel());
  for (const Case& c : cases) out.timings.push_back(collector.timings().at(c.name));
  return out;
}

}  // namespace halfway::bench
