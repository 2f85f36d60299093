// MuJoCo's ways to make a bushing: a chain of slides and hinges, a ball joint, a soft weld, the spring of a
// free joint. Loads are mass times acceleration of forward dynamics at rest: no step is made.
#include "verify/programs/adapter.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace halfway::programs {
namespace {

std::string written(std::initializer_list<double> numbers) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (double number : numbers) text << number << ' ';
  return text.str();
}
std::string written(const Vec& v) { return written({v[0], v[1], v[2]}); }
std::string written(const Quat& q) { return written({q[0], q[1], q[2], q[3]}); }

/// One attribute, as in XML.
template <class Value>
std::string attribute(const char* key, const Value& value) {
  return std::string(" ") + key + "='" + value + "'";
}

std::string place(const Body& body) {
  return attribute("pos", written(body.x)) + attribute("quat", written(body.q));
}

std::string inertial(const Body& body) {
  return "<inertial pos='0 0 0'" + attribute("mass", written({body.mass})) +
         attribute("diaginertia", written({body.inertia, body.inertia, body.inertia})) + "/>";
}

/// b in the axes of a, unstrained.
Body rest_in_a(const Joint& joint) {
  Joint moved = joint;
  moved.a.x = {};
  moved.a.q = {1, 0, 0, 0};
  return at_rest(moved);
}

/// Model and state of one request.
class Simulation {
 public:
  explicit Simulation(const std::string& inside) {
    const std::string xml =
        "<mujoco><compiler angle='radian'/><option gravity='0 0 0' solver='Newton' iterations='200' "
        "tolerance='0'/>" +
        inside + "</mujoco>";
    // A file in memory: MuJoCo reads files alone. Its table of them is megabytes: not for the stack.
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    if (mj_makeEmptyFileVFS(files.get(), kFile, int(xml.size())) != 0)
      throw std::runtime_error("MuJoCo takes no file in memory");
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), kFile)], xml.data(), xml.size());
    std::array<char, 1000> why{};
    model_.reset(mj_loadXML(kFile, files.get(), why.data(), int(why.size())));
    mj_deleteVFS(files.get());
    if (!model_) throw std::runtime_error(std::string("MuJoCo refuses the model: ") + why.data());
    data_.reset(mj_makeData(model_.get()));
  }

  /// Coordinates of a free joint, from the i-th on; of a ball or a hinge the same without the place.
  void set(int i, const Body& body) {
    std::copy(body.x.begin(), body.x.end(), data_->qpos + i);
    set(i + 3, body.q);
  }
  template <std::size_t N>
  void set(int i, const std::array<double, N>& numbers) {
    std::copy(numbers.begin(), numbers.end(), data_->qpos + i);
  }

  void forward() { mj_forward(model_.get(), data_.get()); }

  /// Nothing moves, so accelerations are the Jacobian times those of the coordinates.
  std::pair<Vec, Vec> on(const char* name, const Body& body) const {
    const auto nv = std::size_t(model_->nv);
    std::vector<double> linear(3 * nv), angular(3 * nv);
    mj_jacBody(model_.get(), data_.get(), linear.data(), angular.data(),
               mj_name2id(model_.get(), mjOBJ_BODY, name));
    Vec f, m;
    mju_mulMatVec(f.data(), linear.data(), data_->qacc, 3, int(nv));
    mju_mulMatVec(m.data(), angular.data(), data_->qacc, 3, int(nv));
    return {times(body.mass, f), times(body.inertia, m)};
  }

  Loads loads(const Joint& joint) const {
    const auto [f_a, m_a] = on("a", joint.a);
    const auto [f_b, m_b] = on("b", joint.b);
    return {f_a, m_a, f_b, m_b};
  }

 private:
  static constexpr const char* kFile = "joint.xml";
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
};

/// Body b hangs on body a, which is free, by the joints given.
Simulation hanging(const Joint& joint, const std::string& joints) {
  Simulation simulation("<worldbody><body name='a'><freejoint/>" + inertial(joint.a) + "<body name='b'" +
                        place(rest_in_a(joint)) + ">" + joints + inertial(joint.b) +
                        "</body></body></worldbody>");
  simulation.set(0, joint.a);
  return simulation;
}

/// Angles of R = Rx(e1) Ry(e2) Rz(e3): those of three hinges, one after the other.
Vec hinge_angles(const Quat& q) {
  const Vec x = rotated(q, {1, 0, 0}), y = rotated(q, {0, 1, 0}), z = rotated(q, {0, 0, 1});
  return {std::atan2(-z[1], z[2]), std::atan2(z[0], std::hypot(x[0], y[0])), std::atan2(-y[0], x[0])};
}

