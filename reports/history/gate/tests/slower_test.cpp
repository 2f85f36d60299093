// The seeded slow-down: evaluations are counted, no clock is asked.
#include "bench/harness/slower.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

using namespace halfway::bench;

namespace {

/// Keeps what a run reports, and prints nothing.
struct Keeper : benchmark::BenchmarkReporter {
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& all) override { runs = all; }
  std::vector<Run> runs;
};

/// Evaluations over iterations of a case that is made slower.
double evaluations(double share) {
  static std::int64_t made = 0;
  Case c;
  c.evaluate = [](int n) { made += n; };
  make_slower(c, share);
  benchmark::ClearRegisteredBenchmarks();
  benchmark::RegisterBenchmark("counted", [c](benchmark::State& state) {
    made = 0;
    c.timed(state);
  })->Iterations(10000);
  Keeper keeper;
  BOOST_TEST_REQUIRE(benchmark::RunSpecifiedBenchmarks(&keeper, "counted") == 1u);
  BOOST_TEST_REQUIRE(keeper.runs.size() == 1u);
  BOOST_TEST(keeper.runs[0].iterations == 10000);
  BOOST_TEST(double(keeper.runs[0].counters.at("evaluated_again")) == share,
             boost::test_tools::tolerance(1e-3));
  return double(made) / 10000;
}

std::optional<double> asked(const char* text) {
  setenv("HALFWAY_BENCH_SLOWER", text, 1);
  return seeded_share();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(slower)

BOOST_AUTO_TEST_CASE(so_many_evaluations_more) {
  BOOST_TEST(evaluations(0.10) == 1.10, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(evaluations(0.03) == 1.03, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(evaluations(0) == 1.0);
}

BOOST_AUTO_TEST_CASE(only_when_asked) {
  unsetenv("HALFWAY_BENCH_SLOWER");
  BOOST_TEST(!seeded_share());
  BOOST_TEST(asked("0.1").value() == 0.1);
  BOOST_TEST(asked("0").value() == 0);
  for (const char* wrong : {"", "x", "10 %", "-0.1", "1.5", "nan", "0.1 "})
    BOOST_CHECK_THROW(asked(wrong), std::runtime_error);
  unsetenv("HALFWAY_BENCH_SLOWER");
  Case c;  // without `evaluate` it stays as it is
  make_slower(c, 0.1);
  BOOST_TEST(!c.timed);
}

BOOST_AUTO_TEST_SUITE_END()
