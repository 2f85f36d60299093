// halfway_simulate: how well are regressions found in a history? Prints the study as JSON; the kept one is
// simulated.json beside this file.
//   halfway_simulate [SEEDS]
#include "reports/history/simulate/simulate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>
#include <cstring>

namespace {

using namespace halfway::history;

nlohmann::ordered_json json_of(const Tally& t) {
  return {{"seeded", t.seeded},
          {"found", t.found},
          {"at_the_commit", t.exactly},
          {"stable", t.stable},
          {"marked", t.marked},
          {"found_share", double(t.found) / t.seeded},
          {"marked_share", double(t.marked) / t.stable}};
}

}  // namespace

int main(int argc, char** argv) {
  Plan plan;
  const char* const text = argc == 2 ? argv[1] : "200";
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), plan.seeds);
  if (argc > 2 || error != std::errc() || *end != 0 || plan.seeds < 1)
    return std::fputs("usage: halfway_simulate [SEEDS], a whole number above 0\n", stderr), 2;
  nlohmann::ordered_json out{{"command", fmt::format("halfway_simulate {}", plan.seeds)},
                             {"histories", plan.seeds},
                             {"runs", plan.runs},
                             {"figures", {{"times", plan.times}, {"accuracies", plan.accuracies}}},
                             {"slower", plan.slower},
                             {"runs_after", plan.runs_after},
                             {"runs_before", plan.runs_before},
                             {"noise", nlohmann::ordered_json::object()}};
  for (const Noise noise : {Noise::student, Noise::normal, Noise::spikes, Noise::wide}) {
    const Result result = simulate(plan, noise);
    out["noise"][to_string(noise)] = {{"times", json_of(result.times)},
                                      {"accuracies", json_of(result.accuracies)}};
  }
  fmt::print("{}\n", out.dump(1));
}
