#include "reports/history/simulate/simulate.hpp"

#include "reports/history/statistics/changes.hpp"

#include <cmath>
#include <cstdlib>
#include <random>

namespace halfway::history {
namespace {

using statistics::Change, statistics::Exact, statistics::Sense, statistics::Verdict;
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

double noise_of(Random& random, Noise noise) {
  if (noise == Noise::student || noise == Noise::wide) {
    // t with three degrees of freedom: standard deviation sqrt(3), upper quartile 0.7649 (normal: 0.6745).
    const double t = std::student_t_distribution<double>(3)(random);
    return 0.02 * t * (noise == Noise::wide ? 0.6745 / 0.7649 : 1 / std::sqrt(3.0));
  }
  if (noise == Noise::normal) return 0.02 * std::normal_distribution<double>()(random);
  const double spike = uniform(random, 0, 1) < 0.05 ? std::exponential_distribution<double>(10)(random) : 0;
  return 0.015 * std::normal_distribution<double>()(random) + spike;
}

/// The first run of the regression; `runs` where there is none.
int place(Random& random, const Plan& plan, bool seeded) {
  if (!seeded) return plan.runs;
  return std::uniform_int_distribution<int>(plan.runs_before, plan.runs - plan.runs_after)(random);
}

std::vector<Change> times(Random& random, const Plan& plan, Noise noise, int from) {
  const double level = std::pow(10, uniform(random, 1, 4));  // ns
  std::vector<double> medians;
  for (int run = 0; run < plan.runs; ++run)
    medians.push_back(level * (run < from ? 1 : 1 + plan.slower) * std::exp(noise_of(random, noise)));
  return statistics::find_changes(medians, plan.rules);
}

/// An error that moves by up to half a digit either way at one commit in ten; from the seeded one on, two
/// digits are lost, or four, which breaks the limit.
std::vector<Change> accuracy(Random& random, const Plan& plan, int from, bool breaks) {
  constexpr double limit = 1e-12;
  const double level = std::pow(10, uniform(random, -15, -14.6));
  std::vector<Exact> readings;
  double rounding = 0;
  for (int run = 0; run < plan.runs; ++run) {
    if (uniform(random, 0, 1) < 0.1) rounding = uniform(random, -0.48, 0.48);
    const double digits = run < from ? 0 : breaks ? 4 : 2;
    const double error = level * std::pow(10, digits + rounding);
    readings.push_back({.value = error,
                        .error = error,
                        .limit = limit,
                        .verdict = error > limit ? Verdict::fail : Verdict::pass});
  }
  return statistics::find_changes(readings);
}

void count(Tally& tally, const Plan& plan, int from, const std::vector<Change>& changes) {
  if (from == plan.runs) {
    ++tally.stable;
    for (const Change& c : changes)
      if (c.sense != Sense::change) return void(++tally.marked);
    return;
  }
  ++tally.seeded;
  int nearest = 2;
  for (const Change& c : changes) {
    const int distance = std::abs(int(c.run) - from);
    if (c.sense == Sense::regression && distance < nearest) nearest = distance;
  }
  tally.found += nearest <= 1, tally.exactly += nearest == 0;
}

}  // namespace

const char* to_string(Noise noise) {
  constexpr const char* names[] = {"student", "normal", "spikes", "wide"};
  return names[int(noise)];
}

Result simulate(const Plan& plan, Noise noise) {
  Result out{noise, {}, {}};
  for (int seed = 1; seed <= plan.seeds; ++seed) {
    Random random(static_cast<Random::result_type>(seed));
    for (int i = 0; i < plan.times; ++i) {
      const int from = place(random, plan, i < 3);
      count(out.times, plan, from, times(random, plan, noise, from));
    }
    for (int i = 0; i < plan.accuracies; ++i) {
      const int from = place(random, plan, i < 2);
      count(out.accuracies, plan, from, accuracy(random, plan, from, i == 0));
    }
  }
  return out;
}

}  // namespace halfway::history
