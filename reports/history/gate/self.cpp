#include "reports/history/gate/self.hpp"

#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <thread>

namespace halfway::gate {
namespace {

using nlohmann::ordered_json;
using Allowed = std::map<std::string, double>;

/// Slowed runs have numbers of their own: 1000 k + i of the k-th slow-down.
int number_of(std::size_t slow_down, int run) { return int(slow_down + 1) * 1000000 + run; }

struct Tally {
  int comparisons = 0, first = 0, alarms = 0;  ///< first: before fresh pairs had their say
};

/// Both rounds under these limits. A first round above them was above `least` too: it was measured again.
void count(Tally& tally, const Measured& m, const std::string& figure, const TimeRules& rules,
           double allowed) {
  const Samples& s = m.first.at(figure);
  ++tally.comparisons;
  if (!is_slower(compared(s.base, s.head), rules, allowed)) return;
  ++tally.first;
  const auto again = m.again.find(figure);
  tally.alarms += again != m.again.end() && comes_again(s, again->second, rules, allowed);
}

/// The processor and the number of cores.
std::string machine() {
  std::ifstream file("/proc/cpuinfo");
  std::string name = "unknown processor";
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) name = line.substr(colon + 2);
  }
  return fmt::format("{}, {} cores", name, std::thread::hardware_concurrency());
}

ordered_json json_of(const Tally& t) {
  return {{"comparisons", t.comparisons},
          {"alarms_at_first", t.first},
          {"alarms", t.alarms},
          {"share", double(t.alarms) / t.comparisons}};
}

/// Largest change either way; NaN where a time is missing.
void include(Allowed& largest, const Measured& m) {
  for (const auto& [name, s] : m.first) {
    const double size = std::expm1(std::abs(std::log(compared(s.base, s.head).ratio)));
    double& kept = largest[name];
    if (!(size <= kept)) kept = size;
  }
}

class Self {
 public:
  Self(const SelfPlan& plan, Journal& journal, const std::filesystem::path& folder, const Told& told)
      : plan_(plan), journal_(journal), folder_(folder), told_(told), loose_(plan.rules) {
    loose_.allowed.clear();  // fresh pairs for everything above 3 %: limits are known at the end alone
    total_ = plan.runs + int(plan.slower.size()) * plan.slowed_runs;
  }

  void run() {
    for (int i = 0; i < plan_.runs; ++i) plain_.push_back(measured(i, -1));
    for (std::size_t k = 0; k < plan_.slower.size(); ++k) {
      slowed_.emplace_back();
      for (int i = 0; i < plan_.slowed_runs; ++i)
        slowed_.back().push_back(measured(number_of(k, i), plan_.slower[k]));
    }
    reports::write_file(folder_ / result_name(plan_), result().dump(1) + '\n');
  }

