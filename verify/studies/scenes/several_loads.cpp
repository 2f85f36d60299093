// Forces at several points and moments of both kinds at once, some of them held: the balance of the loaded
// node, its tangent and the outputs, against loads that are added up at the node itself and where it stands
// in space.
#include "reference/numbers/random.hpp"
#include "reference/solve/path.hpp"
#include "verify/oracle/probes.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/replay.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace halfway::verify {
namespace {

using reference::LoadType;
using reference::Scene;
using reference::Setting;

/// A probe's joint under three forces and both moments, each of which alone would turn it by about `angle`,
/// rad: five times 0.1 is what jointc carries; and small ones that are held.
Scene loaded(const Entry& entry, Kind kind, double angle) {
  Scene out;
  out.name = "several_loads";
  out.joint = probes(entry, kind, 1, 1).front().spec;
  reference::Generator random(4711);
  const auto& law = std::get<reference::LinearSpec>(out.joint.law);
  const double size = angle * law.matrix.bottomRightCorner<3, 3>().diagonal().minCoeff();  // N m
  for (int i = 0; i < 3; ++i)
    out.loads.push_back({LoadType::fixed_force, random.vector(size), random.vector(0.5)});
  for (const LoadType type : {LoadType::fixed_moment, LoadType::follower_moment})
    out.loads.push_back({type, random.vector(size), Vec3<double>::Zero()});
  for (const LoadType type : {LoadType::follower_force, LoadType::fixed_force}) {
    out.loads.push_back({type, random.vector(size / 10), random.vector(0.5)});
    out.loads.back().held = true;
  }
  return out;
}

/// The node is clamped elsewhere than at the identity, and listed as either node.
Setting setting(bool nodes_exchanged) { return {nodes_exchanged, {0.3, -0.7, 0.5}, {0.2, 0.1, -0.4}}; }

/// Applied - internal at the loaded node, about the node, global axes: force, moment.
template <class T>
Eigen::Matrix<T, 6, 1> imbalance(const Entry& entry, const Scene& scene, const Setting& setting,
                                 const Pose<T>& node) {
  const Pose<T> clamped{setting.frame_shift.cast<T>(), so3::exp<T>(setting.frame_turn.cast<T>())};
  JointSpec spec = scene.joint;
  if (setting.nodes_exchanged) std::swap(spec.a, spec.b), spec.axis = -spec.axis;
  const auto q = setting.nodes_exchanged
                     ? reference::node_loads<T>(entry, spec, node, clamped, false).q.eval()
                     : reference::node_loads<T>(entry, spec, clamped, node, false).q.eval();
  Eigen::Matrix<T, 6, 1> out = -q.template segment<6>(setting.nodes_exchanged ? 0 : 6);
  for (const reference::SceneLoad& load : scene.loads) {
    const Vec3<T> value = load.value.cast<T>();
    const Vec3<T> global = follows(load.type) ? node.R * value : clamped.R * value;
    if (is_force(load.type)) {
      out.template head<3>() += global;
      out.template tail<3>() += (node.R * load.point.cast<T>()).cross(global);
    } else {
      out.template tail<3>() += global;
    }
  }
  return out;
}

/// What is left of the loads at the solver's equilibrium, over the largest of them.
double left_over(const Entry& entry, const Scene& scene, const Setting& setting) {
  reference::Path<double> path(scene, entry, scene.joint.xi, setting);
  if (path.advance(1).status != Status::converged) return std::nan("");
  const auto left = imbalance<double>(entry, scene, setting, path.node());
  double largest = 0;
  for (const auto& load : scene.loads) reference::keep_largest(largest, load.value.norm());
  return reference::largest_entry<double>(left.tail(strain_count(scene.joint.kind)).eval()) / largest;
}

/// node_tangent against central differences of that sum, at 50 digits: relative to its largest entry.
double tangent_error(const Entry& entry, const Scene& scene, const Setting& setting) {
  reference::Path<Real50> path(scene, entry, scene.joint.xi, setting);
  if (path.advance(1).status != Status::converged) return std::nan("");
  const Pose<Real50> node = path.node();
  const auto exact = path.problem().node_tangent(path.state().joint, Real50(1));
  const Eigen::Index n = exact.rows(), first = n == 6 ? 0 : 3;
  const Real50 h("1e-17");  // squared, it is beyond double
  Eigen::Matrix<Real50, 6, 6> differences;
  for (Eigen::Index j = first; j < 6; ++j) {
    Eigen::Matrix<Real50, 6, 1> sides[2];
    for (const int side : {0, 1}) {
      Pose<Real50> moved = node;
      const Vec3<Real50> step = (side == 0 ? h : Real50(-h)) * Vec3<Real50>::Unit(j % 3);
      if (j < 3)
        moved.x += step;
      else
        moved.R = so3::exp<Real50>(step) * node.R;
      sides[side] = imbalance<Real50>(entry, scene, setting, moved);
    }
    differences.col(j) = (sides[1] - sides[0]) / (2 * h);
  }
  const auto by_difference = differences.block(first, first, n, n).eval();
  return double(reference::largest_entry<Real50>((exact - by_difference).eval()) /
                reference::largest_entry<Real50>(by_difference));
}

/// What the outputs of the solver are off, rad and m, from where the node stands in space: its rotation and
/// its displacement since rest, in the axes of the scene.
double output_error(const Entry& entry, const Scene& scene, const Setting& setting) {
  reference::Path<double> path(scene, entry, scene.joint.xi, setting);
  const Pose<double> rest = path.problem().node(path.problem().start());
  if (path.advance(1).status != Status::converged) return std::nan("");
  const Pose<double> node = path.node();
  const Mat3<double> axes = so3::exp<double>(setting.frame_turn).transpose();
  const Vec3<double> theta = so3::log<double>(axes * node.R * rest.R.transpose() * axes.transpose());
  const Vec3<double> u = axes * (node.x - rest.x);
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, char('x' + i));
    reference::keep_largest(worst, std::abs(path.output("theta_" + axis) - theta[i]));
    if (scene.joint.kind != Kind::angular)
      reference::keep_largest(worst, std::abs(path.output("u_" + axis) - u[i]));
  }
  return worst;
}

