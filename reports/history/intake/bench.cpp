#include "reports/cli/errors.hpp"
#include "reports/history/intake/intake.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace halfway::history {
namespace {

using nlohmann::json;

/// Google Benchmark writes words for numbers that are none, and wrote the name of the program as bytes of
/// freed memory.
json parse_bench(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x7F || (byte < 0x20 && c != '\n')) c = '?';
  }
  for (const std::string word : {": nan", ": -nan", ": NaN", ": inf", ": -inf", ": Infinity", ": -Infinity"})
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;)
      text.replace(at, word.size(), ": null");
  return json::parse(text);
}

double ps_of(const json& row) {
  const auto per_evaluation = row.find("per_evaluation");
  if (per_evaluation != row.end() && per_evaluation->is_number()) return 1e12 * per_evaluation->get<double>();
  static const std::map<std::string, double> units{{"ns", 1e3}, {"us", 1e6}, {"ms", 1e9}, {"s", 1e12}};
  const json& time = row.at("cpu_time");
  return time.is_number() ? time.get<double>() * units.at(row.value("time_unit", "ns")) : kNone;
}

void add_row(const json& row, Bench& bench) {
  if (row.value("run_type", "iteration") != "iteration" || row.value("error_occurred", false)) return;
  std::string name = row.value("run_name", row.at("name").get<std::string>());
  const std::string wall = "/real_time";  // Google Benchmark's own suffix of a wall time
  if (name.ends_with(wall)) name.resize(name.size() - wall.size());
  const double ps = ps_of(row);
  if (!(ps >= 0.5 && ps < 1e18)) throw std::runtime_error(fmt::format("a time of {} ps", ps));
  bench.times[name].push_back(std::llround(ps));
}

void add_context(const json& context, Bench& bench) {
  for (const json& cache : context.value("caches", json::array()))
    bench.caches += (bench.caches.empty() ? "" : ", ") +
                    cache_text(cache.at("level"), cache.at("type"), cache.at("size").get<long>());
  const json load = context.value("load_avg", json::array());
  if (!load.empty()) bench.load = load.front().get<double>();
}

}  // namespace

Bench read_bench(const std::filesystem::path& file) {
  Bench out;
  std::string where = "no JSON";
  try {
    const json root = parse_bench(reports::read_file(file));
    where = "context";
    add_context(root.at("context"), out);
    int i = 0;
    for (const json& row : root.at("benchmarks")) {
      where = fmt::format("benchmarks[{}]", i++);
      add_row(row, out);
    }
  } catch (const reports::FileError& error) {
    throw reports::BadInput(error.what());
  } catch (const std::exception& error) {
    throw reports::BadInput(
        fmt::format("{}: not what Google Benchmark writes: {}: {}", file.string(), where, error.what()));
  }
  return out;
}

}  // namespace halfway::history
