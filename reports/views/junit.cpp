#include "reports/views/tally.hpp"
#include "reports/views/writers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reports {
namespace {

using reference::Finding;
using reference::Verdict;

/// Text of an attribute or element. XML 1.0 has no way to write most control characters: dropped.
std::string xml_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\t':
        out += "&#9;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

std::string test_case(const Finding& finding) {
  const std::string open = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                       xml_text(finding.subject), xml_text(finding.name));
  const std::string why = xml_text(explain(finding));
  switch (finding.verdict) {
    case Verdict::fail:
      return open + fmt::format(">\n      <failure type=\"finding\">{}</failure>\n    </testcase>\n", why);
    case Verdict::left_out:
      return open + fmt::format(">\n      <skipped message=\"{}\"/>\n    </testcase>\n", why);
    case Verdict::known_failure:
      return open + fmt::format(
                        ">\n      <system-out>known failure, inside its band: {}</system-out>\n"
                        "    </testcase>\n",
                        why);
    default:
      return open + "/>\n";
  }
}

int wrong_timings(const std::vector<bench::Timing>& timings) {
  return static_cast<int>(
      std::count_if(timings.begin(), timings.end(), [](const auto& t) { return t.wrong; }));
}

/// Benchmarks check a result before they time it: a wrong one fails here too.
std::string benchmark_suite(const std::vector<bench::Timing>& timings) {
  if (timings.empty()) return "";
  std::string cases;
  for (const bench::Timing& timing : timings) {
    const std::string open =
        fmt::format("    <testcase classname=\"benchmark\" name=\"{}\"", xml_text(timing.name));
    cases += timing.wrong
                 ? fmt::format("{}>\n      <failure type=\"benchmark\">{}</failure>\n    </testcase>\n", open,
                               xml_text(timing.message))
                 : open + "/>\n";
  }
  return fmt::format(
      "  <testsuite name=\"benchmark\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n{}  "
      "</testsuite>\n",
      timings.size(), wrong_timings(timings), cases);
}

/// Subjects in the order in which they first occur.
std::vector<std::string> subjects(const std::vector<Finding>& findings) {
  std::vector<std::string> out;
  for (const Finding& finding : findings)
    if (std::find(out.begin(), out.end(), finding.subject) == out.end()) out.push_back(finding.subject);
  return out;
}

}  // namespace

std::string junit_xml(const Results& results) {
  const Tally all = tally(results.findings);
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"halfway\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
      all.total() + static_cast<int>(results.timings.size()), all.fail + wrong_timings(results.timings));
  for (const std::string& subject : subjects(results.findings)) {
    std::vector<Finding> group;
    std::copy_if(results.findings.begin(), results.findings.end(), std::back_inserter(group),
                 [&](const Finding& finding) { return finding.subject == subject; });
    const Tally count = tally(group);
    xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n",
                       xml_text(subject), count.total(), count.fail, count.left_out);
    for (const Finding& finding : group) xml += test_case(finding);
    xml += "  </testsuite>\n";
  }
  return xml + benchmark_suite(results.timings) + "</testsuites>\n";
}

}  // namespace halfway::reports
