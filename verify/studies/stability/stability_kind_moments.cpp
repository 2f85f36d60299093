// Moments that keep their direction, follow the node, or share its turn.
#include "reference/solve/stability/moments.hpp"
#include "verify/check.hpp"
#include "verify/oracle/measures.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <numbers>

namespace halfway::verify {
namespace {

using namespace reference;

std::string name_of(MomentType type, const std::string& what) {
  return std::string("stability_kind/") + to_string(type) + "/" + what;
}

MomentLoad<Real50> generic_load(MomentType type, int axis) { return {type, axis, Real50(0.3)}; }

/// Value, both derivatives and the potential against dual numbers.
std::vector<Finding> by_duals(MomentType type) {
  Generator random(51);
  Measurement worst;
  for (int i = 0; i < 6; ++i) {
    const Mat3<Real50> R = so3::exp<Real50>(random.vector(2).cast<Real50>());
    const Real50 M(random.uniform(1, 3));
    const auto load = generic_load(type, i % 3);
    const MomentLoad<Dual50> dual_load{type, i % 3, Dual50(load.square_at)};
    const AppliedMoment<Real50> m = applied_moment(load, M, R);
    for (int k = 0; k < 4; ++k) {
      Vec3<Dual50> w = Vec3<Dual50>::Zero();
      if (k < 3) w[k].d = Real50(1);
      const Mat3<Dual50> turned = so3::exp(w) * R.cast<Dual50>();
      const Dual50 magnitude(M, Real50(k == 3 ? 1 : 0));
      const auto dual = applied_moment(dual_load, magnitude, turned);
      Vec3<Real50> difference = tapped(k < 3 ? Vec3<Real50>(m.m_w.col(k)) : m.m_M);
      for (int j = 0; j < 3; ++j) difference[j] -= dual.m[j].d;
      worst.include(double(largest_entry<Real50>(difference)), k < 3 ? "spin" : "magnitude");
      const auto potential = moment_potential(dual_load, magnitude, turned);
      if (potential && k < 3) worst.include(double(abs(m.m[k] + potential->d)), "potential");
    }
  }
  return {finding(name_of(type, "derivatives"))
              .about("stability_kind")
              .measured(worst)
              .in("N m")
              .at_most(1e-46, "50 digits of moments of up to 3 N m, a few operations")
              .by(Oracle::independent)};
}

/// Ziegler: two half turns across a fixed moment cost nothing, the half turn about it that undoes them does.
std::vector<Finding> work_round_a_loop(MomentType type) {
  const bool dead_forces = moment_potential<double>({type, 2, 0}, 1, Mat3<double>::Identity()).has_value();
  return {
      finding(name_of(type, "ziegler_work"))
          .about("stability_kind")
          .measured(tapped(ziegler_work(type)))
          .in("J")
          .equal(
              dead_forces ? 0 : -std::numbers::pi, 1e-14,
              "a unit moment along or across the axis of each leg; 24 weights and as many eps of pi at worst")
          .by(Oracle::closed_form)};
}

/// Where the arms are square the semi-tangential moment turns by half of what the follower does.
std::vector<Finding> half_a_follower() {
  const Real50 angle("0.7"), M(3);
  const Mat3<Real50> R = so3::exp<Real50>(angle * Vec3<Real50>::UnitZ());
  const auto semi = applied_moment<Real50>({MomentType::semi_tangential, 2, angle}, M, R);
  const auto follower = applied_moment<Real50>({MomentType::follower, 2, angle}, M, R);
  return {
      finding(name_of(MomentType::semi_tangential, "half_a_follower"))
          .about("stability_kind")
          .measured(double(largest_entry<Real50>(Mat3<Real50>(Real50(2) * tapped(semi.m_w) - follower.m_w))))
          .in("N m")
          .at_most(1e-48, "50 digits of 3 N m")
          .by(Oracle::closed_form)};
}

}  // namespace

void stability_kind_moments(Checks& checks) {
  for (MomentType type : kMomentTypes) {
    checks.push_back({name_of(type, "derivatives"), "stability", [type] { return by_duals(type); }});
    checks.push_back(
        {name_of(type, "ziegler_work"), "stability", [type] { return work_round_a_loop(type); }});
  }
  checks.push_back({name_of(MomentType::semi_tangential, "half_a_follower"), "stability", half_a_follower});
}

}  // namespace halfway::verify
