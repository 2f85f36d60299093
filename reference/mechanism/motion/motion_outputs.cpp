#include "reference/mechanism/motion/motion_outputs.hpp"

#include <algorithm>
#include <stdexcept>

namespace halfway::reference::mechanism {
namespace {

/// 0, 1, 2 of a name that ends with x, y, z.
int axis_of(std::string_view name) { return name.back() - 'x'; }

double body_output(const MovingScene& moving, const Moment& moment, std::size_t i, std::string_view what) {
  const Pose<double>&node = moment.now.nodes[i], &rest = moving.rest(i);
  const Twist<double>& twist = moment.now.twists[i];
  if (what.starts_with("theta_")) return so3::log<double>(node.R * rest.R.transpose())[axis_of(what)];
  if (what.starts_with("u_")) return (node.x - rest.x)[axis_of(what)];
  return (what.starts_with("v_") ? twist.v : twist.w)[axis_of(what)];
}

double joint_output(const MovingScene& moving, const Moment& moment, std::size_t j, std::string_view what) {
  const SceneJoint& joint = moving.scene().joints[j];
  const Pose<double>&a = moment.now.nodes[std::size_t(joint.a)], &b = moment.now.nodes[std::size_t(joint.b)];
  if (what == "energy") return stored_energy(moving.entry(), moving.spec(j), a, b);
  if (what == "power") return moving.joint_power(j, moment.now);
  if (what.starts_with("strain_"))
    return moving.entry().in_double.strain(moving.spec(j), a, b)[what.back() - '1'];
  const auto q = moving.joint_loads(j, moment.now);
  const int node = what.front() == 'a' ? 0 : 6, sort = what[2] == 'f' ? 0 : 3;
  return -q[node + sort + axis_of(what)];
}

template <class All>
std::size_t place_of(const All& all, std::string_view name) {
  return std::size_t(std::ranges::find_if(all, [&](const auto& x) { return x.name == name; }) - all.begin());
}

}  // namespace

double motion_output(const MovingScene& moving, const Moment& moment, double at_start,
                     const std::string& name) {
  const Energies& energies = moment.energies;
  if (name == "energy") return energies.strain;
  if (name == "kinetic") return energies.kinetic;
  if (name == "dissipated") return energies.dissipated;
  if (name == "work") return energies.work;
  if (name == "balance") return energies.total() - at_start;
  const auto dot = name.find('.');
  if (dot == std::string::npos && name.starts_with("p_"))
    return moving.momenta(moment.state).linear[axis_of(name)];
  if (dot == std::string::npos && name.starts_with("L_"))
    return moving.momenta(moment.state).angular[axis_of(name)];
  const std::string owner = dot == std::string::npos ? "b" : name.substr(0, dot);
  const std::string what = dot == std::string::npos ? name : name.substr(dot + 1);
  const auto& scene = moving.scene();
  if (const std::size_t i = place_of(scene.bodies, owner); i < scene.bodies.size())
    return body_output(moving, moment, i, what);
  if (const std::size_t j = place_of(scene.joints, owner); j < scene.joints.size())
    return joint_output(moving, moment, j, what);
  throw std::invalid_argument("unknown output " + name);
}

}  // namespace halfway::reference::mechanism
