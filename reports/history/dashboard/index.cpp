#include "reports/history/dashboard/dashboard.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace halfway::history {
namespace {

using nlohmann::ordered_json;

ordered_json number(double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); }

/// Of times: more digits are noise.
ordered_json rounded(double x) {
  return std::isfinite(x) ? ordered_json::parse(fmt::format("{:.4g}", x)) : ordered_json(nullptr);
}

template <class Items>
ordered_json column(const Items& items, const auto& of) {
  ordered_json out = ordered_json::array();
  for (const auto& item : items) out.push_back(of(item));
  return out;
}

const char* shown(Verdict v) {
  const bool is_judged = v == Verdict::pass || v == Verdict::fail || v == Verdict::known_failure;
  return is_judged ? to_string(v) : "";
}

void add_series(ordered_json& out, const History& h) {
  std::vector<Machine> machines;
  ordered_json& series = out["series"] = ordered_json::array();
  for (const Series& s : h.series) {
    const auto found = std::ranges::find(machines, s.machine);
    const auto at = found - machines.begin();
    if (found == machines.end()) machines.push_back(s.machine);
    series.push_back({{"machine", at},
                      {"compiler", s.compiler},
                      {"flags", s.flags},
                      {"build_type", s.build_type},
                      {"isa", s.isa}});
  }
  out["machines"] = column(machines, [](const Machine& m) {
    return ordered_json{{"cpu", m.cpu}, {"cores", m.cores}, {"caches", m.caches}, {"microcode", m.microcode}};
  });
}

void add_columns(ordered_json& out, const History& h) {
  out["runs"] = {{"commit", column(h.runs, [](const Run& r) { return r.commit; })},
                 {"date", column(h.runs, [](const Run& r) { return seconds_of(r.date); })},
                 {"title", column(h.runs, [](const Run& r) { return r.title; })},
                 {"dirty", column(h.runs, [](const Run& r) { return int(r.dirty); })},
                 {"series", column(h.runs, [](const Run& r) { return r.series; })},
                 {"load", column(h.runs, [](const Run& r) { return number(r.load); })},
                 {"release", column(h.runs, [](const Run& r) { return r.release; })}};
  out["figures"] = {{"name", column(h.figures, [](const Figure& f) { return f.name; })},
                    {"unit", column(h.figures, [](const Figure& f) { return f.unit; })},
                    {"kind", column(h.figures, [](const Figure& f) { return to_string(f.kind); })},
                    {"better", column(h.figures, [](const Figure& f) { return to_string(f.better); })},
                    {"formulation", column(h.figures, [](const Figure& f) { return f.formulation; })}};
}

/// What holds at the last run of the series: of times the last that was measured.
ordered_json latest_of(const History& h, int series) {
  int run = int(h.runs.size()) - 1;
  while (run > 0 && h.runs[run].series != series) --run;
  const std::vector<Reading> readings = readings_at(h, run);
  ordered_json value = ordered_json::array(), limit = value, verdict = value;
  for (std::size_t f = 0; f < h.figures.size(); ++f) {
    const Reading& r = readings[f];
    ordered_json now = number(r.value);
    if (h.figures[f].kind == Kind::time)
      for (const TimeAt& t : h.times[f])
        if (h.runs[t.run].series == series) now = rounded(t.time.ns());
    value.push_back(now), limit.push_back(number(limit_of(r))), verdict.push_back(shown(r.verdict));
  }
  return {{"run", run}, {"value", value}, {"limit", limit}, {"verdict", verdict}};
}

ordered_json changes_json(const History& h, const std::vector<Change>& changes) {
  return column(changes, [&](const Change& c) {
    const auto value = h.figures[c.figure].kind == Kind::time ? rounded : number;
    return ordered_json{{"figure", c.figure},
                        {"series", c.series},
                        {"run", c.run},
                        {"before", value(c.before)},
                        {"after", value(c.after)},
                        {"verdict", c.is_regression ? "regression" : "improvement"},
                        {"ratio", rounded(c.ratio)},
                        {"digits", rounded(c.digits)},
                        {"p", rounded(c.chance)},
                        {"text", c.text}};
  });
}

/// What accuracy against speed is drawn of: the modelling error, and the loads' time by the kernel, or by the
/// transcription where that alone was timed.
ordered_json pairs_json(const History& h) {
  std::unordered_map<std::string, int> places;
  for (std::size_t f = 0; f < h.figures.size(); ++f) places[h.figures[f].name] = int(f);
  ordered_json out = ordered_json::array();
  for (std::size_t f = 0; f < h.figures.size(); ++f) {
    const Figure& figure = h.figures[f];
    const std::string ending = "/modelling_error", prefix = figure.formulation + "/";
    if (figure.formulation.empty() || !figure.name.starts_with(prefix) || !figure.name.ends_with(ending))
      continue;
    const std::string stem = figure.name.substr(0, figure.name.size() - ending.size());
    for (const char* timed : {"/residual/kernel", "/residual"}) {
      const auto found = places.find(stem + timed);
      if (found == places.end() || h.times[found->second].empty()) continue;
      out.push_back({{"formulation", figure.formulation},
                     {"kind", stem.substr(prefix.size())},
                     {"time", found->second},
                     {"error", f}});
      break;
    }
  }
  return out;
}

ordered_json release_json(const History& h) {
  for (int i = int(h.runs.size()) - 1; i >= 0; --i)
    if (!h.runs[i].release.empty()) return {{"run", i}, {"name", h.runs[i].release}};
  return nullptr;
}

}  // namespace

std::string index_json(const History& h, const std::vector<Change>& changes, const std::string& command,
                       const std::string& generated) {
  ordered_json out = {
      {"schema", "halfway-dashboard"}, {"version", 1}, {"generated", generated}, {"command", command}};
  out["release"] = release_json(h);
  add_series(out, h);
  add_columns(out, h);
  ordered_json& latest = out["latest"] = ordered_json::array();
  for (int s = 0; s < int(h.series.size()); ++s) latest.push_back(latest_of(h, s));
  out["changes"] = changes_json(h, changes);
  out["pairs"] = pairs_json(h);
  return out.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace halfway::history
