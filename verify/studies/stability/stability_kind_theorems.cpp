// Divergence and flutter against closed forms and theorems.
#include "verify/oracle/property.hpp"
#include "verify/studies/stability/block_loads.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

using namespace reference;

constexpr MomentSetting kFollower{MomentType::follower, false};

/// What was counted, by name.
struct Listed {
  int count = 0;
  std::string which;
  void add(const std::string& what) { which += (count++ > 0 ? ", " : "") + what; }
};

/// Loads with a potential under a fixed and under a follower moment have transposed tangents, S -+ [m]/2:
/// the same critical loads, for every body.
Finding fixed_is_follower(const Entry& entry, Kind kind, Draft f) {
  const auto same = [](const std::optional<Critical>& a, const std::optional<Critical>& b) {
    return a && b ? relative(a->load, b->load) <= 1e-38 : !a && !b;  // both located to 40 digits
  };
  Listed different;
  for (int axis = 0; axis < 3; ++axis) {
    for (const BodyInertia& body : kBlockBodies) {
      const auto &fixed = begun_loads(entry, axis, kFixed, body),
                 &follower = begun_loads(entry, axis, kFollower, body);
      if (same(fixed.divergence, follower.divergence) && same(fixed.flutter, follower.flutter)) continue;
      different.add("axis " + std::to_string(axis + 1) + " (" + body.name + ")");
    }
  }
  f.measured(different.count, different.which).in("of 6 paths differ");
  if (!entry.has_potential(kind)) return f.reported("no potential: the two need not agree");
  return f.at_most(0, "transposed matrices have the same eigenvalues; loads are compared to 38 of 40 digits")
      .by(Oracle::closed_form);
}

/// Loads with a potential under a fixed moment, body of three equal inertias: the lateral tangent is S -
/// [m]/2, which has complex eigenvalues where |m| exceeds the difference of those of S. Held at the flutter
/// found.
Finding flutter_condition(const Entry& entry, Kind kind, Draft f) {
  if (!entry.has_potential(kind)) return f.left_out("the condition holds for loads that have a potential");
  Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& c = begun_loads(entry, axis, kFixed, kRound);
    if (!c.flutter) continue;
    const auto p = loaded_state<Real50>(entry, block_joint(entry), axis, kFixed, c.flutter->angle);
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Real50 half = (p.J(i, j) + p.J(j, i)) / Real50(2), gap = p.J(i, i) - p.J(j, j);
    const Real50 gap2 = gap * gap + Real50(4) * half * half;
    worst.include(relative(gap2, p.load * p.load), "axis " + std::to_string(axis + 1));
  }
  if (worst.is_empty())
    return f.left_out("no flutter under a fixed moment about any axis of the block of C3");
  return f.measured(worst).in("relative").at_most(1e-38, "located to 40 digits").by(Oracle::closed_form);
}

/// Flutter needs a tangent that is not symmetric: none under dead forces for loads with a potential.
Finding flutter_under_couples(const Entry& entry, Kind kind, Draft f) {
  Listed flutter;
  for (int axis = 0; axis < 3; ++axis) {
    for (const MomentSetting& setting : kMomentSettings) {
      if (!moment_potential<double>({setting.type, axis, 0}, 1, Mat3<double>::Identity())) continue;
      for (const BodyInertia& body : kBlockBodies) {
        if (!begun_loads(entry, axis, setting, body).flutter) continue;
        flutter.add(std::string(to_string(setting)) + " about " + std::to_string(axis + 1) + " (" +
                    body.name + ")");
      }
    }
  }
  f.measured(flutter.count, flutter.which).in("of 18 paths");
  if (!entry.has_potential(kind)) return f.reported("no potential: the joint itself can feed the motion");
  return f.at_most(0, "a symmetric tangent has real eigenvalues").by(Oracle::closed_form);
}

Finding flutter_angle(const std::string& formulation, const MomentSetting& setting, int axis,
                      const Vec3<double>& stiffness, const std::string& name) {
  const Entry& entry = *find_formulation(formulation);
  JointSpec spec;
  spec.law = LinearSpec{stiffness.asDiagonal(), false};
  const auto found = PrimaryPath(entry, spec, axis).critical(setting, kRound).flutter;
  const double p = stiffness[(axis + 1) % 3], q = stiffness[(axis + 2) % 3];
  return finding("stability_kind/closed_form/" + formulation + "/" + name)
      .of(formulation)
      .about("stability_kind")
      .measured(found ? double(found->angle) : std::nan(""))
      .in("rad")
      .equal(2 * std::atan(std::abs(p - q) / (2 * std::sqrt(p * q))), 1e-15,
             "tan(phi/2) = |p - q| / (2 sqrt(p q)) with the lateral stiffnesses p, q; a few eps of the angle")
      .by(Oracle::closed_form);
}

/// The stress that is constant in a node's axes, m = K theta: the lateral tangent is
/// ((p g, p phi/2), (-q phi/2, q g)), g = phi/2 cot(phi/2). By exchanging the nodes: a moment that follows b.
std::vector<Finding> closed_forms() {
  std::vector<Finding> out;
  const Vec3<double> block_like(627.6, 69.52, 2496), round(5, 3, 3), nearly(5, 3, 3.03);
  const std::pair<std::string, MomentSetting> cases[] = {{"attached_a", kFixed}, {"attached_b", kFollower}};
  for (const auto& [formulation, setting] : cases) {
    for (int axis = 0; axis < 3; ++axis)
      out.push_back(
          flutter_angle(formulation, setting, axis, block_like, "axis_" + std::to_string(axis + 1)));
    // A round shaft flutters under any moment, a nearly round one (1 %) at 10 mrad.
    out.push_back(flutter_angle(formulation, setting, 0, round, "round"));
    out.push_back(flutter_angle(formulation, setting, 0, nearly, "nearly_round"));
  }
  return out;
}

}  // namespace

void stability_kind_theorems(Checks& checks) {
  checks.push_back({"stability_kind/closed_form", "stability", closed_forms});
  add_property(checks, "fixed_is_follower", {Kind::angular}, fixed_is_follower);
  add_property(checks, "flutter_condition", {Kind::angular}, flutter_condition);
  add_property(checks, "flutter_under_couples", {Kind::angular}, flutter_under_couples);
}

}  // namespace halfway::verify