Measurement worst(double (*measure)(const Entry&, const Scene&, const Setting&), const Entry& entry,
                  Kind kind) {
  Measurement out;
  for (const double angle : {0.02, 0.1}) {
    const Scene scene = loaded(entry, kind, angle);
    for (const bool exchanged : {false, true}) {
      const Setting at = setting(exchanged);
      if (out.include(measure(entry, scene, at), exchanged ? "nodes exchanged" : "nodes as written"))
        out.set_replay(scene_text(scene, entry, scene.joint.xi, at));
    }
  }
  return out;
}

}  // namespace

void several_loads(Checks& checks) {
  const auto kinds = {Kind::angular, Kind::linear_angular};
  add_property(checks, "several_loads", kinds, [](const Entry& entry, Kind kind, Draft f) {
    return f.measured(worst(left_over, entry, kind))
        .in("of the largest load")
        .at_most(1e-12, "some tens of roundings of loads, levers and strains of order 1")
        .by(Oracle::independent);
  });
  add_property(checks, "several_loads_outputs", kinds, [](const Entry& entry, Kind kind, Draft f) {
    return f.measured(worst(output_error, entry, kind))
        .in("rad, m")
        .at_most(1e-14, "some tens of roundings of positions and rotation matrices of order 1")
        .by(Oracle::independent);
  });
  add_property(checks, "several_loads_tangent", kinds, [](const Entry& entry, Kind kind, Draft f) {
    return f.measured(worst(tangent_error, entry, kind))
        .in("of the largest entry")
        .at_most(1e-14, "joint frames are orthonormal in double only")
        .by(Oracle::independent);
  });
}

}  // namespace halfway::verify
