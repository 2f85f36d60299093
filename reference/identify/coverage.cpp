#include "reference/identify/coverage.hpp"

#include "reference/numbers/random.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace halfway::reference::identify {
namespace {

Frame unit_frame(Kind kind) {
  Frame out;
  out.kind = kind;
  return out;
}

/// Generic: nothing is aligned with anything, stiffnesses apart by factors, xi none that a formula prefers.
JointValues truth_of(Kind kind) {
  JointValues v = values_of(unit_frame(kind), no_unknowns());
  v.angular = {10, 30, 55};
  v.linear = {4000, 9000, 2000};
  v.H = so3::exp<double>({0.2, 0.1, -0.3});
  v.E = so3::exp<double>({-0.15, 0.25, 0.1});
  v.xi_angular.setConstant(0.37);
  v.xi_linear.setConstant(0.37);
  if (kind == Kind::linear_angular) {
    v.point = {-0.03, 0.05, 0.02};
    v.S << 0.004, 0.002, -0.003, 0.002, -0.005, 0.001, -0.003, 0.001, 0.002;
  }
  return v;
}

/// Rows one way.
int rows_of(Kind kind) { return kind == Kind::angular ? 4 : 2; }

/// Up to that load, both ways: second order does not change its sign with the load, first order does.
LoadCase loaded_case(const Vec6& load, int rows) {
  LoadCase one;
  one.has_load.fill(true), one.has_motion.fill(true);
  for (int row = -rows; row <= rows; ++row) {
    if (row == 0) continue;
    one.loads.push_back(load * row / rows);
    one.motions.push_back(Vec6::Zero());
  }
  return one;
}

/// Moments that turn about two principal axes by some 0.3 rad, and for six strains forces likewise.
std::vector<Vec6> programme(Kind kind, const JointValues& v) {
  std::vector<Vec6> out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    Vec6 load = Vec6::Zero();
    load.tail<3>() = v.H.col(i) * v.angular[i] * 0.3 + v.H.col(j) * v.angular[j] * 0.24;
    out.push_back(load);
    if (kind == Kind::angular) continue;
    const Mat3<double> D = v.H * v.E;
    load.head<3>() = D.col(i) * v.linear[i] * 0.01 + D.col(j) * v.linear[j] * 0.008;
    load.tail<3>() *= 0.4;
    out.push_back(load);
    load.tail<3>() *= -1;
    out.push_back(load);
  }
  return out;
}

/// Fills in what the joint answers, load by load from none.
void answer(const Model& model, Kind kind, LoadCase& one) {
  Vec6 before = Vec6::Zero();
  for (std::size_t row = 0; row < one.loads.size(); ++row) {
    const Equilibrium found = equilibrium(model, kind, one, row, before);
    if (!found.found) throw std::logic_error("the programme of loads has a row without equilibrium");
    one.motions[row] = before = found.motion;
    for (int i = 0; i < 6; ++i) {
      if (one.held[std::size_t(i)]) one.loads[row][i] = found.loads.q[i];
    }
  }
}

/// What was free is held where it was: the same states, now the loads are measured.
void hold(LoadCase& one) { one.held.fill(true); }

/// Box and Muller's, of the two next draws.
double gaussian(Generator& generator) {
  const double radius = std::sqrt(-2 * std::log(1 - generator.uniform(0, 1)));
  return radius * std::cos(2 * std::numbers::pi * generator.uniform(0, 1));
}

/// The truth as the unknowns of a frame.
Unknowns unknowns_of(const JointValues& v, const Frame& frame) {
  Unknowns p = no_unknowns();
  p.segment<3>(kAngularStiffness) = v.angular.cwiseQuotient(frame.angular).array().log();
  p.segment<3>(kLinearStiffness) = v.linear.cwiseQuotient(frame.linear).array().log();
  p.segment<3>(kAngularAxes) = so3::log(so3::quaternion<double>(frame.H.transpose() * v.H));
  p.segment<3>(kLinearAxes) = so3::log(so3::quaternion<double>(frame.E.transpose() * v.E));
  p.segment<6>(kCoupling) << v.S(0, 0), v.S(1, 1), v.S(2, 2), v.S(1, 2), v.S(0, 2), v.S(0, 1);
  p.segment<6>(kCoupling) /= frame.length;
  p.segment<3>(kJointPoint) = v.point / frame.length;
  p.segment<3>(kXiAngular) = v.xi_angular;
  p.segment<3>(kXiLinear) = v.xi_linear;
  return p;
}

}  // namespace

const std::vector<std::string>& bench_names() {
  static const std::vector<std::string> names = {"angular", "per_pair", "full", "held"};
  return names;
}

Bench bench(const std::string& name) {
  const bool is_angular = name == "angular" || name == "per_pair";
  Bench out{name, {}, {2e-5, 2e-4, 0.05, 0.02}, truth_of(is_angular ? Kind::angular : Kind::linear_angular)};
  out.data.kind = is_angular ? Kind::angular : Kind::linear_angular;
  out.is_per_pair = name == "per_pair";
  if (out.is_per_pair) out.truth.xi_angular = {0.6, 0.3, 0.9};
  const Frame frame = unit_frame(out.data.kind);
  const Model model = out.is_per_pair ? second_order_model(frame, out.truth)
                                      : catalog_model(*find_formulation("intrinsic"), frame, out.truth);
  for (const Vec6& load : programme(out.data.kind, out.truth)) {
    LoadCase one = loaded_case(load, rows_of(out.data.kind));
    answer(model, out.data.kind, one);
    if (name == "held" && out.data.cases.size() % 2 == 1) hold(one);
    out.data.cases.push_back(std::move(one));
  }
  return out;
}

Data noisy(const Bench& bench, std::uint64_t seed) {
  Generator generator(seed);
  Data out = bench.data;
  for (LoadCase& one : out.cases) {
    for (std::size_t row = 0; row < one.loads.size(); ++row) {
      for (int i = first_component(out.kind); i < end_component(out.kind); ++i) {
        if (!one.is_measured(i)) continue;
        double& value = one.held[std::size_t(i)] ? one.loads[row][i] : one.motions[row][i];
        value += bench.noise[std::size_t(one.channel(i))] * gaussian(generator);
      }
    }
  }
  return out;
}

std::vector<Coverage> coverage(const Bench& bench, int trials, double spoil) {
  std::vector<Coverage> out;
  const auto count = [&](const Identification& found, const Fit& fit, int place) {
    const std::string name = place == kXiAngular && !bench.is_per_pair ? "xi" : name_of(place);
    const auto at =
        std::find_if(out.begin(), out.end(), [&](const Coverage& one) { return one.quantity == name; });
    Coverage& one = at == out.end() ? out.emplace_back(Coverage{name}) : *at;
    if (!fit.is_active(place)) return;
    const double off = fit.p[place] - unknowns_of(bench.truth, found.frame)[place];
    one.trials += 1;
    one.covered += std::abs(off) <= spoil * fit.half_width(place) ? 1 : 0;
  };
  for (int trial = 0; trial < trials; ++trial) {
    const Identification found = identify(noisy(bench, std::uint64_t(trial) + 1), false);
    const Fit& shown = found.chosen_stage().fit;
    for (const int place : freedom_of(Stage::half_way, bench.data.kind).active) count(found, shown, place);
    if (bench.is_per_pair)
      for (int i = 0; i < 3; ++i) count(found, found.stage(Stage::per_pair).fit, kXiAngular + i);
    else
      count(found, found.stage(Stage::one_xi).fit, kXiAngular);
  }
  return out;
}

}  // namespace halfway::reference::identify
