#include "reports/cli/errors.hpp"
#include "reports/history/exchange/lines.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>
#include <tuple>

namespace halfway::history {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kSchema = "halfway-history";
constexpr int kLineVersion = 1;

ordered_json number(double x) { return std::isnan(x) ? ordered_json(nullptr) : ordered_json(x); }
double number_of(const json& x) { return x.is_null() ? kNone : x.get<double>(); }

ordered_json head(const Run& run, const Series& s) {
  const Machine& m = s.machine;
  return {{"commit", run.commit},
          {"dirty", run.dirty},
          {"date", run.date},
          {"title", run.title},
          {"release", run.release},
          {"load", number(run.load)},
          {"libraries", ordered_json::parse(run.libraries.empty() ? "{}" : run.libraries)},
          {"machine", {{"cpu", m.cpu}, {"cores", m.cores}, {"caches", m.caches}, {"microcode", m.microcode}}},
          {"compiler", s.compiler},
          {"flags", s.flags},
          {"build_type", s.build_type},
          {"isa", s.isa}};
}

ordered_json reading_json(int figure, const Reading& r) {
  return {figure,        number(r.value), to_string(r.comparison), number(r.expected),
          number(r.low), number(r.high),  to_string(r.verdict)};
}

ordered_json time_json(int figure, const Time& t, const Repetitions* all) {
  ordered_json out = {figure, t.median, t.low, t.high, t.n};
  if (all != nullptr) out.push_back(*all);
  return out;
}

/// Of each run.
struct Lines {
  explicit Lines(std::size_t runs) : figures(runs, ordered_json::array()), times(figures), changes(figures) {}
  std::vector<ordered_json> figures;  ///< that no earlier run has, by name
  std::vector<ordered_json> times, changes;
};

/// The first run that has the figure; -1: none of those that are wanted.
int first_of(const History& h, int f, int only, const std::vector<Reading>& all) {
  const auto& times = h.times[f];
  if (only >= 0) {
    const bool is_timed = std::ranges::find(times, only, &TimeAt::run) != times.end();
    return is_timed || all[f].verdict != Verdict::gone ? only : -1;
  }
  const int timed = times.empty() ? INT_MAX : times.front().run;
  const int changed = h.changes[f].empty() ? INT_MAX : h.changes[f].front().run;
  const int first = std::min(timed, changed);
  return first == INT_MAX ? -1 : first;
}

/// Figures in the order of their first runs, then names: a later run adds lines and leaves those above it as
/// they are, and a history in any order of its figures is one text. A run alone says all that holds, the
/// whole file what changed.
Lines lines_of(const History& h, int only) {
  Lines out(h.runs.size());
  const std::vector<Reading> all = only < 0 ? std::vector<Reading>{} : readings_at(h, only);
  std::vector<std::tuple<int, std::string_view, int>> order;
  for (int f = 0; f < int(h.figures.size()); ++f)
    if (const int first = first_of(h, f, only, all); first >= 0)
      order.emplace_back(first, h.figures[f].name, f);
  std::ranges::sort(order);
  int place = 0;
  for (const auto& [first, name, f] : order) {
    const Figure& figure = h.figures[f];
    out.figures[first].push_back(
        {figure.name, figure.unit, to_string(figure.kind), to_string(figure.better), figure.formulation});
    for (const TimeAt& t : h.times[f]) {
      if (only >= 0 && t.run != only) continue;
      const auto kept = h.repetitions.find({t.run, f});
      out.times[t.run].push_back(
          time_json(place, t.time, kept == h.repetitions.end() ? nullptr : &kept->second));
    }
    if (only < 0)
      for (const ReadingAt& c : h.changes[f]) out.changes[c.run].push_back(reading_json(place, c.reading));
    else if (all[f].verdict != Verdict::gone)
      out.changes[only].push_back(reading_json(place, all[f]));
    ++place;
  }
  return out;
}

std::string line(const ordered_json& content) {
  return content.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Record head_of(const json& line) {
  Record out;
  const json& machine = line.at("machine");
  out.series = {{machine.at("cpu"), machine.at("cores"), machine.at("caches"), machine.at("microcode")},
                line.at("compiler"),
                line.at("flags"),
                line.at("build_type"),
                line.at("isa")};
  Run& run = out.run;
  run.commit = line.at("commit"), run.dirty = line.at("dirty"), run.date = line.at("date");
  seconds_of(run.date);
  run.title = line.at("title"), run.release = line.at("release"), run.load = number_of(line.at("load"));
  run.libraries = line.at("libraries").dump();
  return out;
}

Figure figure_of(const json& row) {
  Figure out{.name = row.at(0), .unit = row.at(1)};
  from_string(row.at(2), out.kind);
  from_string(row.at(3), out.better);
  out.formulation = row.at(4);
  return out;
}

Reading reading_of(const json& row) {
  Reading r{.value = number_of(row.at(1)),
            .expected = number_of(row.at(3)),
            .low = number_of(row.at(4)),
            .high = number_of(row.at(5))};
  from_string(row.at(2), r.comparison);
  from_string(row.at(6), r.verdict);
  return r;
}

/// What holds in each series while its runs go by.
class Reader {
 public:
  void figures(const json& rows) {
    for (const json& row : rows) figures_.push_back(figure_of(row));
  }
  Record run(const json& line) {
    Record out = head_of(line);
    auto& holds = holds_[line.at("machine").dump() + line.at("compiler").dump() + line.at("flags").dump() +
                         line.at("build_type").dump() + line.at("isa").dump()];
    for (const json& row : line.at("changes")) {
      const Figure& figure = figures_.at(row.at(0).get<std::size_t>());
      const Reading reading = reading_of(row);
      if (reading.verdict == Verdict::gone)
        holds.erase(figure.name);
      else
        holds[figure.name] = {figure, reading};
    }
    out.exact = holds;
    for (const json& row : line.at("times")) {
      const Figure& figure = figures_.at(row.at(0).get<std::size_t>());
      const Time time{.median = row.at(1), .low = row.at(2), .high = row.at(3), .n = row.at(4)};
      out.timed[figure.name] = {figure, time, row.size() > 5 ? row.at(5).get<Repetitions>() : Repetitions{}};
    }
    return out;
  }

 private:
  std::vector<Figure> figures_;
  std::map<std::string, std::map<std::string, Record::Exact>> holds_;
};

void read_line(const json& line, Reader& reader, const std::function<void(const Record&)>& sink) {
  if (line.contains("schema")) {
    if (line.at("schema") != kSchema || line.at("version") != kLineVersion)
      throw std::runtime_error(fmt::format("schema, version: not {}, {}", kSchema, kLineVersion));
    reader = {};  // another history begins
  }
  if (line.contains("figures"))
    reader.figures(line.at("figures"));
  else
    sink(reader.run(line));
}

}  // namespace

std::string json_lines(const History& history, int only) {
  Lines lines = lines_of(history, only);
  const int runs = int(history.runs.size()), begin = only < 0 ? 0 : only, end = only < 0 ? runs : only + 1;
  ordered_json first = runs > 0 ? std::move(lines.figures[begin]) : ordered_json::array();
  std::string out = line({{"schema", kSchema}, {"version", kLineVersion}, {"figures", std::move(first)}});
  for (int i = begin; i < end; ++i) {
    if (i > begin && !lines.figures[i].empty()) out += line({{"figures", std::move(lines.figures[i])}});
    ordered_json json = head(history.runs[i], history.series[history.runs[i].series]);
    json["times"] = std::move(lines.times[i]);
    json["changes"] = std::move(lines.changes[i]);
    out += line(json);
  }
  return out;
}

void read_lines(const std::string& text, const std::string& name,
                const std::function<void(const Record&)>& sink) {
  Reader reader;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      read_line(json::parse(line), reader, sink);
    } catch (const reports::BadInput&) {
      throw;
    } catch (const std::exception& error) {
      throw reports::BadInput(fmt::format("{}:{}: {}", name, number, error.what()));
    }
  }
  if (number == 0) throw reports::BadInput(name + ": empty");
}

bool is_lines(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string begin(64, '\0');
  in.read(begin.data(), std::streamsize(begin.size()));
  return begin.starts_with('{') && begin.find(kSchema) != std::string::npos;
}

History read_history(const std::filesystem::path& file) {
  HistoryBuilder builder;
  try {
    read_lines(reports::read_file(file), file.string(), [&](const Record& run) { builder.add(run); });
  } catch (const reports::FileError& error) {
    throw reports::BadInput(error.what());
  }
  return std::move(builder.history);
}

}  // namespace halfway::history