 private:
  Measured measured(int run, double slower) {
    BenchOptions bench = plan_.bench;
    bench.slower = slower;
    const Sides sides = sides_of(plan_, run);
    const std::size_t known = journal_.size();
    told_(done_, total_, fresh_ == 0 ? "" : left());
    const auto begin = std::chrono::steady_clock::now();
    Measured out = measure_times(journal_, sides.base, sides.head, bench, loose_, run, folder_,
                                 [](int, int, const std::string&) {});
    if (journal_.size() > known) {
      ++fresh_;
      seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    ++done_;
    return out;
  }

  std::string left() const {
    return fmt::format("about {:.0f} min left", seconds_ / fresh_ * (total_ - done_) / 60);
  }

  double limit(const Allowed& allowed, const std::string& figure) const {
    TimeRules rules = plan_.rules;
    rules.allowed = allowed;
    return rules.allowed_of(figure);
  }

  Tally total(const std::vector<Measured>& runs, const Allowed& allowed, std::size_t first, std::size_t step,
              const std::string& only = "") const {
    Tally out;
    for (std::size_t i = first; i < runs.size(); i += step)
      for (const auto& [name, s] : runs[i].first)
        if (only.empty() || only == name) count(out, runs[i], name, plan_.rules, limit(allowed, name));
    return out;
  }

  ordered_json result() const {
    Allowed even, all = plan_.runs == 0 ? plan_.rules.allowed : Allowed{};
    for (std::size_t i = 0; i < plain_.size(); ++i) {
      include(all, plain_[i]);
      if (i % 2 == 0) include(even, plain_[i]);
    }
    ordered_json out{{"schema", "halfway-gate-self"}, {"version", 1}};
    out["command"] = plan_.command, out["machine"] = machine();
    out["pairs"] = plan_.rules.pairs, out["chance"] = plan_.rules.chance;
    out["again"] = plan_.rules.again, out["least"] = plan_.rules.least;
    out["layouts"] = plan_.programs.size(), out["layouts_a_side"] = sides_of(plan_, 0).base.programs.size();
    out["runs"] = plan_.runs, out["slowed_runs"] = plan_.slowed_runs;
    if (plan_.runs > 0)
      out["false_alarms"] = {{"odd_runs_under_limits_of_even_runs", json_of(total(plain_, even, 1, 2))},
                             {"all_runs_under_3_percent", json_of(total(plain_, {}, 0, 1))}};
    out["power"] = ordered_json::array();
    for (std::size_t k = 0; k < slowed_.size(); ++k) {
      ordered_json row{{"slower", plan_.slower[k]}};
      row.update(json_of(total(slowed_[k], all, 0, 1)));
      out["power"].push_back(row);
    }
    for (const auto& [name, largest] : all) out["figures"][name] = figure(name, largest, all);
    return out;
  }

  ordered_json figure(const std::string& name, double largest, const Allowed& all) const {
    ordered_json out;
    if (plan_.runs > 0) out["largest"] = largest;
    out["allowed"] = limit(all, name);
    for (std::size_t k = 0; k < slowed_.size(); ++k)
      out["found"][fmt::format("{}", plan_.slower[k])] = total(slowed_[k], all, 0, 1, name).alarms;
    return out;
  }

  const SelfPlan& plan_;
  Journal& journal_;
  const std::filesystem::path& folder_;
  const Told& told_;
  TimeRules loose_;
  std::vector<Measured> plain_;
  std::vector<std::vector<Measured>> slowed_;
  int done_ = 0, fresh_ = 0, total_ = 0;
  double seconds_ = 0;
};

}  // namespace

std::string result_name(const SelfPlan& plan) { return plan.runs > 0 ? "self.json" : "power.json"; }

Sides sides_of(const SelfPlan& plan, int run) {
  const std::size_t half = plan.programs.size() / 2, first = run % 2 == 0 ? 0 : half;
  std::vector<std::filesystem::path> pool(plan.programs.begin() + std::ptrdiff_t(first),
                                          plan.programs.begin() + std::ptrdiff_t(first + half));
  std::mt19937 random(static_cast<std::mt19937::result_type>(run));
  for (std::size_t i = pool.size(); i > 1; --i) std::swap(pool[i - 1], pool[random() % i]);
  const std::size_t each = std::min<std::size_t>(3, half / 2);
  const auto middle = pool.begin() + std::ptrdiff_t(each);
  return {{"base", "", {pool.begin(), middle}}, {"head", "", {middle, middle + std::ptrdiff_t(each)}}};
}

void measure_self(const SelfPlan& plan, Journal& journal, const std::filesystem::path& folder,
                  const Told& told) {
  if (plan.programs.size() < 4)
    throw reports::BadInput(
        fmt::format("--self: {} layouts; at least 4 are needed, 12 for three a side", plan.programs.size()));
  Self(plan, journal, folder, told).run();
}

std::map<std::string, double> read_allowed(const std::filesystem::path& file) {
  Allowed out;
  try {
    const auto root = nlohmann::json::parse(reports::read_file(file));
    if (root.at("schema") != "halfway-gate-self") throw std::runtime_error("schema: not halfway-gate-self");
    for (const auto& [name, figure] : root.at("figures").items()) out[name] = figure.at("allowed");
  } catch (const std::exception& error) {
    throw reports::BadInput(fmt::format("--spread: {}: {}", file.string(), error.what()));
  }
  return out;
}

}  // namespace halfway::gate