/// Three slides and three hinges along the axes of the joint frame: the usual way.
Loads chain(const Joint& joint) {
  std::string joints;
  for (const char* type : {"slide", "hinge"}) {
    const Vec& k = type[0] == 's' ? joint.k_trans : joint.k_rot;
    for (std::size_t i = 0; i < 3; ++i) {
      Vec axis{};
      axis[i] = 1;
      joints += "<joint" + attribute("type", type) + attribute("pos", written(joint.b.o)) +
                attribute("axis", written(rotated(joint.b.h, axis))) +
                attribute("stiffness", written({k[i]})) + "/>";
    }
  }
  Simulation simulation = hanging(joint, joints);
  const Quat to_a = inverse(joint_frame(joint.a));
  simulation.set(7, rotated(to_a, plus(joint_point(joint.b), times(-1, joint_point(joint.a)))));
  simulation.set(10, hinge_angles(product(to_a, joint_frame(joint.b))));
  simulation.forward();
  return simulation.loads(joint);
}

/// The pin is put at both centres of mass, where it carries nothing: what moves the bodies is the spring
/// alone.
Loads ball(Joint joint) {
  joint.a.o = joint.b.o = {};
  Simulation simulation =
      hanging(joint, "<joint type='ball'" + attribute("stiffness", written({joint.k_rot[0]})) + "/>");
  simulation.set(7, product(inverse(at_rest(joint).q), joint.b.q));
  simulation.forward();
  return simulation.loads(joint);
}

/// The world is body a: no load on it is defined. One stiffness serves rotation and translation.
Loads free_joint(const Joint& joint) {
  if (joint.b.o != Vec{})
    throw Skipped("the spring of MuJoCo's free joint works at the origin of b: b.o has to be 0");
  if (joint.k_trans != joint.k_rot)
    throw Skipped("MuJoCo's free joint has one number for forces and moments");
  Simulation simulation("<worldbody><body name='b'" + place(rest_in_a(joint)) + "><joint type='free'" +
                        attribute("stiffness", written({joint.k_rot[0]})) + "/>" + inertial(joint.b) +
                        "</body></worldbody>");
  const Quat to_a = inverse(joint.a.q);
  Body b = joint.b;
  b.x = rotated(to_a, plus(joint.b.x, times(-1, joint.a.x)));
  b.q = product(to_a, joint.b.q);
  simulation.set(0, b);
  simulation.forward();
  const auto [f, m] = simulation.on("b", joint.b);
  return {.f_b = rotated(joint.a.q, f), .m_b = rotated(joint.a.q, m)};
}

Loads weld_with(const Joint& joint, double impedance) {
  // Two numbers of MuJoCo for two of the law: the stiffness of all rows, and a factor for those of rotation.
  const double scale = joint.k_rot[0] / joint.k_trans[0];
  Simulation simulation("<worldbody><body name='a'><freejoint/>" + inertial(joint.a) +
                        "</body><body name='b'" + place(rest_in_a(joint)) + "><freejoint/>" +
                        inertial(joint.b) + "</body></worldbody><equality><weld body1='a' body2='b'" +
                        attribute("anchor", written(joint.b.o)) + attribute("torquescale", written({scale})) +
                        attribute("solref", written({-joint.k_trans[0], -0.0})) +
                        attribute("solimp", written({impedance, impedance, 1, .5, 2})) + "/></equality>");
  simulation.set(0, joint.a);
  simulation.set(7, joint.b);
  simulation.forward();
  return simulation.loads(joint);
}

Loads weld(const Joint& joint) {
  if (!(joint.k_trans[0] > 0)) throw Skipped("a weld has a translation: its stiffness has to be positive");
  if (joint.k_rot[0] > 15 * joint.k_trans[0]) {
    throw Skipped(
        "the least impedance of MuJoCo's constraints would be seen: rotations stiffer than 15 m2 of "
        "translations");
  }
  // A constraint has an impedance of 1e-4 or above; a spring has none.
  return at_zero({1e-4, 1.5e-4, 2e-4, 3e-4, 4e-4},
                 [&](double impedance) { return weld_with(joint, impedance); });
}

Case mujoco(const char* id, const char* name, std::vector<std::string> kinds, Springs springs, int digits,
            bool frames, std::function<Loads(const Joint&)> loads) {
  return {.id = id,
          .name = name,
          .version = mj_versionString(),
          .kinds = std::move(kinds),
          .trans = springs,
          .rot = springs,
          .digits = digits,
          .frames = frames,
          .loads = std::move(loads)};
}

}  // namespace
}  // namespace halfway::programs

int main(int argc, char** argv) {
  using namespace halfway::programs;
  // Answers alone go to stdout, and no file of warnings is left.
  mju_user_warning = [](const char* text) { std::cerr << text << "\n"; };
  mju_user_error = [](const char* text) {
    std::cerr << text << "\n";
    std::exit(1);
  };
  return run(argc, argv,
             {mujoco("mujoco_chain", "MuJoCo three slides and three hinges", kAllKinds, Springs::diagonal, 12,
                     true, chain),
              mujoco("mujoco_ball", "MuJoCo ball joint", {"angular"}, Springs::isotropic, 12, true, ball),
              mujoco("mujoco_weld", "MuJoCo weld, soft by solref", {"linear", "linear_angular"},
                     Springs::isotropic, 9, true, weld),
              mujoco("mujoco_free", "MuJoCo free joint's spring to the world", {"linear_angular"},
                     Springs::isotropic, 12, false, free_joint)});
}
