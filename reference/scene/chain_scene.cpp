#include "reference/scene/chain_scene.hpp"

#include "reference/scene/joint/read_joint.hpp"
#include "reference/scene/read_mechanism.hpp"
#include "reference/scene/scene_head.hpp"

#include <cmath>

namespace halfway::reference {
namespace {

/// Ten times more than rounding leaves anything of.
constexpr int kMostLinks = 10000000;

/// Of the way to where the end is held.
constexpr int kMostHeldSteps = 10000;

const Names kChainLoads = {"fixed_force",     "follower_force",         "fixed_moment",
                           "follower_moment", "semi_tangential_moment", "quasi_tangential_moment"};

/// rad/m and 1/m, N m^2 and N m^2/rad are the same.
constexpr Dimension kCurvature{0, -1, 1, true}, kBending{1, 2, -1, true};

/// One number for axes 2 and 3 of the section, or one for each.
void read_both(const Field& field, const Dimension& dimension, double& second, double& third) {
  if (!field.is_array() && !field.is_table()) {
    second = third = field.positive(dimension);
    return;
  }
  const Eigen::Vector2d both = field.vector<2>("a number > 0, or 2 of them: for axes 2 and 3", dimension);
  if (!(both.minCoeff() > 0)) field.refuse("has one that is not positive", "numbers > 0");
  second = both[0];
  third = both[1];
}

Pose<double> read_pose(const Field& field) {
  Pose<double> out;
  if (const auto x = field.find("x")) out.x = x->vector<3>("3 numbers, m, global axes", dimension::length);
  if (const auto h = field.find("h")) out.R = read_rotation(*h);
  return out;
}

chain::Section read_section(const Field& chain) {
  chain::Section out;
  out.GJ = chain.at("GJ", "a number > 0, N m^2").positive(kBending);
  read_both(chain.at("EI", "one or two numbers > 0, N m^2"), kBending, out.EI2, out.EI3);
  out.EA = chain.at("EA", "a number > 0, N").positive(dimension::force);
  read_both(chain.at("GA", "one or two numbers > 0, N"), dimension::force, out.GA2, out.GA3);
  return out;
}

chain::Chain read_chain(const Field& field) {
  field.has_only({"links", "length", "GJ", "EI", "EA", "GA", "curvature", "root", "node_order"});
  chain::Chain out;
  out.links = field.at("links", "an integer > 0").integer(1, kMostLinks);
  out.length = field.at("length", "a number > 0, m").positive(dimension::length);
  out.section = read_section(field);
  if (const auto curvature = field.find("curvature"))
    out.curvature = curvature->vector<3>("3 numbers, 1/m: twist, curvature about axes 2 and 3", kCurvature);
  if (const auto root = field.find("root")) {
    root->has_only({"x", "h"});
    out.root = read_pose(*root);
  }
  if (const auto order = field.find("node_order"))
    out.node_order = order->one_of({"root_first", "tip_first"}) == "root_first" ? chain::NodeOrder::root_first
                                                                                : chain::NodeOrder::tip_first;
  return out;
}

/// Of a pair of forces, axes of the last node: across their moment at rest.
Vec3<double> read_arm(const Field& load, const Vec3<double>& moment, const Mat3<double>& at_rest) {
  constexpr const char* kArm =
      "3 numbers, axes of the last node: the direction of the arm, across the moment at rest";
  const Field field = load.at("arm", kArm);
  const Vec3<double> out = field.vector<3>(kArm);
  if (out.isZero(0)) field.refuse("has no direction", kArm);
  if (!(std::abs(moment.dot(at_rest * out)) <= 1e-9 * moment.norm() * out.norm()))
    field.refuse("is not across the moment at rest", kArm);
  return out;
}

/// @param at_rest  orientation of the last node
void add_load(const Field& load, const Mat3<double>& at_rest, chain::EndLoads& out) {
  load.has_only({"type", "value", "arm"});
  const NamedLoad read = read_load(load, kChainLoads);
  Vec3<double>* const loads[] = {&out.force, &out.follower_force, &out.moment, &out.follower_moment};
  if (kChainLoads[std::size_t(read.type)] == "quasi_tangential_moment") {
    out.virial += chain::quasi_tangential(read.value, read_arm(load, read.value, at_rest), at_rest);
    return;
  }
  if (const auto arm = load.find("arm"))
    arm->refuse("is an arm of another load", "arm beside quasi_tangential_moment only");
  if (kChainLoads[std::size_t(read.type)] == "semi_tangential_moment")
    out.virial += chain::semi_tangential(read.value, at_rest);
  else
    *loads[read.type] += read.value;
}

/// The last node is held, or loads act on it along a path.
void read_end(const Field& file, ChainScene& scene) {
  scene.points = 1;
  if (const auto held = file.find("held")) {
    for (const char* key : {"load", "path"}) {
      if (const auto other = file.find(key)) other->refuse("stands beside [held]", "one of the two");
    }
    held->has_only({"x", "h", "steps"});
    scene.held = read_pose(*held);
    if (const auto steps = held->find("steps")) scene.held_steps = steps->integer(1, kMostHeldSteps);
    return;
  }
  const chain::Chain& c = scene.chain;
  const Mat3<double> at_rest = c.root.R * so3::exp<double>(c.length * c.curvature);
  for (const Field load : loads_of(file)) add_load(load, at_rest, scene.loads);
  if (const auto path = file.find("path")) {
    path->has_only({"factor_end", "points"});
    read_path(*path, scene);
  }
}

}  // namespace

ChainScene chain_scene(const Field& file, const std::filesystem::path& path) {
  Names keys = kHeadKeys;
  keys.insert(keys.end(), {"chain", "load", "held"});
  if (const auto joint = file.find("joint")) joint->refuse("stands beside [chain]", "one of the two");
  if (const auto time = file.find("time"))
    time->refuse("stands beside a table [chain], and chains are solved at rest alone",
                 "[path] or [held] beside [chain]; or bodies and joints beside [time]");
  file.has_only(keys);
  ChainScene scene;
  read_title(file, path, scene);
  scene.chain = read_chain(file.at("chain", "a table [chain]"));
  read_end(file, scene);
  read_outputs(file, {"x", "y", "z", "theta_x", "theta_y", "theta_z"}, scene);
  read_formulations(
      file, {}, [](const Entry&) { return std::nullopt; }, scene);
  read_references(file, kRod, scene);
  return scene;
}

}  // namespace halfway::reference
