// Two reports that differ in one field: what that is called.
#include "reports/cli/errors.hpp"
#include "reports/history/gate/record.hpp"
#include "reports/history/gate/tests/fake.hpp"
#include "reports/views/files.hpp"

#include <boost/test/unit_test.hpp>

using namespace halfway;
using namespace halfway::gate;
using namespace halfway::gate::test;
using nlohmann::json;

namespace {

/// The one line of a comparison in which `field` of the later report is `value`; "=" without a line.
std::string seen(const char* field, const json& value) {
  const Scratch scratch;
  json after = small_report();
  after[json::json_pointer(field)] = value;
  const Outcome outcome = compare(read_report(write_report(scratch.folder() / "a", small_report())),
                                  read_report(write_report(scratch.folder() / "b", after)));
  BOOST_TEST_REQUIRE(outcome.lines.size() <= 1u);
  if (outcome.lines.empty()) return "=";
  const Line& line = outcome.lines[0];
  const char* sign = line.sense == Sense::regression ? "-" : line.sense == Sense::improvement ? "+" : "~";
  return sign + line.figure + ": " + line.text;
}

std::string refusal(const std::string& text) {
  const Scratch scratch;
  reports::write_file(scratch.folder() / "results.json", text);
  try {
    read_report(scratch.folder());
    return "accepted";
  } catch (const reports::BadInput& error) {
    return error.what();
  }
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(compare_reports)

BOOST_AUTO_TEST_CASE(one_field) {
  BOOST_TEST(seen("/findings/0/value", 1e-14) == "=");
  BOOST_TEST(seen("/findings/0/value", 3e-14) == "~most: 1e-14 -> 3e-14, 0.5 digits lost");
  BOOST_TEST(seen("/findings/0/value", 3e-13) == "-most: 1e-14 -> 3e-13, 1.5 digits lost");
  BOOST_TEST(seen("/findings/0/value", 1e-15) == "+most: 1e-14 -> 1e-15, 1.0 digits gained");
  BOOST_TEST(seen("/findings/0/value", nullptr) == "-most: 1e-14 -> not measured");
  BOOST_TEST(seen("/findings/0/high", 1e-11) == "-most: limit 1e-12 -> 1e-11");
  BOOST_TEST(seen("/findings/0/verdict", "fail") == "-most: pass -> fail; 1e-14 -> 1e-14");
  BOOST_TEST(seen("/findings/0/verdict", "left_out") == "-most: pass -> left_out; 1e-14 -> 1e-14");
  BOOST_TEST(seen("/findings/1/value", 1 - 2e-9).starts_with("-equal: 1.0000000001 -> 0.999999998"));
  BOOST_TEST(seen("/findings/2/low", 3) == "-least: limit -4 -> -3");
  BOOST_TEST(seen("/findings/2/value", 4.5) == "~least: 5 -> 4.5");
  BOOST_TEST(seen("/findings/3/high", 0.8).starts_with("-band: limit"));
  BOOST_TEST(seen("/findings/4/value", 70) == "~shown: 7 -> 70");
  BOOST_TEST(seen("/timings/0/ns", 500) == "=");  // runs apart: never judged
  BOOST_TEST(seen("/timings/0/flops", 306.75) == "-t/flops: 306.5 -> 306.75");
  BOOST_TEST(seen("/curves/0/iterations", 21) == "-s/f/iterations: 20 -> 21");
  BOOST_TEST(seen("/timings/0/error", 1e-14) == "-t/error: 1e-16 -> 1e-14, 1.7 digits lost");
}

BOOST_AUTO_TEST_CASE(gone_and_new) {
  const Scratch scratch;
  json after = small_report();
  after["findings"][0]["name"] = "renamed";
  const auto record = [&](const json& report) { return read_report(write_report(scratch.folder(), report)); };
  const Record before = record(small_report());
  const Outcome outcome = compare(before, record(after));
  BOOST_TEST(outcome.count(Sense::regression) == 1);
  BOOST_TEST(outcome.count(Sense::change) == 1);
  BOOST_TEST(has(as_text(outcome, false), "REGRESSION most: gone"));
  BOOST_TEST(has(as_text(outcome, true), "changed renamed: new"));
  after["findings"][0]["verdict"] = "fail";
  BOOST_TEST(compare(before, record(after)).count(Sense::regression) == 2);
  after["findings"] = {after["findings"][0]}, after["timings"] = after["curves"] = json::array();
  BOOST_CHECK_THROW(compare(before, record(after)), reports::FailedRun);
}

// Another compiler rounds otherwise: verdicts and limits still count.
BOOST_AUTO_TEST_CASE(another_series) {
  const Scratch scratch;
  json after = small_report();
  after["context"]["compiler"] = "clang++";
  after["findings"][0]["value"] = 3e-13;
  const Record before = read_report(write_report(scratch.folder() / "a", small_report()));
  const Outcome same = compare(before, read_report(write_report(scratch.folder() / "b", after)));
  BOOST_TEST(same.lines.empty());
  BOOST_TEST(has(as_text(same, false), "verdicts and limits alone"));
  after["findings"][0]["verdict"] = "fail";
  BOOST_TEST(compare(before, read_report(write_report(scratch.folder() / "b", after))).lines.size() == 1u);
}

// A limit made of the run's own numbers moves a little; one that somebody widened moves more. What one
// instruction set has is not there with another.
BOOST_AUTO_TEST_CASE(another_instruction_set) {
  const auto sense = [](bool alike, const std::string& old_name, double limit, bool there) {
    const Scratch scratch;
    json before = small_report(), after = small_report();
    before["findings"][0]["name"] = after["findings"][0]["name"] = old_name;
    after["findings"][0]["high"] = limit;
    if (!there) after["findings"].erase(0);
    if (!alike) after["context"]["compiler"] = "clang++";
    const Outcome outcome = compare(read_report(write_report(scratch.folder() / "a", before)),
                                    read_report(write_report(scratch.folder() / "b", after)));
    BOOST_TEST_REQUIRE(outcome.lines.size() == 1u);
    return outcome.lines[0].sense;
  };
  BOOST_TEST((sense(true, "drift", 1.5e-12, true) == Sense::regression));
  BOOST_TEST((sense(false, "drift", 1.5e-12, true) == Sense::change));
  BOOST_TEST((sense(false, "drift", 2.1e-12, true) == Sense::regression));
  BOOST_TEST((sense(true, "f/batch/avx512/no_ends", 1e-12, false) == Sense::regression));
  for (const char* name : {"f/batch/avx512/no_ends", "f/batch_avx2_residual", "avx2vl"})
    BOOST_TEST((sense(false, name, 1e-12, false) == Sense::change), name);
  for (const char* name : {"f/batch/no_ends", "f/avx5120", "savx2"})
    BOOST_TEST((sense(false, name, 1e-12, false) == Sense::regression), name);
}

BOOST_AUTO_TEST_CASE(refused_by_name) {
  json report = small_report();
  report["findings"][1].erase("high");
  BOOST_TEST(has(refusal(report.dump()), "high"));
  BOOST_TEST(has(refusal(report.dump()), "results.json"));
  report = small_report(), report["version"] = 2;
  BOOST_TEST(has(refusal(report.dump()), "version"));
  report = small_report(), report["findings"][1]["name"] = "most";
  BOOST_TEST(has(refusal(report.dump()), "there are two figures 'most'"));
  BOOST_TEST(has(refusal("{"), "parse error"));
  BOOST_CHECK_THROW(read_report("/nowhere"), reports::BadInput);
}

// Another processor: libraries round otherwise there, and an iteration may take a step more.
BOOST_AUTO_TEST_CASE(another_machine) {
  const Scratch scratch;
  json after = small_report();
  after["context"]["machine"] = "another, 2 cores";
  after["curves"][0]["iterations"] = 21;
  const Record before = read_report(write_report(scratch.folder() / "a", small_report()));
  const Outcome steps = compare(before, read_report(write_report(scratch.folder() / "b", after)));
  BOOST_TEST(steps.count(Sense::regression) == 0);
  BOOST_TEST(has(as_text(steps, true), "changed s/f/iterations: 20 -> 21"));
  BOOST_TEST(has(as_text(steps, false), "another processor (m | another)"));
  after["findings"][0]["value"] = 3e-13;
  BOOST_TEST(compare(before, read_report(write_report(scratch.folder() / "b", after))).lines.size() == 2u);
}

// What a quick report leaves out is not gone.
BOOST_AUTO_TEST_CASE(partial_reports) {
  const Scratch scratch;
  json after = small_report();
  after["command"] = "./halfway report --quick";
  after["findings"].erase(4);
  const auto outcome = [&] {
    return compare(read_report(write_report(scratch.folder() / "a", small_report())),
                   read_report(write_report(scratch.folder() / "b", after)));
  };
  BOOST_TEST(outcome().lines.empty());
  BOOST_TEST(has(as_text(outcome(), false), ": 1 of 8 figures"));
  after["findings"][0]["verdict"] = "fail";
  BOOST_TEST(outcome().count(Sense::regression) == 1);
}

// What names may do to a service that reads them.
BOOST_AUTO_TEST_CASE(names_are_text) {
  Outcome outcome{.title = "a"};
  outcome.lines.push_back({Sense::regression, "a:b,\n::error::x|<script>", "50 %\x1b[2J"});
  outcome.lines.push_back({Sense::improvement, "better", "fine"});
  const std::string github = annotations(outcome, Service::github);
  BOOST_TEST(
      github ==
      "::error title=a%3Ab%2C%0A%3A%3Aerror%3A%3Ax|<script>::a:b,%0A::error::x|<script>: 50 %25\x1b[2J\n");
  BOOST_TEST(annotations(outcome, Service::azure).starts_with("##vso[task.logissue type=error]a:b,%0A"));
  BOOST_TEST(annotations(outcome, Service::none).empty());
  BOOST_TEST(has(as_markdown(outcome), "\\|&lt;script&gt;"));
  BOOST_TEST(!has(as_markdown(outcome), "\x1b"));
  BOOST_TEST(!has(as_text(outcome, true), "\x1b"));
  const json quality = json::parse(code_quality(outcome));
  BOOST_TEST(quality.size() == 1u);
  for (const char* key : {"description", "check_name", "fingerprint", "severity", "location"})
    BOOST_TEST(quality[0].contains(key));
  BOOST_CHECK_THROW(service_of("travis"), reports::BadInput);
}

BOOST_AUTO_TEST_SUITE_END()
