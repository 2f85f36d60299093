#include "reports/history/exchange/exchange.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

namespace halfway::history {
namespace {

struct Suite {
  std::string cases{};
  int tests = 0, failures = 0, skipped = 0;
};

std::string message(const Record::Exact& exact) {
  const Reading& r = exact.reading;
  const std::string value = fmt::format("{} {}", r.value, exact.figure.unit);
  switch (r.comparison) {
    case Comparison::at_most:
      return fmt::format("{}; at most {}", value, r.high);
    case Comparison::at_least:
      return fmt::format("{}; at least {}", value, r.low);
    case Comparison::within:
      return fmt::format("{}; within {} and {}", value, r.low, r.high);
    case Comparison::equal:
      return fmt::format("{}; {} within {}", value, r.expected, r.high);
    default:
      return value;
  }
}

void add(Suite& suite, const std::string& group, const std::string& name, Verdict verdict,
         const std::string& why) {
  ++suite.tests;
  const auto to = std::back_inserter(suite.cases);
  fmt::format_to(to, "    <testcase classname=\"{}\" name=\"{}\"", xml_text(group), xml_text(name));
  if (verdict == Verdict::fail) {
    ++suite.failures;
    fmt::format_to(to, ">\n      <failure type=\"figure\">{}</failure>\n    </testcase>\n", xml_text(why));
  } else if (verdict == Verdict::left_out) {
    ++suite.skipped;
    fmt::format_to(to, "><skipped message=\"left out\"/></testcase>\n");
  } else {
    fmt::format_to(to, "/>\n");
  }
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '>' || c == '"')
      fmt::format_to(std::back_inserter(out), "&#{};", int(c));
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

std::string junit_xml(const Selection& s) {
  std::map<std::string, Suite> suites;
  int tests = 0, failures = 0;
  for (const Record::Exact& exact : s.exact) {
    const std::string group = exact.figure.name.substr(0, exact.figure.name.find('/'));
    add(suites[group], group, exact.figure.name, exact.reading.verdict, message(exact));
    ++tests, failures += exact.reading.verdict == Verdict::fail;
  }
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"halfway {}\" "
      "tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
      xml_text(s.run.commit), tests, failures);
  const std::string date = s.run.date.substr(0, s.run.date.find('Z'));
  for (const auto& [name, suite] : suites)
    out += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" "
        "timestamp=\"{}\" hostname=\"{}\">\n{}  </testsuite>\n",
        xml_text(name), suite.tests, suite.failures, suite.skipped, date, xml_text(s.series.machine.cpu),
        suite.cases);
  return out + "</testsuites>\n";
}

}  // namespace halfway::history
