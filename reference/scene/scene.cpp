#include "reference/scene/scene.hpp"

#include "reference/scene/joint/names.hpp"
#include "reference/scene/joint/read_joint.hpp"
#include "reference/scene/joint/read_law.hpp"
#include "reference/scene/read_mechanism.hpp"
#include "reference/scene/scene_head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace halfway::reference {
namespace {

constexpr const char* kLoadTypes[] = {"fixed_moment",   "follower_moment",        "fixed_force",
                                      "follower_force", "semi_tangential_moment", "quasi_tangential_moment"};

/// Of the pair of forces: across their moment while nothing is strained.
void read_arm(const Field& load, const Mat3<double>& R, SceneLoad& out) {
  constexpr const char* kArm = "3 numbers, axes of node b: the direction of the arm, across the moment";
  const auto arm = load.find("arm");
  if (out.type != LoadType::quasi_tangential_moment) {
    if (arm) arm->refuse("is an arm of another load", "arm beside quasi_tangential_moment only");
    return;
  }
  const Field field = load.at("arm", kArm);
  out.arm = field.vector<3>(kArm);
  const double length = out.arm.norm();
  if (!(length > 0)) field.refuse("has no direction", kArm);
  out.arm /= length;
  if (!(std::abs(out.value.dot(R * out.arm)) <= 1e-9 * out.value.norm()))
    field.refuse("is not across the moment while the joint is unstrained", kArm);
}

}  // namespace

SceneLoad read_scene_load(const Field& load, Kind kind, const Mat3<double>& R) {
  const NamedLoad read = read_load(load, Names(std::begin(kLoadTypes), std::end(kLoadTypes)));
  SceneLoad out{LoadType(read.type), read.value};
  if (kind == Kind::linear && !is_force(out.type)) {
    load.find("type")->refuse(
        "loads a node that does not turn: its joint resists no rotation (kind = \"linear\")",
        "fixed_force, follower_force");
  }
  if (const auto point = load.find("point")) {
    if (!is_force(out.type))
      point->refuse("is a point of a moment", "point beside fixed_force, follower_force only");
    out.point = point->vector<3>("3 numbers, m, axes of node b", dimension::length);
  }
  read_arm(load, R, out);
  if (const auto held = load.find("held")) out.held = held->boolean();
  return out;
}

namespace {

std::vector<std::string> outputs_of(Kind kind) {
  const std::vector<std::string> rotations = {"theta_x", "theta_y", "theta_z"};
  const std::vector<std::string> displacements = {"u_x", "u_y", "u_z"};
  if (kind == Kind::angular) return rotations;
  if (kind == Kind::linear) return displacements;
  std::vector<std::string> all = rotations;
  all.insert(all.end(), displacements.begin(), displacements.end());
  return all;
}

/// rad at rest: rounding of a curve between points beside zero.
constexpr double kNothing = 1e-12;

/// Is there a moment about the axis alone wherever the joint turns about it alone?
bool is_principal(const LawSpec& law, int axis) {
  const auto at_rest = AnyLaw<double, 3>(law)(Vec3<double>::Zero());
  for (int i = 0; i < 3; ++i) {
    // Only a linear law couples axes; only a preload, or a curve not through zero, leaves a moment at rest.
    const bool is_strained = std::abs(at_rest.stress[i]) > kNothing * at_rest.stiffness(i, i);
    if (i != axis && (at_rest.stiffness(i, axis) != 0 || is_strained)) return false;
  }
  return true;
}

void read_joint_path(const Field& path, Scene& scene) {
  path.has_only({"factor_end", "points", "critical_axis"});
  read_path(path, scene);
  if (const auto axis = path.find("critical_axis")) {
    if (scene.joint.kind != Kind::angular)
      axis->refuse("is asked of a joint that is not angular", "angular joints");
    scene.critical_axis = axis->integer(1, 3);
    if (!is_principal(scene.joint.law, scene.critical_axis - 1))
      axis->refuse(
          "is no principal axis of the law: a turn about it needs moments about the others",
          "a joint axis whose row of the law has its diagonal entry alone, without preload of the others");
  }
}

std::optional<Unfit> unfit(const Entry& entry, const Scene& scene) {
  if (entry.needs_length && !scene.has_length)
    return Unfit{"needs the length of its rod", "joint.length beside it"};
  const LawRefusal* refusal = law_refusal(entry, scene.joint);
  if (refusal == nullptr) return std::nullopt;
  return Unfit{refusal->what, fmt::format("{}, or other formulations", refusal->allowed)};
}

void read_wanted(const Field& file, Scene& scene) {
  read_outputs(file, outputs_of(scene.joint.kind), scene);
  read_formulations(
      file, {kLinearized}, [&](const Entry& entry) { return unfit(entry, scene); }, scene);
  if (!scene.xis.empty()) scene.joint.xi = scene.xis.front();
}

Names keys_of_joint() {
  Names keys = kJointKeys;
  keys.insert(keys.end(), kRodKeys.begin(), kRodKeys.end());
  return keys;
}

}  // namespace

