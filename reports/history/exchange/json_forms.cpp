// The JSON forms of other programs. A number that is none is left out: readers take null for zero.
#include "reports/cli/errors.hpp"
#include "reports/history/exchange/exchange.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace halfway::history {
namespace {

using nlohmann::ordered_json;

std::string text_of(const ordered_json& content, const char* what) {
  // An empty document is valid to most readers and fails, or passes, for the wrong reason.
  if (content.empty()) throw reports::BadInput(fmt::format("no figure of this run is {}", what));
  return content.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json google_row(const std::string& name, std::int64_t ps, std::size_t index, std::size_t count) {
  const double ns = double(ps) / 1e3;
  return {{"name", name},         {"run_name", name},          {"run_type", "iteration"},
          {"repetitions", count}, {"repetition_index", index}, {"threads", 1},
          {"iterations", 1},      {"real_time", ns},           {"cpu_time", ns},
          {"time_unit", "ns"}};
}

}  // namespace

std::string google_json(const Selection& s) {
  ordered_json rows = ordered_json::array();
  for (const Record::Timed& timed : s.timed) {
    const Repetitions all = timed.repetitions.empty() ? Repetitions{timed.time.median} : timed.repetitions;
    for (std::size_t i = 0; i < all.size(); ++i)
      rows.push_back(google_row(timed.figure.name, all[i], i, all.size()));
  }
  if (rows.empty()) throw reports::BadInput("no figure of this run is a time");
  const bool is_release = s.series.build_type == "Release";
  return text_of({{"context",
                   {{"date", s.run.date},
                    {"host_name", s.series.machine.cpu},
                    {"executable", "halfway " + s.run.commit},
                    {"num_cpus", s.series.machine.cores},
                    {"caches", ordered_json::array()},
                    {"library_build_type", is_release ? "release" : "debug"},
                    {"json_schema_version", 1}}},
                  {"benchmarks", rows}},
                 "a time");
}

std::string github_json(const Selection& s) {
  ordered_json out = ordered_json::array();
  for (const Record::Exact& exact : s.exact) {
    const double error = error_of(exact.reading), digits = digits_of(error);
    if (!std::isfinite(digits)) continue;
    const std::string extra =
        fmt::format("error {:.3g} {}, {}", error, exact.figure.unit, to_string(exact.reading.verdict));
    out.push_back({{"name", exact.figure.name}, {"value", digits}, {"unit", "digits"}, {"extra", extra}});
  }
  return text_of(out, "an error that has digits");
}

std::string bmf_json(const Selection& s) {
  ordered_json out = ordered_json::object();
  for (const Record::Timed& timed : s.timed) {
    ordered_json& latency = out[timed.figure.name]["latency"];
    latency["value"] = timed.time.ns();
    if (timed.time.low > 0)
      latency["lower_value"] = timed.time.low_ns(), latency["upper_value"] = timed.time.high_ns();
  }
  for (const Record::Exact& exact : s.exact) {
    const bool is_count = exact.figure.kind == Kind::count;
    const double value = is_count ? exact.reading.value : digits_of(error_of(exact.reading));
    if (std::isfinite(value)) out[exact.figure.name][is_count ? "count" : "digits"]["value"] = value;
  }
  return text_of(out, "a time, a count, or an error that has digits");
}

}  // namespace halfway::history
