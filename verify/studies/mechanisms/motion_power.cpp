// Scenes in time: what dampers take, moment by moment and over a motion; momenta of bodies that nothing
// holds.
#include "reference/mechanism/motion/beginning.hpp"
#include "reference/mechanism/motion/moving_scene.hpp"
#include "reference/scene/any_scene.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/dynamics/splitting.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/motion.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::Curve;
using reference::MechanismScene;
using reference::mechanism::Moving;
using reference::mechanism::MovingScene;
using Dual50 = reference::Dual<Real50>;

/// A pose on its way: its dual part is its rate.
Pose<Dual50> on_its_way(const Pose<double>& pose, const Twist<double>& twist) {
  const Mat3<double> R_rate = skew<double>(twist.w) * pose.R;
  Pose<Dual50> out;
  for (int i = 0; i < 3; ++i) out.x[i] = {Real50(pose.x[i]), Real50(twist.v[i])};
  for (int i = 0; i < 9; ++i)
    out.R(i / 3, i % 3) = {Real50(pose.R(i / 3, i % 3)), Real50(R_rate(i / 3, i % 3))};
  return out;
}

/// What a joint takes of the motion, by three roads, W.
struct Power {
  double by_loads = 0;   ///< its loads times the motion of its nodes
  double by_energy = 0;  ///< what the spring stores, and what the strains of `potential` and the damper make
  double damper = 0;     ///< the latter alone
  double told = 0;       ///< of the damper, by the motion itself
  double size = 0;       ///< of the terms of the first
};

Power power_of(const MovingScene& moving, const Moving& now, std::size_t j) {
  const auto& joint = moving.scene().joints[j];
  const std::size_t a = std::size_t(joint.a), b = std::size_t(joint.b);
  const Eigen::Matrix<double, 12, 1> q = tapped(moving.joint_loads(j, now));
  Eigen::Matrix<double, 12, 1> motion;
  motion << now.twists[a].v, now.twists[a].w, now.twists[b].v, now.twists[b].w;
  const auto at_a = on_its_way(now.nodes[a], now.twists[a]), at_b = on_its_way(now.nodes[b], now.twists[b]);
  const auto strain = reference::find_formulation("potential")->in_dual50.strain(moving.spec(j), at_a, at_b);
  Eigen::VectorXd rate(strain.size());
  for (int i = 0; i < rate.size(); ++i) rate[i] = double(strain[i].d);
  const auto stored = moving.entry().in_dual50.energy(moving.spec(j), at_a, at_b);
  Power out;
  out.by_loads = q.dot(motion);
  out.damper = rate.dot(joint.damping * rate);
  out.by_energy = stored ? double(stored->d) + out.damper : std::nan("");
  out.told = tapped(moving.joint_power(j, now));
  out.size = q.cwiseAbs().dot(motion.cwiseAbs());
  return out;
}

/// At the start of a generic motion, and at others of its states. Without a potential the spring's power is
/// of no energy, and the damper's alone is compared.
Measurement power_off(const Entry& entry, bool has_potential) {
  const MechanismScene scene = generic_motion(entry);
  const reference::Choice choice{&entry, entry.probe_xi};
  const MovingScene moving(scene, choice, reference::mechanism::beginning(scene, choice).nodes);
  Measurement out;
  reference::dynamics::State state = moving.start();
  for (int i = 0; i < 4; ++i) {
    const Moving now = moving.moving(state);
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      const Power p = power_of(moving, now, j);
      const bool takes = p.told > 0;
      out.include(takes ? std::abs(p.told - p.damper) / p.damper : std::nan(""), scene.joints[j].name);
      if (has_potential) out.include(std::abs(p.by_loads - p.by_energy) / p.size, scene.joints[j].name);
    }
    reference::dynamics::advance(moving.system(), reference::dynamics::Order::two, 0.02, 1, state);
  }
  return out;
}

/// From the scene of the folder: no joint of it holds the bodies. Gentler where the energy is convex for
/// small rotations alone.
Curve free_pair(const Entry& entry) {
  for (MechanismScene scene : reference::motion_scenes()) {
    if (scene.name != "free_pair") continue;
    if (reference::convex_radius(entry, scene.joints.front().spec) < 1) {
      reference::SceneStart& start = scene.bodies.back().start;
      for (Vec3<double>* part : {&start.theta, &start.u, &start.velocity, &start.spin}) *part *= 0.2;
    }
    return reference::solve_motion(scene, {&entry, entry.probe_xi});
  }
  return {};
}

double column(const Curve& curve, std::size_t row, const char* name) {
  const auto at = std::ranges::find(curve.columns, name) - curve.columns.begin();
  return tapped(curve.rows.at(row).at(std::size_t(at)));
}

/// Largest change of what stays, over the largest that it could be.
Measurement momenta_off(const Curve& curve) {
  if (!curve.converged) return {std::nan(""), curve.outcome};
  Measurement out;
  for (const char* name : {"p_x", "p_y", "L_x", "L_y", "L_z"}) {
    for (std::size_t i = 1; i < curve.rows.size(); ++i)
      out.include(std::abs(column(curve, i, name) - column(curve, 0, name)), name);
  }
  return out;
}

Measurement balance_off(const Curve& curve) {
  if (!curve.converged) return {std::nan(""), curve.outcome};
  Measurement out;
  for (std::size_t i = 1; i < curve.rows.size(); ++i) {
    const double taken = column(curve, i, "dissipated") - column(curve, i - 1, "dissipated");
    out.include(taken >= 0 ? std::abs(column(curve, i, "balance")) : std::nan(""),
                "J; a damper gives nothing");
  }
  return out;
}

}  // namespace

void motion_power(Checks& checks) {
  add_property(checks, "motion_power", {Kind::linear_angular}, [](const Entry& entry, Kind kind, Draft f) {
    return f.measured(power_off(entry, entry.has_potential(kind)))
        .in("of the sum of |load| |rate|")
        .at_most(1e-13, "some hundred roundings of double against duals at 50 digits")
        .by(Oracle::independent);
  });
  add_property(checks, "motion_momenta", {Kind::linear_angular}, [](const Entry& entry, Kind kind, Draft f) {
    const Measurement off = momenta_off(free_pair(entry));
    if (!entry.facts.moment_balance.of(kind).holds())
      return f.measured(off)
          .in("SI")
          .at_least(1e-6, "its moments do not balance, and angular momentum drifts")
          .by(Oracle::closed_form);
    return f.measured(off)
        .in("SI")
        .at_most(1e-7, "of 1 kg m/s: some hundred steps at a tolerance of 1e-9")
        .by(Oracle::closed_form);
  });
  add_property(checks, "motion_balance", {Kind::linear_angular}, [](const Entry& entry, Kind kind, Draft f) {
    const Measurement off = balance_off(free_pair(entry));
    if (!entry.has_potential(kind))
      return f.measured(off).in("J").reported("the law itself makes or loses energy: not held");
    return f.measured(off)
        .in("J")
        .at_most(1e-7, "of 1 J: some hundred steps at a tolerance of 1e-9")
        .by(Oracle::closed_form);
  });
}

}  // namespace halfway::verify
