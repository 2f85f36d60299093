#include "reference/scene/mechanism_parts.hpp"

#include "reference/scene/joint/names.hpp"
#include "reference/scene/joint/read_joint.hpp"
#include "reference/scene/joint/read_law.hpp"
#include "reference/scene/joint/read_matrix.hpp"
#include "reference/scene/scene_head.hpp"
#include "reference/scene/time_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halfway::reference {
namespace {

const std::string kNameRule = "letters, digits and _, each name once";

/// Names are parts of the outputs' names.
std::string read_name(const Field& field, const MechanismScene& scene) {
  const std::string name = field.text();
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (!std::ranges::all_of(name, is_letter)) field.refuse("is no name", kNameRule);
  const auto is_it = [&](const auto& other) { return other.name == name; };
  if (name == kGround) field.refuse("is the name of what never moves", kNameRule, "named_twice");
  if (std::ranges::any_of(scene.bodies, is_it) || std::ranges::any_of(scene.joints, is_it) ||
      std::ranges::any_of(scene.motions, is_it))
    field.refuse("is named twice", kNameRule, "named_twice");
  return name;
}

Names body_names(const MechanismScene& scene) {
  Names out;
  for (const SceneBody& body : scene.bodies) out.emplace_back(body.name);
  return out;
}

int body_at(const Field& field, const MechanismScene& scene) {
  const Names names = body_names(scene);
  return int(std::ranges::find(names, field.one_of(names)) - names.begin());
}

SceneBody& named(MechanismScene& scene, const std::string& name) {
  return *std::ranges::find(scene.bodies, name, &SceneBody::name);
}
bool has_body(const MechanismScene& scene, const std::string& name) {
  return std::ranges::find(scene.bodies, name, &SceneBody::name) != scene.bodies.end();
}

Mat3<double> read_inertia(const Field& field) {
  const std::string allowed = "3 numbers > 0 (a diagonal) or 3 rows, positive definite, kg m^2";
  const MatrixDimensions of{dimension::inertia, dimension::inertia};
  const Mat3<double> J = field.holds_arrays()
                             ? Mat3<double>(field.square_matrix(3, allowed, of))
                             : Mat3<double>(field.vector<3>(allowed, dimension::inertia).asDiagonal());
  const double largest = J.cwiseAbs().maxCoeff();
  if (!((J - J.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * largest))
    field.refuse("is not symmetric", allowed);
  if (!(J.llt().info() == Eigen::Success && largest > 0)) field.refuse("is not positive definite", allowed);
  return (J + J.transpose()) / 2;
}

const Names kFree = {"all", "rotation", "displacement", "none"};

SceneBody read_body(const Field& table, const MechanismScene& scene) {
  table.has_only({"name", "x", "h", "clamped", "free", "mass", "center", "inertia", "start"});
  SceneBody out;
  out.name = read_name(table.at("name", kNameRule), scene);
  const auto x = table.find("x"), h = table.find("h");
  if (x || h) out.pose.emplace();
  if (x) out.pose->x = x->vector<3>("3 numbers, m, global axes", dimension::length);
  if (h) out.pose->R = read_rotation(*h);
  if (const auto mass = table.find("mass")) out.mass = mass->positive(dimension::mass);
  if (const auto center = table.find("center"))
    out.center = center->vector<3>("3 numbers, m, axes of the body", dimension::length);
  if (const auto inertia = table.find("inertia")) out.inertia = read_inertia(*inertia);
  return out;
}

/// Those of the body's table, or what the joints at it make of it: held in place by angular joints alone, in
/// orientation by linear ones.
std::optional<Kind> read_moves(const std::optional<Field>& table, const MechanismScene& scene, int body) {
  const auto clamped = table ? table->find("clamped") : std::nullopt;
  const auto free = table ? table->find("free") : std::nullopt;
  if (clamped && free) free->refuse("stands beside clamped", "one of the two");
  if (clamped && clamped->boolean()) return std::nullopt;
  if (free) {
    const std::string word = free->one_of(kFree);
    if (word == "none") return std::nullopt;
    return word == "all" ? Kind::linear_angular : word == "rotation" ? Kind::angular : Kind::linear;
  }
  const bool is_a = scene.bodies[std::size_t(body)].name == "a";
  if (is_a && !clamped) return std::nullopt;
  bool has[3] = {false, false, false};
  for (const SceneJoint& joint : scene.joints) {
    if (joint.a == body || joint.b == body) has[int(joint.spec.kind)] = true;
  }
  const int kinds = has[0] + has[1] + has[2];
  if (kinds != 1) return Kind::linear_angular;
  return has[int(Kind::angular)]  ? Kind::angular
         : has[int(Kind::linear)] ? Kind::linear
                                  : Kind::linear_angular;
}

SceneJoint read_scene_joint(const Field& table, MechanismScene& scene) {
  Names keys = kJointKeys;
  keys.insert(keys.end(), kRodKeys.begin(), kRodKeys.end());
  keys.insert(keys.end(), {"name", "between", "damping"});
  table.has_only(keys);
  for (const char* node : {"a", "b"}) {
    if (const auto end = table.find(node)) end->has_only({"o", "h"});
  }
  SceneJoint out;
  const auto name = table.find("name");
  out.name = name ? read_name(*name, scene) : fmt::format("joint{}", scene.joints.size() + 1);
  out.spec = read_joint(table);
  note_free_strains(table.at("law", ""), out.spec);
  out.has_length = read_rod(table, out.spec);
  if (const auto damping = table.find("damping")) {
    if (!scene.time)
      damping->refuse("stands without a table [time]: it acts on what moves", "damping in a scene in time");
    out.damping = read_damping(*damping, out.spec.kind);
    if (out.damping.isZero(0)) out.damping.resize(0, 0);
  }
  const auto between = table.find("between");
  int* const ends[] = {&out.a, &out.b};
  int i = 0;
  if (between) {
    for (const Field end : between->items("2 names of bodies: of node a and of node b")) {
      if (i < 2) *ends[i] = body_at(end, scene);
      ++i;
    }
    if (i != 2) between->refuse(fmt::format("has {} entries", i), "2 names of bodies", "wrong_shape");
    if (out.a == out.b) between->refuse("is one body twice", "two bodies");
    return out;
  }
  for (const char* body : {"a", "b"}) {
    if (!has_body(scene, body)) scene.bodies.push_back({body});
    *ends[i++] = int(&named(scene, body) - scene.bodies.data());
  }
  return out;
}

/// `body`, or b where there is one.
int body_of(const Field& table, const MechanismScene& scene) {
  const Names names = body_names(scene);
  const auto body = table.find("body");
  if (body) return body_at(*body, scene);
  if (!has_body(scene, "b")) table.at("body", fmt::format("{}", fmt::join(names, ", ")));
  return int(std::ranges::find(names, "b") - names.begin());
}

/// Multipliers at the end of each step, or none: then the load factor.
Factors read_factors(const Field& table, const MechanismScene& scene) {
  const auto field = table.find("factors");
  if (!field) return {};
  if (scene.steps == 0) field->refuse("stands without steps", "steps in the table [path]");
  const std::string allowed = fmt::format("{} numbers, one for each step", scene.steps);
  Factors factors = field->numbers(allowed, dimension::none);
  if (factors.size() != std::size_t(scene.steps))
    field->refuse(fmt::format("has {} entries", factors.size()), allowed, "wrong_shape");
  return factors;
}

/// A value in three components, or of one of them about or along an axis.
void read_motion_value(const Field& table, SceneMotion& motion) {
  const std::string shape = motion.is_rotation ? "3 numbers, rad: a rotation vector; or 1 number beside axis"
                                               : "3 numbers, m; or 1 number beside axis";
  const Dimension& of_value = motion.is_rotation ? dimension::angle : dimension::length;
  const Field value = table.at("value", shape);
  if (const auto axis = table.find("axis")) {
    motion.axis = int(axis->one_of({"x", "y", "z"})[0] - 'x');
    motion.value[motion.axis] = value.number(of_value);
    return;
  }
  motion.value = value.vector<3>(shape, of_value);
}

bool same_direction(const SceneMotion& one, const SceneMotion& other) {
  return one.body == other.body && one.is_rotation == other.is_rotation &&
         (one.is_rotation || one.point == other.point) &&
         (one.axis < 0 || other.axis < 0 || one.axis == other.axis);
}

SceneMotion read_motion(const Field& table, const MechanismScene& scene) {
  table.has_only({"name", "body", "type", "value", "axis", "point", "factors"});
  SceneMotion out;
  const auto name = table.find("name");
  out.name = name ? read_name(*name, scene) : fmt::format("motion{}", scene.motions.size() + 1);
  const auto body = table.find("body");
  out.body = body_of(table, scene);
  const auto& moves = scene.bodies[std::size_t(out.body)].moves;
  if (!moves) body.value_or(table).refuse("is clamped and moves nowhere", "a body that is not clamped");
  const Field type = table.at("type", "rotation, displacement");
  out.is_rotation = type.one_of({"rotation", "displacement"}) == "rotation";
  if (*moves == (out.is_rotation ? Kind::linear : Kind::angular))
    type.refuse(fmt::format("is of body {}, which has {} alone", scene.bodies[std::size_t(out.body)].name,
                            out.is_rotation ? "displacements" : "rotations"),
                out.is_rotation ? "displacement, or free = \"all\" of the body"
                                : "rotation, or free = \"all\" of the body");
  if (const auto point = table.find("point")) {
    if (out.is_rotation) point->refuse("is a point of a rotation", "point beside displacement only");
    out.point = point->vector<3>("3 numbers, m, axes of the body", dimension::length);
  }
  read_motion_value(table, out);
  out.factors = read_factors(table, scene);
  for (const SceneMotion& other : scene.motions) {
    if (same_direction(out, other))
      type.refuse(fmt::format("prescribes what {} prescribes", other.name), "each direction once",
                  "named_twice");
  }
  return out;
}

BodyLoad read_body_load(const Field& table, const MechanismScene& scene,
                        const std::vector<std::optional<Pose<double>>>& poses) {
  Names keys = kLoadKeys;
  keys.insert(keys.end(), {"body", "factors"});
  if (scene.time) keys.emplace_back("times");
  table.has_only(keys);
  const auto body = table.find("body");
  const int at = body_of(table, scene);
  const auto& moves = scene.bodies[std::size_t(at)].moves;
  if (!moves)
    body.value_or(table).refuse("is clamped: a load on it does nothing", "a body that is not clamped");
  BodyLoad out;
  static_cast<SceneLoad&>(out) = read_scene_load(table, *moves, poses[std::size_t(at)]->R);
  out.body = at;
  if (scene.time)
    read_times(table, scene, out);
  else
    out.factors = read_factors(table, scene);
  if (out.held && !out.factors.empty())
    table.find("factors")->refuse("stands beside held = true", "one of the two");
  return out;
}

}  // namespace

Field body_field(const Field& file, const std::string& name) {
  if (const auto bodies = file.find("body")) {
    for (const Field body : bodies->items()) {
      if (const auto field = body.find("name"); field && field->says(name)) return body;
    }
  }
  return file;
}

void read_bodies_and_joints(const Field& file, MechanismScene& scene) {
  scene.bodies.push_back({kGround, Pose<double>{}, std::nullopt});
  if (const auto bodies = file.find("body")) {
    for (const Field body : bodies->items("tables [[body]]")) scene.bodies.push_back(read_body(body, scene));
  }
  if (const auto joints = file.find("joint")) {
    if (!joints->is_array()) {
      scene.joints.push_back(read_scene_joint(*joints, scene));
    } else {
      for (const Field joint : joints->items()) scene.joints.push_back(read_scene_joint(joint, scene));
    }
  }
  if (scene.joints.empty())
    file.at("joint", "at least one table [[joint]]").refuse("is empty", "at least one table [[joint]]");
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    SceneBody& body = scene.bodies[i];
    const Field table = body_field(file, body.name);
    const bool is_listed = table.find("name").has_value();
    body.moves = read_moves(is_listed ? std::optional(table) : std::nullopt, scene, int(i));
    if (const auto start = is_listed ? table.find("start") : std::nullopt)
      body.start = read_start(*start, scene, body);
    if (!body.moves && !body.pose) body.pose.emplace();
  }
}

void read_motions(const Field& file, MechanismScene& scene) {
  const auto motions = file.find("motion");
  if (!motions) return;
  for (const Field motion : motions->items("tables [[motion]]"))
    scene.motions.push_back(read_motion(motion, scene));
}

void read_body_loads(const Field& file, MechanismScene& scene) {
  if (!file.find("load") && (scene.time || !scene.motions.empty())) return;
  const auto poses = initial_poses<double>(scene);
  for (const Field load : loads_of(file)) scene.loads.push_back(read_body_load(load, scene, poses));
}

}  // namespace halfway::reference
