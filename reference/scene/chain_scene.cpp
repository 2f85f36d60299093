#include "reference/scene/chain_scene.hpp"

#include "reference/scene/read_joint.hpp"
#include "reference/scene/scene_head.hpp"

#include <algorithm>

namespace halfway::reference {
namespace {

/// A hundred times what the published ones take: 1 KB of memory each.
constexpr int kMostLinks = 10000000;

const Names kChainLoads = {"fixed_force", "follower_force", "fixed_moment", "follower_moment"};

/// The same about both axes of the section, or one number for each.
Eigen::Vector2d two_stiffnesses(const Field& field) {
  if (!field.is_array()) return Eigen::Vector2d::Constant(field.positive());
  const Eigen::Vector2d out = field.vector<2>("a number > 0, or 2 of them: for axes 2 and 3");
  if (out.minCoeff() <= 0) field.refuse("has one that is not positive", "numbers > 0");
  return out;
}

Pose<double> read_root(const Field& root) {
  root.has_only({"x", "h"});
  Pose<double> out;
  if (const auto x = root.find("x")) out.x = x->vector<3>("3 numbers, m, global axes");
  if (const auto h = root.find("h")) out.R = read_rotation(*h);
  return out;
}

void read_chain(const Field& chain, ChainScene& out) {
  chain.has_only({"links", "length", "GJ", "EI", "EA", "GA", "curvature", "root"});
  out.links = chain.at("links", "an integer > 0").integer(1, kMostLinks);
  out.length = chain.at("length", "a number > 0, m").positive();
  out.bending << chain.at("GJ", "a number > 0, N m^2").positive(),
      two_stiffnesses(chain.at("EI", "one or two numbers > 0, N m^2"));
  out.stretching << chain.at("EA", "a number > 0, N").positive(),
      two_stiffnesses(chain.at("GA", "one or two numbers > 0, N"));
  if (const auto curvature = chain.find("curvature"))
    out.curvature = curvature->vector<3>("3 numbers, 1/m: twist, curvature about axes 2 and 3");
  if (const auto root = chain.find("root")) out.root = read_root(*root);
}

void add_load(const Field& load, ChainLoads& out) {
  load.has_only({"type", "value"});
  const NamedLoad read = read_load(load, kChainLoads);
  Vec3<double>* const loads[] = {&out.fixed_force, &out.follower_force, &out.fixed_moment,
                                 &out.follower_moment};
  *loads[read.type] += read.value;
}

ChainScene chain_of(const Field& file, const std::filesystem::path& path) {
  if (const auto joint = file.find("joint"))
    joint->refuse("stands beside [chain]", "one of the two", "named_twice");
  Names keys = kHeadKeys;
  keys.insert(keys.end(), {"chain", "load"});
  file.has_only(keys);
  ChainScene scene;
  read_title(file, path, scene);
  read_chain(file.at("chain", "a table [chain]"), scene);
  for (const Field load : loads_of(file)) add_load(load, scene.loads);
  scene.points = 1;
  if (const auto steps = file.find("path")) {
    steps->has_only({"factor_end", "points"});
    read_path(*steps, scene);
  }
  read_outputs(file, {"x", "y", "z", "theta_x", "theta_y", "theta_z"}, scene);
  read_formulations(
      file, {}, [](const Entry&) { return std::nullopt; }, scene);
  read_references(file, kRod, scene);
  return scene;
}

}  // namespace

AnyScene read_any_scene(const std::filesystem::path& path) {
  AnyScene out;
  read_scene_file(path, [&](const Field& file) -> SceneHead& {
    if (file.find("chain")) return out.emplace<ChainScene>(chain_of(file, path));
    return out.emplace<Scene>(joint_scene(file, path));
  });
  return out;
}

std::vector<ChainScene> chain_scenes() {
  std::vector<ChainScene> out;
  const auto folder = scenes_folder() / "chains";
  if (!std::filesystem::is_directory(folder)) return out;
  for (const auto& path : scene_files(folder)) {
    read_scene_file(path,
                    [&](const Field& file) -> SceneHead& { return out.emplace_back(chain_of(file, path)); });
  }
  return out;
}

}  // namespace halfway::reference