Scene joint_scene(const Field& file, const std::filesystem::path& path) {
  if (const auto chain = file.find("chain"))
    chain->refuse("is a chain where a joint is asked for", "a table [joint]");
  if (is_mechanism(file)) file.refuse("is a mechanism where one joint is asked for", "one table [joint]");
  Names keys = kHeadKeys;
  keys.insert(keys.end(), {"joint", "load"});
  file.has_only(keys);
  Scene scene;
  read_title(file, path, scene);
  const Field joint = file.at("joint", "a table [joint]");
  joint.has_only(keys_of_joint());
  for (const char* node : {"a", "b"}) {
    if (const auto end = joint.find(node)) end->has_only({"o", "h"});
  }
  scene.joint = read_joint(joint);
  scene.has_length = read_rod(joint, scene.joint);
  note_free_strains(joint.at("law", ""), scene.joint);
  const Mat3<double> at_rest = scene.joint.a.H * scene.joint.b.H.transpose();
  for (const Field load : loads_of(file)) {
    load.has_only(kLoadKeys);
    scene.loads.push_back(read_scene_load(load, scene.joint.kind, at_rest));
  }
  read_joint_path(file.at("path", "a table [path]"), scene);
  read_wanted(file, scene);
  read_references(file, {}, scene);
  return scene;
}

const char* to_string(LoadType type) { return kLoadTypes[std::size_t(type)]; }

std::string_view unit_of_output(std::string_view output) {
  const std::string_view name = output.substr(output.rfind('.') + 1);
  constexpr std::pair<std::string_view, std::string_view> kUnits[] = {{"theta_", "rad"},
                                                                      {"u_", "m"},
                                                                      {"x", "m"},
                                                                      {"y", "m"},
                                                                      {"z", "m"},
                                                                      {"f_", "N"},
                                                                      {"m_", "N m"},
                                                                      {"v_", "m/s"},
                                                                      {"w_", "rad/s"},
                                                                      {"p_", "kg m/s"},
                                                                      {"L_", "kg m^2/s"},
                                                                      {"energy", "J"},
                                                                      {"kinetic", "J"},
                                                                      {"dissipated", "J"},
                                                                      {"work", "J"},
                                                                      {"balance", "J"},
                                                                      {"power", "W"},
                                                                      {"growth", "1/s"},
                                                                      {"strain_", ""},
                                                                      {"frequency_", "Hz"},
                                                                      {"eigenvalue_", ""},
                                                                      {"critical_moment", "N m"},
                                                                      {"critical_angle", "rad"}};
  for (const auto& [start, unit] : kUnits) {
    if (name.starts_with(start)) return unit;
  }
  return "";
}

bool is_critical(const std::string& output) {
  return output == "critical_factor" || output == "critical_moment" || output == "critical_angle";
}

Scene read_scene(const std::filesystem::path& path) {
  Scene out;
  read_scene_file(path, [&](const Field& file) -> SceneHead& { return out = joint_scene(file, path); });
  return out;
}

std::filesystem::path scenes_folder() {
  const char* folder = std::getenv("HALFWAY_SCENES");
  return folder && *folder ? folder : HALFWAY_SCENES_DIR;
}

std::vector<Scene> canonical_scenes() { return scenes_in(scenes_folder()); }

std::vector<Scene> scenes_in(const std::filesystem::path& folder) {
  std::vector<Scene> scenes;
  for (const auto& file : scene_files(folder)) scenes.push_back(read_scene(file));
  return scenes;
}

}  // namespace halfway::reference
