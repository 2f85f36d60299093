#include "reports/cli/errors.hpp"
#include "reports/history/intake/intake.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace halfway::history {
namespace {

using nlohmann::json;

/// null: a number that is none.
double number_at(const json& object, const char* key) {
  const json& value = object.at(key);
  return value.is_null() ? kNone : value.get<double>();
}

Better better_of(Comparison comparison, double expected) {
  if (comparison == Comparison::at_most || (comparison == Comparison::equal && expected == 0))
    return Better::down;
  return comparison == Comparison::at_least ? Better::up : Better::none;
}

void add_exact(Record& record, Figure figure, const Reading& reading) {
  const std::string name = figure.name;
  if (!record.exact.emplace(name, Record::Exact{std::move(figure), reading}).second)
    throw std::runtime_error(fmt::format("name: there are two figures '{}'", name));
}

void add_finding(Record& record, const json& finding) {
  Reading r{.value = number_at(finding, "value")};
  from_string(finding.at("comparison"), r.comparison);
  from_string(finding.at("verdict"), r.verdict);
  if (r.verdict == Verdict::gone || r.verdict == Verdict::none)
    throw std::runtime_error("verdict: allowed: pass, known_failure, fail, left_out");
  r.expected = number_at(finding, "expected"), r.low = number_at(finding, "low"),
  r.high = number_at(finding, "high");
  add_exact(record,
            {.name = finding.at("name"),
             .unit = finding.at("unit"),
             .better = better_of(r.comparison, r.expected),
             .formulation = finding.at("formulation")},
            r);
}

Time time_of(double ns, const Repetitions& all) {
  Time out{.median = std::llround(1e3 * ns), .n = int(all.size())};
  if (all.empty()) return out;
  const auto [low, high] = std::ranges::minmax(all);
  out.low = int(std::lround(1e3 * double(low) / double(out.median)));
  out.high = int(std::lround(1e3 * double(high) / double(out.median)));
  return out;
}

/// A time, the error of what was timed and its operations: three figures.
void add_timing(Record& record, const json& timing, const Bench& bench, bool is_timed) {
  const std::string name = timing.at("name"), formulation = timing.at("formulation");
  const bool wrong = timing.at("wrong");
  Reading error{.value = number_at(timing, "error"), .comparison = Comparison::report};
  error.verdict = wrong ? Verdict::fail : Verdict::pass;
  add_exact(record, {name + "/error", "relative", Kind::accuracy, Better::down, formulation}, error);
  const double flops = number_at(timing, "flops"), ns = number_at(timing, "ns");
  if (flops > 0)
    add_exact(record, {name + "/flops", "flops", Kind::count, Better::down, formulation}, {.value = flops});
  if (wrong || !is_timed) return;
  if (!(ns >= 1e-3 && ns < 1e15)) throw std::runtime_error(fmt::format("ns: {} is no time of a joint", ns));
  const auto kept = bench.times.find(name);
  const Repetitions all = kept == bench.times.end() ? Repetitions{} : kept->second;
  const Time time = time_of(ns, all);
  // Rounding to ps and permille aside, the median lies among its repetitions.
  if (time.n > 0 && (time.low > 1001 || time.high < 999))
    throw std::runtime_error(
        fmt::format("ns: {} is not among the repetitions in bench.json: of another run", ns));
  record.timed[name] = {{name, "ns per joint", Kind::time, Better::down, formulation}, time, all};
}

/// Newton steps of a path; xi where one path of several has it in its name.
void add_curve(Record& record, const json& curve) {
  const std::string formulation = curve.at("formulation");
  if (formulation == "linearized") return;  // the linear analysis takes none
  std::string name = fmt::format("{}/{}/iterations", curve.at("scene").get<std::string>(), formulation);
  if (record.exact.contains(name)) name += fmt::format("/xi={}", curve.at("xi").get<double>());
  add_exact(record, {name, "Newton steps", Kind::count, Better::down, formulation},
            {.value = curve.at("iterations").get<double>()});
}

void each(const json& root, const char* list, std::string& where, const auto& work) {
  where = list;
  const json& items = root.at(list);
  for (std::size_t i = 0; i < items.size(); ++i) {
    where = fmt::format("{}[{}]", list, i);
    work(items[i]);
  }
}

/// The widest that was timed; where none was, what this machine has.
std::string isa_of(const json& root, bool is_here) {
  std::string out;
  const auto rank = [](const std::string& isa) {
    return isa == "avx512" ? 4 : isa == "avx2vl" ? 3 : isa == "avx2" ? 2 : isa == "sse2";
  };
  for (const json& timing : root.at("timings"))
    if (const std::string isa = timing.at("isa"); rank(isa) > rank(out)) out = isa;
  return out.empty() && is_here ? isa_here() : out;
}

/// "AMD EPYC, 2 cores". What the report does not say is asked of this machine, if it is the same.
void add_context(Record& record, const json& root, const Bench& bench) {
  const json& context = root.at("context");
  Run& run = record.run;
  run.commit = context.at("commit"), run.date = context.at("date");
  seconds_of(run.date);
  const std::string changes = "+changes";  // see bench/harness/commit.cmake
  run.dirty = run.commit.ends_with(changes);
  if (run.dirty) run.commit.resize(run.commit.size() - changes.size());
  const std::string machine = context.at("machine");
  const auto comma = machine.rfind(", ");
  Machine& m = record.series.machine;
  m.cpu = machine.substr(0, comma);
  if (comma != std::string::npos) m.cores = std::atoi(machine.c_str() + comma + 2);
  const bool is_here = m.cpu == cpu_here();
  m.caches = !bench.caches.empty() ? bench.caches : is_here ? caches_here() : "";
  m.microcode = is_here ? microcode_here() : "";
  run.load = !std::isnan(bench.load) ? bench.load : is_here ? load_here() : kNone;
  record.series.compiler = context.at("compiler"), record.series.flags = context.at("flags");
  record.series.build_type = context.at("build_type");
  record.series.isa = isa_of(root, is_here);
  run.libraries = context.contains("libraries") ? context.at("libraries").dump()
                  : is_here                     ? libraries_here()
                                                : "{}";
}

Added record_of(const json& root, const Bench& bench, std::string& where) {
  Added out;
  where = "schema, version";
  if (root.at("schema") != "halfway-results" || root.at("version") != 1)
    throw std::runtime_error("not halfway-results, 1");
  where = "context";
  add_context(out.record, root, bench);
  where = "command";
  const std::string command = root.at("command");
  const bool is_quick = command.find("--quick") != std::string::npos;
  out.record.is_partial = is_quick || command.find("--formulation") != std::string::npos;
  each(root, "findings", where, [&](const json& f) { add_finding(out.record, f); });
  each(root, "timings", where, [&](const json& t) { add_timing(out.record, t, bench, !is_quick); });
  each(root, "curves", where, [&](const json& c) { add_curve(out.record, c); });
  if (out.record.exact.empty()) throw std::runtime_error("no figure in it");
  if (is_quick) out.note = "times of a quick report are too few to keep: left out";
  return out;
}

}  // namespace

Added read_report(const std::filesystem::path& path) {
  const bool is_file = std::filesystem::is_regular_file(path);
  const auto file = is_file ? path : path / "results.json", bench_file = path / "bench.json";
  std::string where = "no JSON";
  try {
    const json root = json::parse(reports::read_file(file));
    const Bench bench = std::filesystem::exists(bench_file) ? read_bench(bench_file) : Bench{};
    return record_of(root, bench, where);
  } catch (const reports::FileError& error) {
    throw reports::BadInput(error.what());
  } catch (const reports::BadInput&) {
    throw;
  } catch (const std::exception& error) {
    throw reports::BadInput(fmt::format("{}: {}: {}", file.string(), where, error.what()));
  }
}

}  // namespace halfway::history
