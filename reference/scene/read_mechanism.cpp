#include "reference/scene/read_mechanism.hpp"

#include "reference/scene/joint/names.hpp"
#include "reference/scene/mechanism_parts.hpp"
#include "reference/scene/scene_head.hpp"
#include "reference/scene/time_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halfway::reference {
namespace {

constexpr int kMostSteps = 1000;

/// Beyond, dense matrices take minutes.
constexpr int kMostBodies = 60;

void read_steps(const Field& path, MechanismScene& scene) {
  path.has_only({"factor_end", "points", "steps", "critical"});
  if (const auto steps = path.find("steps")) {
    if (const auto end = path.find("factor_end"))
      end->refuse("stands beside steps", "one of the two: the load factor counts the steps");
    scene.steps = steps->integer(1, kMostSteps);
    scene.factor_end = scene.steps;
    scene.points = 10 * scene.steps;
    if (const auto points = path.find("points")) scene.points = points->integer(1, 100000);
  } else {
    read_path(path, scene);
  }
  if (const auto critical = path.find("critical")) scene.asks_critical = critical->boolean();
}

/// A body that is held by nothing is no matter of a scene: it would float.
void check_held(const Field& file, const MechanismScene& scene) {
  const auto poses = initial_poses<double>(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto touches = [&](const SceneJoint& joint) { return joint.a == int(i) || joint.b == int(i); };
    const bool is_moved = std::ranges::any_of(scene.motions, [&](auto& m) { return m.body == int(i); });
    const SceneBody& body = scene.bodies[i];
    const bool has_joint = std::ranges::any_of(scene.joints, touches);
    if (!has_joint && body.moves && !is_moved && !scene.time)
      body_field(file, body.name).refuse("is held by nothing", "a body with a joint, a motion or clamped");
    if (!poses[i])
      body_field(file, body.name)
          .refuse("stands nowhere: no joint leads to it from a clamped body", "x and h, where it is at rest");
  }
}

std::vector<std::string> numbered(std::string_view word, int count) {
  std::vector<std::string> out;
  for (int i = 1; i <= count; ++i) out.push_back(fmt::format("{}_{}", word, i));
  return out;
}

void append(std::vector<std::string>& to, std::string_view prefix, const std::vector<std::string>& names) {
  for (const std::string& name : names) to.push_back(std::string(prefix) + name);
}

const std::vector<std::string> kLoadNames = {"f_x", "f_y", "f_z", "m_x", "m_y", "m_z"};

std::vector<std::string> motion_names(Kind kind) {
  std::vector<std::string> out;
  if (kind != Kind::linear) out = {"theta_x", "theta_y", "theta_z"};
  if (kind != Kind::angular) append(out, "u_", {"x", "y", "z"});
  return out;
}

/// What moves, the columns where a file names none: without a body's name where it is b alone.
std::vector<std::string> default_outputs(const MechanismScene& scene) {
  std::vector<std::string> out;
  const auto free = [](const SceneBody& body) { return body.moves.has_value(); };
  const bool is_b = std::ranges::count_if(scene.bodies, free) == 1;
  for (const SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    append(out, is_b && body.name == "b" ? "" : body.name + ".", motion_names(*body.moves));
  }
  if (scene.time) append(out, "", {"kinetic", "energy", "dissipated", "work", "balance"});
  return out;
}

std::vector<std::string> rate_names(Kind kind) {
  std::vector<std::string> out;
  if (kind != Kind::linear) append(out, "w_", {"x", "y", "z"});
  if (kind != Kind::angular) append(out, "v_", {"x", "y", "z"});
  return out;
}

std::vector<std::string> all_outputs(const MechanismScene& scene) {
  std::vector<std::string> out;
  for (const SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    std::vector<std::string> names = motion_names(*body.moves);
    if (scene.time) append(names, "", rate_names(*body.moves));
    if (body.name == "b") append(out, "", names);
    append(out, body.name + ".", names);
  }
  for (const SceneJoint& joint : scene.joints) {
    append(out, joint.name + ".a.", kLoadNames);
    append(out, joint.name + ".b.", kLoadNames);
    append(out, joint.name + ".", numbered("strain", strain_count(joint.spec.kind)));
    out.push_back(joint.name + ".energy");
    if (scene.time) out.push_back(joint.name + ".power");
  }
  for (const SceneMotion& motion : scene.motions) append(out, motion.name + ".", kLoadNames);
  out.push_back("energy");
  if (scene.time) {
    append(out, "", {"kinetic", "dissipated", "work", "balance"});
    for (const char* of : {"p_", "L_"}) append(out, of, {"x", "y", "z"});
    return out;
  }
  const int free = unknown_count(scene) - prescribed_count(scene);
  append(out, "", numbered("eigenvalue", free));
  append(out, "", numbered("frequency", free));
  out.push_back("growth");
  return out;
}

/// Masses, where something is asked that needs them.
void check_masses(const Field& file, const MechanismScene& scene) {
  const auto needs_masses = [](const std::string& name) {
    return name == "growth" || name.starts_with("frequency_");
  };
  if (std::ranges::none_of(scene.outputs, needs_masses)) return;
  for (const SceneBody& body : scene.bodies) {
    if (!lacks_mass(body)) continue;
    file.find("outputs")->refuse(
        fmt::format("asks for motion, and body {} has no mass", body.name),
        fmt::format("mass, kg, and inertia, kg m^2, in the table [[body]] of {}", body.name));
  }
}

std::optional<Unfit> unfit(const Entry& entry, const MechanismScene& scene) {
  if (const std::string why = mechanism_objection(entry, scene); !why.empty())
    return Unfit{why, "other formulations"};
  return std::nullopt;
}

}  // namespace

