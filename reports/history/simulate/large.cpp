// halfway_large: the dashboard of a large history that never happened, and what it costs to write; what it
// costs to read is measured by `npm run scale -- PAGE` (reports/page).
//   halfway_large PAGE [RUNS]
#include "reports/history/dashboard/dashboard.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <random>

namespace {

using namespace halfway::history;
using Random = std::mt19937_64;

constexpr int kTimes = 464, kOthers = 4536, kFormulations = 17;
constexpr int kSteps = 3;  ///< of each time, over the whole history: up or down by 10 %

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::string date_of(int run) {
  return fmt::format("{}-{:02}-{:02}T{:02}:00:00Z", 2000 + run / 8064, 1 + run / 672 % 12, 1 + run / 24 % 28,
                     run % 24);
}

/// Heavy-tailed noise of 2 %; of every repetition only the ends are known.
std::vector<TimeAt> times_of(Random& random, int runs) {
  std::student_t_distribution<double> t(3);
  std::vector<double> factors(std::size_t(runs), 1.0);
  for (int i = 0; i < kSteps; ++i)
    factors[std::size_t(uniform(random, 0, runs))] = uniform(random, 0, 1) < 0.5 ? 1.1 : 1 / 1.1;
  std::vector<TimeAt> out;
  double level = std::pow(10, uniform(random, 4, 7));  // ps
  for (int run = 0; run < runs; ++run) {
    level *= factors[std::size_t(run)];
    const double median = level * std::exp(0.02 / std::sqrt(3.0) * t(random));
    out.push_back({run, {std::llround(median), 1000 - int(random() % 20), 1000 + int(random() % 40), 5}});
  }
  return out;
}

/// The luck of rounding changes at one run in a thousand.
std::vector<ReadingAt> readings_of(Random& random, int runs) {
  const double level = std::pow(10, uniform(random, -16, -13));
  std::vector<ReadingAt> out;
  for (int run = 0; run < runs; run += 1 + std::geometric_distribution<int>(1e-3)(random))
    out.push_back({run,
                   {.value = level * uniform(random, 0.3, 3),
                    .comparison = Comparison::at_most,
                    .high = 1e-12,
                    .verdict = Verdict::pass}});
  return out;
}

History large(int runs) {
  Random random(2026);
  History out;
  out.series = {{{"a processor", 2, "L1d 48 KiB", "0x1"}, "g++ 12", "-O3", "Release", "avx2"}};
  for (int run = 0; run < runs; ++run)
    out.runs.push_back({.id = run + 1,
                        .commit = fmt::format("{:016x}", random()),
                        .date = date_of(run),
                        .title = fmt::format("Change number {} of the large history", run),
                        .release = run == runs / 2 ? "1.0.0" : "",
                        .load = 0.25});
  for (int f = 0; f < kTimes + kOthers; ++f) {
    const bool is_time = f < kTimes;
    const int place =
        is_time ? f : f - kTimes;  // the first times and errors are what the scatter is drawn of
    const std::string formulation = fmt::format("formulation_{}", place % kFormulations);
    const char* const what = is_time ? "residual" : "modelling_error";
    const std::string name = place < kFormulations ? fmt::format("{}/angular/{}", formulation, what)
                                                   : fmt::format("{}/{}/{}", formulation, what, place);
    out.figures.push_back({name, is_time ? "ns per joint" : "relative", is_time ? Kind::time : Kind::accuracy,
                           Better::down, formulation});
    out.times.push_back(is_time ? times_of(random, runs) : std::vector<TimeAt>{});
    out.changes.push_back(is_time ? std::vector<ReadingAt>{} : readings_of(random, runs));
  }
  return out;
}

/// Processor seconds that `work` takes: the machine may be shared.
double seconds(const auto& work) {
  const std::clock_t begin = std::clock();
  work();
  return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  int runs = 10000;
  const char* const text = argc == 3 ? argv[2] : "10000";
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), runs);
  if (argc < 2 || argc > 3 || error != std::errc() || *end != 0 || runs < 2)
    return std::fputs("usage: halfway_large PAGE [RUNS], a file and a whole number above 1\n", stderr), 2;
  try {
    const History history = large(runs);
    std::size_t changes = 0;
    const double finding = seconds([&] { changes = find_changes(history).size(); });
    std::string page;
    const double writing = seconds([&] { page = dashboard_html(history, "halfway_large"); });
    halfway::reports::write_file(argv[1], page);
    fmt::print("{} runs of {} times and {} other figures\n", runs, kTimes, kOthers);
    fmt::print("find_changes: {} changes in {:.1f} s\n", changes, finding);
    fmt::print("the page: {:.2f} MB in {:.1f} s, find_changes again among them\n", 1e-6 * double(page.size()),
               writing);
  } catch (const std::exception& failure) {
    return fmt::print(stderr, "halfway_large: {}\n", failure.what()), 2;
  }
}
