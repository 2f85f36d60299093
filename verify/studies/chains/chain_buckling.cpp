// Critical moments of twisted chains: of fixed ones, which a rod does not have, and of a conservative one.
#include "reference/numbers/zeros.hpp"
#include "reference/solve/buckling.hpp"
#include "verify/check.hpp"
#include "verify/studies/chains/chain_orders.hpp"
#include "verify/studies/chains/twisted_chain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace halfway::verify {
namespace {

using reference::Entry;
using reference::Real50;

/// Of the block of C3 taken as a rod, about its axis 1.
const Vec3<double> kBlock = Vec3<double>(1.59343e-3, 1.43837e-2, 4.00635e-4).cwiseInverse();

std::optional<reference::Buckling> of_one_joint(const Entry& entry) {
  reference::JointSpec spec;
  spec.xi = entry.probe_xi;
  spec.law = reference::LinearSpec{Eigen::MatrixXd(kBlock.asDiagonal())};
  return reference::first_buckling(entry, spec, 0);
}

/// The angle of each joint where the determinant has a zero of order `links`, from nearby: Newton for a zero
/// of that order, which does not converge at one of another.
Real50 critical_angle(const Entry& entry, int links, const Real50& nearby) {
  const auto determinant = [&](const Real50& angle) {
    return twisted(entry, kBlock, links, angle, EndMoment::fixed).determinant;
  };
  const Real50 step("1e-12");
  Real50 angle = nearby;
  for (int i = 0; i < 8; ++i) {
    const Real50 slope = (determinant(angle + step) - determinant(angle - step)) / (2 * step);
    const Real50 change = Real50(links) * determinant(angle) / slope;
    angle -= change;
    if (abs(change) < Real50("1e-10")) return angle;
  }
  return Real50(std::nan(""));
}

/// Where one joint has no critical moment a chain has none: its determinant keeps its sign up to 1.5 rad a
/// joint, before the pole of some Euler angles. Of an odd number of joints, whose determinant would change
/// it.
Finding no_critical(const Entry& entry) {
  constexpr int kAngles = 30;
  int changes = 0;
  for (int i = 1; i <= kAngles; ++i)
    changes += !(twisted(entry, kBlock, 3, 1.5 * i / kAngles, EndMoment::fixed).determinant > 0);
  return finding(fmt::format("chains/{}/buckling/none", entry.name))
      .about("chains")
      .of(std::string(entry.name), "angular")
      .measured(changes)
      .in("angles of 30")
      .at_most(0, "the determinant is that of one joint to the power of the links")
      .by(Oracle::closed_form);
}

/// All joints bear the same moment: the tangent of the chain is singular where that of one is.
Finding fixed_moment(const Entry& entry, int links, const reference::Buckling& one) {
  const Real50 angle = critical_angle(entry, links, one.angle * Real50("0.995"));
  const Real50 moment = twisted(entry, kBlock, links, angle, EndMoment::fixed).moment;
  return finding(fmt::format("chains/{}/buckling/{}", entry.name, links))
      .about("chains")
      .of(std::string(entry.name), "angular")
      .measured(double(moment / one.moment), fmt::format("{:.10g} N m", double(moment)))
      .in("critical moments of one joint")
      .equal(links, 1e-10 * links,
             "the determinant is that of one joint to the power of the links; what is iterated stops at a "
             "step of "
             "1e-10 rad, squared")
      .by(Oracle::closed_form);
}

std::vector<Finding> fixed_moments(const Entry& entry) {
  const auto one = of_one_joint(entry);
  if (!one) return {no_critical(entry)};
  return {fixed_moment(entry, 2, *one), fixed_moment(entry, 4, *one)};
}

/// Strip of GJ = 10, EI = (1, 0.65), L = 1, twisted by a moment whose increment is half of w x m.
const Vec3<double> kStrip(10, 1, 0.65);

/// Matrix exponential of the rod's equations; 13 digits.
constexpr double kStripRod = 2.485734079054;

/// First zero of the determinant, in multiples of the rod's; NaN where there is none below `most` of it.
double semi_tangential(const Entry& entry, int links, double most) {
  const double unit = kStripRod / (links * kStrip[0]);  // rad a joint, where the law is linear about its axis
  const auto positive = [&](double angle) {
    return twisted(entry, kStrip, links, angle, EndMoment::semi_tangential).determinant > 0;
  };
  constexpr double kStep = 0.01;
  for (double x = 0; x < most; x += kStep) {
    if (positive((x + kStep) * unit)) continue;
    const double angle = reference::last_where(positive, x * unit, (x + kStep) * unit, 50);
    return twisted(entry, kStrip, links, angle, EndMoment::semi_tangential).moment / kStripRod;
  }
  return std::nan("");
}

struct Kept {
  int links;
  double error, half_digit;
};
constexpr Kept kInvariantStrip[] = {{4, 0.045, 5e-4}, {16, 0.0027, 5e-5}, {32, 0.0007, 5e-5}};

std::vector<Finding> lateral_torsional(const Entry& entry) {
  const auto draft = [&](const std::string& what) {
    return finding(fmt::format("chains/{}/semi_tangential/{}", entry.name, what))
        .about("chains")
        .of(std::string(entry.name), "angular");
  };
  std::vector<Finding> out;
  const double error_16 = std::abs(semi_tangential(entry, 16, 1.25) - 1);
  const double error_32 = std::abs(semi_tangential(entry, 32, 1.25) - 1);
  out.push_back(
      draft("order")
          .measured(std::log2(error_16 / error_32),
                    fmt::format("{:.3g} off with 16 links, {:.3g} with 32", error_16, error_32))
          .equal(entry.convex_radius ? 4 : 2, 0.1,
                 "half-way joints 2, those that have the fourth order of a rod's energy 4; 16 links leave "
                 "0.1 of the next order, h^2 higher")
          .by(Oracle::closed_form));
  if (entry.name != "invariant") return out;
  for (const Kept& kept : kInvariantStrip) {
    out.push_back(
        draft(fmt::format("{}_links", kept.links))
            .measured(std::abs(semi_tangential(entry, kept.links, 1.25) - 1))
            .in("of the rod's moment")
            .equal(kept.error, kept.half_digit, "half of the last digit kept of an independent prototype")
            .by(Oracle::independent, kept.half_digit));
  }
  return out;
}

}  // namespace

void chain_buckling(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    checks.push_back(
        {fmt::format("chains/{}/buckling", entry.name), "chains", [&entry] { return fixed_moments(entry); }});
    if (expected_order(entry) != 2 || !entry.facts.node_order.angular.holds()) continue;
    checks.push_back({fmt::format("chains/{}/semi_tangential", entry.name), "chains",
                      [&entry] { return lateral_torsional(entry); }});
  }
}

}  // namespace halfway::verify
