// Reports become records; what is wrong with one is named.
#include "reports/history/intake/intake.hpp"
#include "reports/cli/errors.hpp"
#include "reports/history/tests/support.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace halfway;
using namespace halfway::history;
using namespace halfway::history::test;
using nlohmann::json;

namespace {

json report() {
  return json::parse(R"({"schema": "halfway-results", "version": 1, "command": "./halfway report",
    "context": {"machine": "a processor, 4 cores", "compiler": "g++ 12", "flags": "-O3", "commit": "abc123+changes",
                "date": "2026-01-02T03:04:05Z", "build_type": "Release"},
    "findings": [{"name": "f/angular/x", "formulation": "f", "value": 1e-15, "unit": "eps", "comparison": "at_most",
                  "expected": 0, "low": 0, "high": 1e-12, "verdict": "pass"},
                 {"name": "none", "formulation": "", "value": null, "unit": "", "comparison": "equal",
                  "expected": 2, "low": 0, "high": 0.5, "verdict": "left_out"}],
    "timings": [{"name": "f/angular/residual", "formulation": "f", "isa": "avx2", "ns": 100.0, "error": 1e-16,
                 "flops": 12, "wrong": false},
                {"name": "g", "formulation": "", "isa": "", "ns": null, "error": null, "flops": 0, "wrong": true}],
    "curves": [{"scene": "c", "formulation": "f", "xi": 0.5, "iterations": 7},
               {"scene": "c", "formulation": "f", "xi": 0.25, "iterations": 8},
               {"scene": "c", "formulation": "linearized", "xi": 0.5, "iterations": 0}]})");
}

json bench() {
  return json::parse(
      R"({"context": {"load_avg": [1.5, 1, 1], "caches": [{"type": "Data", "level": 1, "size": 32768},
                                                                       {"type": "Unified", "level": 3, "size": 33554432}]},
    "benchmarks": [
      {"name": "f/angular/residual/real_time", "run_type": "iteration", "cpu_time": 25600, "per_evaluation": 9.9e-8},
      {"name": "f/angular/residual/real_time", "run_type": "iteration", "cpu_time": 25600, "per_evaluation": 1e-7},
      {"name": "f/angular/residual/real_time", "run_type": "iteration", "cpu_time": 25600, "per_evaluation": 1.04e-7},
      {"name": "f/angular/residual_cv", "run_type": "aggregate", "cpu_time": 0.07, "time_unit": "ns"},
      {"name": "g", "run_type": "iteration", "error_occurred": true, "error_message": "wrong"}]})");
}

Added read(const json& results, const std::string& bench_text = "") {
  const TemporaryFolder folder;
  write_bytes(folder / "results.json", results.dump());
  if (!bench_text.empty()) write_bytes(folder / "bench.json", bench_text);
  return read_report(folder / "");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(intake)

BOOST_AUTO_TEST_CASE(a_report) {
  const Record r = read(report(), bench().dump()).record;
  BOOST_TEST(r.run.commit == "abc123");
  BOOST_TEST(r.run.dirty);
  BOOST_TEST(r.run.load == 1.5);
  BOOST_TEST(r.series.machine.cpu == "a processor");
  BOOST_TEST(r.series.machine.cores == 4);
  BOOST_TEST(r.series.machine.caches == "L1d 32 KiB, L3 32 MiB");
  BOOST_TEST(r.series.isa == "avx2");
  const Record::Timed& t = r.timed.at("f/angular/residual");
  BOOST_TEST((t.time == Time{.median = 100000, .low = 990, .high = 1040, .n = 3}));
  BOOST_TEST((t.repetitions == Repetitions{99000, 100000, 104000}));
  BOOST_TEST(!r.timed.contains("g"));
  BOOST_TEST(r.exact.at("f/angular/residual/flops").reading.value == 12);
  BOOST_TEST((r.exact.at("f/angular/residual/flops").figure.kind == Kind::count));
  BOOST_TEST((r.exact.at("g/error").reading.verdict == Verdict::fail));
  BOOST_TEST(std::isnan(r.exact.at("none").reading.value));
  BOOST_TEST((r.exact.at("f/angular/x").figure.better == Better::down));
  BOOST_TEST(r.exact.at("c/f/iterations").reading.value == 7);
  BOOST_TEST(r.exact.at("c/f/iterations/xi=0.25").reading.value == 8);
  BOOST_TEST(!r.exact.contains("c/linearized/iterations"));
}

BOOST_AUTO_TEST_CASE(without_repetitions_the_spread_is_not_known) {
  const Record r = read(report()).record;
  BOOST_TEST((r.timed.at("f/angular/residual").time == Time{.median = 100000}));
}

/// Google Benchmark writes bytes of freed memory and words for numbers.
BOOST_AUTO_TEST_CASE(broken_text_of_google_benchmark_is_read) {
  std::string text = bench().dump();
  text.insert(text.find("\"load_avg\""), "\"executable\": \"\xf1\x01\xfe\", \"x\": nan, ");
  BOOST_TEST(read(report(), text).record.timed.at("f/angular/residual").time.n == 3);
}

BOOST_AUTO_TEST_CASE(a_quick_report_has_no_times_and_is_partial) {
  json quick = report();
  quick["command"] = "./halfway report --quick";
  const Added added = read(quick, bench().dump());
  BOOST_TEST(added.record.timed.empty());
  BOOST_TEST(added.record.is_partial);
  BOOST_TEST(!added.note.empty());
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_named) {
  const auto check = [](const char* pointer, const json& value, const std::string& why) {
    json wrong = report();
    wrong[json::json_pointer(pointer)] = value;
    const std::string text = complaint([&] { read(wrong, bench().dump()); });
    BOOST_TEST(text.find("results.json: " + why) != std::string::npos, pointer << ": " << text);
    BOOST_CHECK_THROW(read(wrong), reports::BadInput);
  };
  check("/schema", "other", "schema, version");
  check("/context/date", "yesterday", "context: date 'yesterday'; allowed: UTC such as");
  check("/context/commit", 7, "context: ");
  check("/findings/1/name", "f/angular/x", "findings[1]: name: there are two figures 'f/angular/x'");
  check("/findings/1/verdict", "perhaps", "findings[1]: verdict 'perhaps'; allowed: ");
  check("/findings/0/value", "much", "findings[0]: ");
  check("/timings/0/ns", 0, "timings[0]: ns: 0 is no time");
  check("/curves", json::object({{"a", 1}}), "curves[0]: ");
}

BOOST_AUTO_TEST_CASE(repetitions_of_another_run_are_refused) {
  json wrong = report();
  wrong["timings"][0]["ns"] = 50;
  const std::string text = complaint([&] { read(wrong, bench().dump()); });
  BOOST_TEST(text.find("not among the repetitions") != std::string::npos, text);
  const std::string no_json = complaint([&] { read(report(), "{"); });
  BOOST_TEST(no_json.find("bench.json: not what Google Benchmark writes") != std::string::npos, no_json);
}

BOOST_AUTO_TEST_CASE(nothing_but_a_commit_reaches_the_shell) {
  BOOST_TEST(subject_of("abcd; touch /nowhere").empty());
  BOOST_TEST(subject_of("").empty());
}

BOOST_AUTO_TEST_SUITE_END()
