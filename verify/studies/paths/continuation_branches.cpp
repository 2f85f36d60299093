// Branchings of the unskewed buckling case: located on the path, followed both ways.
#include "reference/solve/buckling.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/paths/block_paths.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Branch;
using reference::EquilibriumPath;
using reference::Real50;

constexpr int kAxis = 0;

/// Residual of a pose at 50 digits over the load, by the joint alone.
double residual(const Entry& entry, const reference::Scene& s, const reference::PathPoint& p) {
  reference::JointSpec spec = s.joint;
  spec.xi = entry.probe_xi;
  const auto q = reference::node_loads<Real50>(entry, spec, {}, reference::cast<Real50>(p.state.b), false).q;
  Vec3<Real50> m = q.tail<3>();
  m[kAxis] -= Real50(s.loads.front().value[kAxis]) * Real50(p.state.factor);
  return double(sqrt(m.squaredNorm())) / std::abs(p.state.factor);
}

/// The first singular point against the first zero of the determinant, an independent road.
Finding first_singular(const Entry& entry, const reference::Scene& s, const EquilibriumPath& primary,
                       Draft f) {
  reference::JointSpec spec = s.joint;
  spec.xi = entry.probe_xi;
  auto expected = reference::first_buckling(entry, spec, kAxis);
  if (expected && double(expected->moment) > s.factor_end) expected.reset();
  f.by(Oracle::independent);
  if (!expected)
    return f
        .measured(primary.points.size() < 2 ? std::nan("") : double(primary.singular.size()), primary.outcome)
        .in("singular points")
        .at_most(
            0, "the determinant has no zero below pi and the whole load: nothing must be found on the path");
  f.in("relative")
      .at_most(
          4e-16,
          "first zero of the determinant along the axis, bisected at 50 digits; both handed over in double");
  if (primary.singular.empty()) return f.measured(std::nan(""), "nothing found: " + primary.outcome);
  const double moment = double(expected->moment);
  const auto& first = primary.singular.front();
  return f.measured(std::abs(first.state.factor / moment - 1),
                    fmt::format("{} at {:.13g} N m, phi = {:.12g} rad; located to {:.0e}",
                                to_string(first.type), moment, double(expected->angle), first.located_to));
}

/// Every point of the other path is an equilibrium, off the axis.
Finding equilibria(const Entry& entry, const reference::Scene& s, const std::vector<Branch>& all, Draft f) {
  Measurement worst;
  for (std::size_t i = 1; i < all.size(); ++i) {
    for (const auto& p : all[i].path.points) {
      if (p.state.factor <= 0) continue;
      const bool off_axis = so3::log<double>(p.state.b.R).tail<2>().norm() > 1e-3;
      worst.include(off_axis ? residual(entry, s, p) : std::nan(""),
                    fmt::format("{:.6g} N m{}", p.state.factor, off_axis ? "" : ", on the axis"));
    }
  }
  return f.measured(worst)
      .in("relative to the load")
      .at_most(
          3e-14,
          "imbalance at 50 digits of poses in double: eps times the stiffness of 2500 N m/rad over a moment "
          "that is as small as 20 N m where a path is unloaded again")
      .by(Oracle::fifty_digits);
}

/// The half-turn about the axis maps the problem onto itself, and one half onto the other.
Finding mirrored(const std::vector<Branch>& all, Draft f) {
  Measurement worst;
  const Mat3<double> half_turn = Vec3<double>(1, -1, -1).asDiagonal();
  for (std::size_t i = 1; i < all.size(); i += 2) {
    const bool both = i + 1 < all.size() && all[i].path.points.size() == all[i + 1].path.points.size();
    if (!both) worst.include(std::nan(""), "one half alone, or of another length");
    if (!both) continue;
    for (std::size_t k = 0; k < all[i].path.points.size(); ++k) {
      const Mat3<double> image = half_turn * all[i].path.points[k].state.b.R * half_turn;
      const Mat3<double> between = image * all[i + 1].path.points[k].state.b.R.transpose();
      worst.include(so3::log<double>(between).norm(), all[i].path.outcome);
    }
  }
  return f.measured(worst)
      .in("rad")
      .at_most(1e-15,
               "law and load are symmetric about the axis, so the halves are images of each other: eps")
      .by(Oracle::closed_form);
}

std::vector<Finding> branching(const Entry& entry) {
  const reference::Scene& s = straight_block();
  const std::vector<Branch>& all = straight_branches(entry).branches;
  const EquilibriumPath& primary = all.front().path;
  const auto named = [&](const char* what) {
    return property_finding(entry, Kind::angular, std::string("c3_branching_") + what);
  };
  std::vector<Finding> out{first_singular(entry, s, primary, named("moment"))};
  if (all.size() < 2) return out;
  out.push_back(equilibria(entry, s, all, named("equilibria")));
  out.push_back(mirrored(all, named("halves")));
  return out;
}

}  // namespace

void continuation_branches(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    checks.push_back({property_name(entry, Kind::angular, "c3_branching"), "stability",
                      [&entry] { return branching(entry); }});
  }
}

}  // namespace halfway::verify
