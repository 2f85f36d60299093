#include "verify/studies/mechanisms/generic.hpp"

#include "reference/numbers/random.hpp"
#include "verify/oracle/probes.hpp"

#include <utility>

namespace halfway::verify {
namespace {

using reference::BodyLoad;
using reference::LoadType;
using reference::MechanismScene;
using reference::Scene;
using reference::SceneLoad;

double smallest_stiffness(const JointSpec& spec) {
  const auto& law = std::get<reference::LinearSpec>(spec.law);
  return law.matrix.bottomRightCorner<3, 3>().diagonal().minCoeff();
}

}  // namespace

Scene generic_scene(const Entry& entry, Kind kind, double angle) {
  Scene out;
  out.name = "generic";
  out.joint = probes(entry, kind, 1, 1).front().spec;
  reference::Generator random(2718);
  const double size = angle * smallest_stiffness(out.joint);  // N m; of linear joints N
  const auto add = [&](LoadType type, bool held) {
    SceneLoad load{type, random.vector(size)};
    if (is_force(type)) load.point = random.vector(0.5);
    load.held = held;
    const Mat3<double> at_rest = out.joint.a.H * out.joint.b.H.transpose();
    load.arm = at_rest.transpose() * load.value.cross(random.direction()).normalized();
    out.loads.push_back(load);
  };
  add(LoadType::fixed_force, true);
  add(LoadType::fixed_force, false);
  add(LoadType::follower_force, false);
  if (kind == Kind::linear) return out;
  for (const LoadType type : {LoadType::fixed_moment, LoadType::follower_moment,
                              LoadType::semi_tangential_moment, LoadType::quasi_tangential_moment})
    add(type, false);
  return out;
}

void exchange_nodes(reference::SceneJoint& joint) {
  std::swap(joint.a, joint.b);
  std::swap(joint.spec.a, joint.spec.b);
  joint.spec.axis = -joint.spec.axis;
}

MechanismScene carried(const MechanismScene& scene, const Vec3<double>& turn, const Vec3<double>& shift) {
  MechanismScene out = scene;
  const Mat3<double> R = so3::exp<double>(turn);
  const auto carry = [&](std::optional<Pose<double>>& pose) {
    if (pose) pose = Pose<double>{shift + R * pose->x, R * pose->R};
  };
  for (std::size_t i = 1; i < out.bodies.size(); ++i) carry(out.bodies[i].pose);
  for (BodyLoad& load : out.loads)
    if (!follows(load.type)) load.value = R * load.value;
  for (auto& joint : out.joints) {  // the ground stays: its joint points move
    for (const bool is_a : {true, false}) {
      auto& end = is_a ? joint.spec.a : joint.spec.b;
      if ((is_a ? joint.a : joint.b) == 0) end = {shift + R * end.o, R * end.H};
    }
  }
  return out;
}

MechanismScene as_mechanism(const Scene& scene, const reference::Setting& setting) {
  MechanismScene out;
  static_cast<reference::SceneHead&>(out) = scene;
  out.bodies = {
      {reference::kGround, Pose<double>{}, std::nullopt}, {"a", Pose<double>{}, std::nullopt}, {"b"}};
  out.bodies[2].moves = scene.joint.kind;
  out.joints.push_back({"joint1", scene.joint, scene.has_length, 1, 2});
  if (setting.nodes_exchanged) exchange_nodes(out.joints.front());
  for (const SceneLoad& load : scene.loads) {
    out.loads.emplace_back();
    static_cast<SceneLoad&>(out.loads.back()) = load;
    out.loads.back().body = 2;
  }
  return carried(out, setting.frame_turn, setting.frame_shift);
}

MechanismScene generic_loop(const Entry& entry, bool dead) {
  MechanismScene out;
  out.name = "loop";
  out.bodies = {{reference::kGround, Pose<double>{}, std::nullopt}, {"first"}, {"second"}};
  const auto kept = probes(entry, Kind::linear_angular, 3, 1);
  out.joints = {{"one", kept[0].spec, true, 0, 1},
                {"two", kept[1].spec, true, 2, 1},
                {"three", kept[2].spec, true, 0, 2}};
  // Where the second body stands neither joint at it is at rest, by a few hundredths.
  reference::Generator random(577);
  const auto rest = reference::initial_poses<double>(out);
  out.bodies[2].pose =
      Pose<double>{rest[2]->x + random.vector(0.02), random.rotation(0.02, 0.03) * rest[2]->R};
  const JointEnd<double> at_body = out.joints[2].spec.b;
  out.joints[2].spec.a.o = out.bodies[2].pose->x + out.bodies[2].pose->R * at_body.o + random.vector(0.02);
  out.joints[2].spec.a.H = random.rotation(0.02, 0.03) * out.bodies[2].pose->R * at_body.H;
  const double size = 0.05 * smallest_stiffness(out.joints[0].spec);
  for (const int body : {1, 2}) {
    for (const LoadType type :
         {LoadType::fixed_force, LoadType::fixed_force, LoadType::follower_force, LoadType::fixed_moment}) {
      if (dead && type != LoadType::fixed_force) continue;
      BodyLoad load;
      load.type = type;
      load.value = random.vector(size);
      if (is_force(type)) load.point = random.vector(0.5);
      load.body = body;
      load.held = out.loads.empty();
      out.loads.push_back(load);
    }
  }
  return out;
}

}  // namespace halfway::verify