bool is_mechanism(const Field& file) {
  const auto joint = file.find("joint");
  if ((joint && joint->is_array()) || file.find("body") || file.find("motion") || file.find("time"))
    return true;
  if (const auto path = file.find("path"); path && (path->find("steps") || path->find("critical")))
    return true;
  if (const auto loads = file.find("load"); loads && loads->is_array()) {
    for (const Field load : loads->items()) {
      if (load.find("body") || load.find("factors")) return true;
    }
  }
  const auto outputs = file.find("outputs");
  if (!joint || !outputs || !outputs->is_array()) return false;
  const Names words = {"energy", "growth"}, starts = {"frequency_", "eigenvalue_", "strain_"};
  for (const Field output : outputs->items()) {
    if (!output.is_text()) continue;
    const std::string name = output.text();
    if (std::ranges::find(words, name) != words.end() || name.find('.') != std::string::npos) return true;
    if (std::ranges::any_of(starts, [&](std::string_view s) { return name.starts_with(s); })) return true;
  }
  return false;
}

std::string mechanism_objection(const Entry& entry, const MechanismScene& scene) {
  for (const SceneJoint& joint : scene.joints) {
    if (entry.needs_length && !joint.has_length)
      return fmt::format("needs the length of the rod of joint {}", joint.name);
    if (const char* why = law_refused(entry, joint.spec))
      return fmt::format("{} (joint {})", why, joint.name);
  }
  return "";
}

int unknown_count(const MechanismScene& scene) {
  int out = 0;
  for (const SceneBody& body : scene.bodies) out += body.moves ? halfway::unknown_count(*body.moves) : 0;
  return out;
}

int prescribed_count(const MechanismScene& scene) {
  int out = 0;
  for (const SceneMotion& motion : scene.motions) out += motion.axis < 0 ? 3 : 1;
  return out;
}

MechanismScene mechanism_scene(const Field& file, const std::filesystem::path& path) {
  Names keys = kHeadKeys;
  keys.insert(keys.end(), {"joint", "load", "body", "motion", "time"});
  file.has_only(keys);
  MechanismScene scene;
  read_title(file, path, scene);
  read_time(file, scene);
  read_bodies_and_joints(file, scene);
  if (scene.bodies.size() > kMostBodies + 1)
    file.find("body")->refuse(fmt::format("has {} bodies", scene.bodies.size() - 1),
                              fmt::format("{} at most", kMostBodies));
  if (!scene.time) read_steps(file.at("path", "a table [path], or [time]"), scene);
  read_motions(file, scene);
  check_held(file, scene);
  read_body_loads(file, scene);
  scene.outputs = default_outputs(scene);
  if (file.find("outputs")) read_outputs(file, all_outputs(scene), scene);
  check_masses(file, scene);
  check_time(file, scene);
  read_formulations(
      file, {}, [&](const Entry& entry) { return unfit(entry, scene); }, scene);
  read_references(file, {}, scene);
  return scene;
}

}  // namespace halfway::reference
