// Forms in which others read the history. Each is written from what was kept, never from what a tool wrote.
#pragma once

#include "reports/history/record/history.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::history {

/// One run, with those of its figures that are wanted.
struct Selection {
  Run run;
  Series series;
  std::vector<Record::Exact> exact{};
  std::vector<Record::Timed> timed{};
};
Selection select(const History& history, int run, const std::function<bool(const std::string&)>& is_wanted);

/// Google Benchmark's JSON, for its compare.py: a row a repetition, ns per joint.
std::string google_json(const Selection& selection);
/// github-action-benchmark, customBiggerIsBetter: digits of the errors.
std::string github_json(const Selection& selection);
/// Bencher's metric format: latency of times, digits of errors, count of counts.
std::string bmf_json(const Selection& selection);
/// Gauges for Prometheus, GitLab's metrics report.
std::string open_metrics(const Selection& selection);
/// Jenkins' schema; GitLab reads the text of a failure.
std::string junit_xml(const Selection& selection);
/// Lines that ctest takes from the output of a test, at most ten; without a choice of figures a summary of
/// the run. Throws reports::BadInput of more.
std::string ctest_measurements(const Selection& selection, bool is_chosen);

/// What was kept, a line each: times of each run, other figures where they changed. `run` negative: all.
std::string csv(const History& history, int run, const std::function<bool(const std::string&)>& is_wanted);

/// Text for XML: what it cannot have is dropped.
std::string xml_text(const std::string& text);

}  // namespace halfway::history
