#include "reports/cli/errors.hpp"
#include "reports/history/exchange/exchange.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace halfway::history {
namespace {

/// A field as RFC 4180 has it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// Empty: there is none.
std::string cell(double x) { return std::isfinite(x) ? fmt::format("{}", x) : ""; }

/// Value of a label as OpenMetrics has it.
std::string label(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '\\' ? "\\\\" : c == '"' ? "\\\"" : c == '\n' ? "\\n" : std::string(1, c);
  return out;
}

struct Family {
  const char *name, *unit, *help;
  std::string samples{};
  void add(const std::string& figure, const std::string& more, double value) {
    if (!std::isfinite(value)) return;
    fmt::format_to(std::back_inserter(samples), "{}{{figure=\"{}\"{}}} {}\n", name, label(figure), more,
                   value);
  }
  std::string text() const {
    if (samples.empty()) return "";
    const std::string of_unit = *unit ? fmt::format("# UNIT {} {}\n", name, unit) : "";
    return fmt::format("# TYPE {0} gauge\n{1}# HELP {0} {2}\n{3}", name, of_unit, help, samples);
  }
};

std::string row(const Run& run, const Figure& f, const std::string& rest) {
  return fmt::format("{},{},{},{},{},{},{}\n", run.id, field(run.commit), run.date, field(f.name),
                     to_string(f.kind), field(f.unit), rest);
}

std::string exact_row(const Run& run, const Figure& f, const Reading& r) {
  return row(run, f,
             fmt::format("{},{},{},,{}", cell(r.value), cell(r.low), cell(r.high), to_string(r.verdict)));
}

std::string time_row(const Run& run, const Figure& f, const Time& t) {
  return row(run, f, fmt::format("{},{},{},{},none", t.ns(), cell(t.low_ns()), cell(t.high_ns()), t.n));
}

constexpr std::size_t kMeasurements = 10;  ///< CDash groups by test: more are no picture

std::string measurement(const std::string& name, double value) {
  return fmt::format("<CTestMeasurement type=\"numeric/double\" name=\"{}\">{}</CTestMeasurement>\n",
                     xml_text(name), value);
}

std::string summary(const Selection& s) {
  int count[6] = {};
  for (const Record::Exact& exact : s.exact) ++count[int(exact.reading.verdict)];
  double logs = 0;
  for (const Record::Timed& timed : s.timed) logs += std::log(timed.time.ns());
  std::string out = measurement("figures", double(s.exact.size() + s.timed.size()));
  for (const Verdict v : {Verdict::pass, Verdict::known_failure, Verdict::fail, Verdict::left_out})
    out += measurement(to_string(v), count[int(v)]);
  if (!s.timed.empty())
    out += measurement("geometric mean of times, ns", std::exp(logs / double(s.timed.size())));
  return out;
}

}  // namespace

std::string open_metrics(const Selection& s) {
  Family time{"halfway_time_seconds", "seconds",
              "Processor time per joint or solve, median of the repetitions"};
  Family value{"halfway_value", "", "What a finding came to"};
  Family digits{"halfway_error_digits", "digits", "Decimal digits of an error"};
  for (const Record::Timed& timed : s.timed)
    time.add(timed.figure.name, "", double(timed.time.median) / 1e12);
  for (const Record::Exact& exact : s.exact) {
    value.add(exact.figure.name, fmt::format(",unit=\"{}\"", label(exact.figure.unit)), exact.reading.value);
    digits.add(exact.figure.name, "", digits_of(error_of(exact.reading)));
  }
  return time.text() + value.text() + digits.text() + "# EOF\n";
}

std::string ctest_measurements(const Selection& s, bool is_chosen) {
  if (!is_chosen) return summary(s);
  std::string out;
  std::size_t count = 0;
  const auto add = [&](const std::string& name, double value) {
    if (!std::isfinite(value)) return;
    ++count;
    out += measurement(name, value);
  };
  for (const Record::Timed& timed : s.timed) add(timed.figure.name + ", ns", timed.time.ns());
  for (const Record::Exact& exact : s.exact) add(exact.figure.name, exact.reading.value);
  if (count == 0) throw reports::BadInput("--figure: no finite number is chosen");
  if (count > kMeasurements)
    throw reports::BadInput(
        fmt::format("--figure: {} numbers are chosen; a test takes at most {}", count, kMeasurements));
  return out;
}

std::string csv(const History& h, int only, const std::function<bool(const std::string&)>& is_wanted) {
  std::string out = "run,commit,date,figure,kind,unit,value,low,high,repetitions,verdict\n";
  const std::vector<Reading> all = only < 0 ? std::vector<Reading>{} : readings_at(h, only);
  for (std::size_t f = 0; f < h.figures.size(); ++f) {
    const Figure& figure = h.figures[f];
    if (!is_wanted(figure.name)) continue;
    for (const TimeAt& t : h.times[f])
      if (only < 0 || t.run == only) out += time_row(h.runs[t.run], figure, t.time);
    if (only >= 0 && all[f].verdict != Verdict::gone) out += exact_row(h.runs[only], figure, all[f]);
    if (only >= 0) continue;
    for (const ReadingAt& c : h.changes[f]) out += exact_row(h.runs[c.run], figure, c.reading);
  }
  return out;
}

}  // namespace halfway::history
