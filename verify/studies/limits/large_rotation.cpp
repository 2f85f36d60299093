// What each formulation does at pi, at the full turn and at a gimbal lock, against closed forms of its
// measure. A formulation that is not in the table below is measured and reported.
#include "verify/oracle/property.hpp"
#include "verify/studies/limits/turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace halfway::verify {
namespace {

using reference::Crossing, reference::Gimbal, reference::axis_name, reference::crossing,
    reference::gimbal_locks, reference::kTurnAxes, reference::kTurnStiffness, reference::large_rotation,
    reference::turn_axis;
using reference::pi50;

/// What of a formulation decides its large rotations: measure, and for projected moments the frame.
enum class Measure {
  vector_projected,
  vector_conjugate,
  rod,
  conformal,
  quaternion,
  sine,
  cayley,
  euler_projected,
  euler_conjugate
};
struct Known {
  std::string_view name;
  Measure measure;
  double xi = 0;                   ///< frame of a projected moment
  std::string_view sequence = "";  ///< of Euler angles
};
constexpr Known kKnown[] = {{"attached_a", Measure::vector_projected, 0},
                            {"attached_b", Measure::vector_projected, 1},
                            {"invariant", Measure::vector_projected, 0.5},
                            {"intrinsic", Measure::vector_projected, 0.3},
                            {"chrono_body", Measure::vector_projected, 1},
                            {"exudyn_intrinsic", Measure::vector_projected, 0.5},
                            {"mbdyn_joint_inv", Measure::vector_projected, 0},
                            {"potential", Measure::vector_conjugate},
                            {"helicoidal", Measure::vector_conjugate},
                            {"rod4", Measure::rod},
                            {"rod34", Measure::rod},
                            {"conformal", Measure::conformal},
                            {"quaternion", Measure::quaternion},
                            {"fasse", Measure::quaternion},
                            {"jointc", Measure::sine},
                            {"cayley", Measure::cayley},
                            {"field_a", Measure::euler_projected, 0, "312"},
                            {"field_b", Measure::euler_projected, 1, "312"},
                            {"simbody_xyz", Measure::euler_conjugate, 0, "123"},
                            {"drake_rpy", Measure::euler_conjugate, 0, "321"}};

const Known* known(const Entry& entry) {
  const auto* found = std::find_if(std::begin(kKnown), std::end(kKnown),
                                   [&](const Known& k) { return k.name == entry.name; });
  return found == std::end(kKnown) ? nullptr : found;
}

constexpr double kPi = std::numbers::pi;
Vec3<double> stiffness() { return {kTurnStiffness[0], kTurnStiffness[1], kTurnStiffness[2]}; }

/// Jump of the moment across pi over |K| pi, none for a measure that is not known there.
std::optional<double> jump_at_pi(const Known& k, int axis) {
  const Vec3<double> n = turn_axis(axis).cast<double>(), Kn = stiffness().cwiseProduct(n);
  const double along = n.dot(Kn), size = stiffness().maxCoeff();
  // theta changes sign; so does the turn of the frame: Q + Q^T = 2 n n^T + 2 cos(xi pi) (1 - n n^T).
  const double across = std::cos(k.xi * kPi) * (Kn - along * n).norm();
  switch (k.measure) {
    case Measure::vector_projected:
      return 2 * std::hypot(along, across) / size;
    case Measure::vector_conjugate:
      return 2 * along / size;  // Gamma^-1 + Gamma^-T = 2 n n^T at pi
    case Measure::rod: {        // the same of K theta and the gradient of -(w x theta) . K^-1 (w x theta)/24
      const Vec3<double> u = Kn.cross(n);
      return 2 * std::abs(along - kPi * kPi / 6 * u.dot(u.cwiseQuotient(stiffness()))) / size;
    }
    case Measure::conformal:
      return 16 * along / (kPi * size);  // 4 tan(pi/4) / cos^2(pi/4), a quarter turn
    case Measure::quaternion:
    case Measure::sine:
      return 0;  // smooth functions of R
    default:
      break;
  }
  const bool is_outer = axis > 0 && !k.sequence.empty() && k.sequence[1] != char('0' + axis);
  if (is_outer) return 2 * along / size;
  return std::nullopt;
}

Draft named(const Entry& entry, const std::string& property, double value, const std::string& where) {
  return property_finding(entry, Kind::angular, property)
      .measured(value, where)
      .reported("not in the table of measures: measured only")
      .by(Oracle::closed_form);
}

/// Held to its closed form; what is not zero is a known failure of the formulation.
void expect(Draft& f, double expected, double limit, const std::string& reason) {
  f.equal(expected, limit, reason);
  if (expected > 0) f.within(expected - limit, expected + limit, reason);
}

/// 1e-20 rad beside the angle moments differ by 1e-20 of a few |K| from their limits; expected in double.
constexpr double kLimitAtAngle = 1e-14;

Finding at_pi(const Entry& entry, const Crossing& c, int axis) {
  const Known* k = known(entry);
  if (k != nullptr && k->measure == Measure::cayley) {
    Draft pole = named(entry, "pole_at_pi_axis_" + axis_name(axis), c.order, c.behaviour).in("order");
    expect(pole, 3, 1e-6, "tan(phi/2)/cos^2(phi/2): the third power of the distance");
    return pole;
  }
  Draft f = named(entry, "jump_at_pi_axis_" + axis_name(axis), c.jump, c.behaviour).in("|K| pi");
  if (k == nullptr) return f;
  if (const auto jump = jump_at_pi(*k, axis))
    expect(f, *jump, kLimitAtAngle, "closed form of the measure; rounding of the expected value");
  else
    f.reported("Euler angles about no axis of theirs: measured only");
  return f;
}

/// R is the identity there, and a function of R alone has forgotten the turn.
Finding at_full_turn(const Entry& entry, const Crossing& c, int axis) {
  return named(entry, "moment_at_full_turn_axis_" + axis_name(axis), c.moment, c.behaviour)
      .in("|K| 2 pi")
      .at_most(1e-19, "no rotation is left of a full turn: 1e-20 rad beside it the moment is 1e-20 |K|");
}

/// A quarter turn about the middle of three axes.
void add_middle_axis(std::vector<Finding>& out, const Entry& entry) {
  const Known* k = known(entry);
  if (k == nullptr || k->sequence.empty()) return;
  const int middle = k->sequence[1] - '0';
  const Crossing& c = large_rotation(entry, middle).across("pi/2");
  if (k->measure == Measure::euler_conjugate) {
    Draft f = named(entry, "pole_at_middle_axis", c.order, c.behaviour).in("order");
    expect(f, 1, 1e-6, "the axes of the outer turns meet as cos: the moment grows as 1/distance");
    out.push_back(f);
    return;
  }
  Vec3<double> outer = stiffness();
  outer[middle - 1] = 0;
  Draft f = named(entry, "jump_at_middle_axis", c.jump, c.behaviour).in("|K| pi/2");
  expect(f, 2 * outer.norm() / stiffness().maxCoeff(), kLimitAtAngle,
         "both outer angles jump from 0 to pi; the moment is projected, so it stays finite");
  out.push_back(f);
}

/// About the generic axis an outer Euler angle passes pi before or after the rotation does: where
/// tan(phi/2) = +-n_o/(n_p n_q), for the outer axis 3 of (2, 3, 6)/7: 7.
void add_outer_angle(std::vector<Finding>& out, const Entry& entry) {
  const Known* k = known(entry);
  if (k == nullptr || k->sequence.empty() || k->sequence[1] == '3') return;
  const Real50 before = Real50(2) * atan(Real50(7)), after = pi50() + pi50() - before;
  Crossing c = crossing(entry, turn_axis(0), "", before);
  const Crossing other = crossing(entry, turn_axis(0), "", after);
  if (!(larger(c.jump, other.jump) == c.jump)) c = other;
  Draft f = named(entry, "jump_of_outer_angle", c.jump, fmt::format("phi = {:.6g} pi", c.phi / kPi))
                .in("|K| phi")
                .reported("depends on the rate of the angles: measured only");
  if (k->measure == Measure::euler_projected) {
    expect(f, 2 * kPi * stiffness()[2] / (stiffness().maxCoeff() * c.phi), kLimitAtAngle,
           "the outer angle jumps by 2 pi, at 0.91 or 1.09 pi already");
  }
  out.push_back(f);
}

std::vector<Finding> turns(const Entry& entry) {
  std::vector<Finding> out;
  for (const int axis : kTurnAxes) {
    const auto& turned = large_rotation(entry, axis);
    out.push_back(at_pi(entry, turned.across("pi"), axis));
    out.push_back(at_full_turn(entry, turned.across("2 pi"), axis));
  }
  add_middle_axis(out, entry);
  add_outer_angle(out, entry);
  return out;
}

/// How many digits double loses before a lock.
Finding rounding(const Entry& entry, const Gimbal& g) {
  Measurement lost;
  for (std::size_t i = 0; i < g.distance.size() && g.distance[i] > 1e-13; ++i)
    lost.include(g.error[i] * g.distance[i] / std::numeric_limits<double>::epsilon(),
                 fmt::format("{:.2g} rad before", g.distance[i]));
  return property_finding(entry, Kind::angular, "gimbal_rounding")
      .measured(lost)
      .in("eps / distance")
      .at_most(6, fmt::format(
                      "rounded matrices tell the outer angles to a few eps/distance; 1e-6 is lost at {:.2g} "
                      "rad, 1e-3 at {:.2g}",
                      g.lost_1e6, g.lost_1e3))
      .by(Oracle::fifty_digits);
}

/// Which lock, how it grows, and where double loses its digits.
std::vector<Finding> gimbal(const Entry& entry) {
  const Known* k = known(entry);
  const auto& locks = gimbal_locks(entry);
  std::vector<Finding> out;
  Draft count = named(entry, "gimbal_locks", double(locks.size()), locks.empty() ? "" : locks[0].sequence);
  if (k != nullptr)
    expect(count, k->sequence.empty() ? 0 : 1, 0, "one for a measure of three angles, else none");
  out.push_back(count);
  for (const Gimbal& g : locks) {
    const bool is_conjugate = k != nullptr && k->measure == Measure::euler_conjugate;
    Draft tangent = named(entry, "gimbal_tangent_order", g.tangent_order, g.sequence);
    Draft load = named(entry, "gimbal_load_order", g.load_order, g.sequence);
    if (k != nullptr) {
      expect(tangent, is_conjugate ? 2 : 1, 1e-6, "one 1/cos for the rate, one for each conjugate moment");
      expect(load, is_conjugate ? 1 : 0, 1e-6, "1/cos for a conjugate moment, none for a projected one");
    }
    for (const Finding& f : {Finding(tangent), Finding(load), rounding(entry, g)}) out.push_back(f);
  }
  return out;
}

}  // namespace

void large_rotation(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    const std::string name(entry.name);
    checks.push_back({name + "/angular/large_rotation", "stability", [&entry] { return turns(entry); }});
    checks.push_back({name + "/angular/gimbal", "stability", [&entry] { return gimbal(entry); }});
  }
}

}  // namespace halfway::verify
