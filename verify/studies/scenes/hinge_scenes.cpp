#include "verify/studies/scenes/hinge_scenes.hpp"

#include "reference/face/instantiations.hpp"
#include "reference/numbers/random.hpp"
#include "reference/numbers/zeros.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

namespace halfway::verify {
namespace {

using reference::Generator;
using reference::LoadType;
using reference::Real50;

constexpr double kSoft = 10;  // N m/rad
constexpr double kLevers[] = {0.01, 0.1, 1};
constexpr int kLeastDecade = 4, kMostDecade = 16;

/// fn(scene, ratio, lever) for each of the sweep, six outputs asked for, whole load in one step.
template <class Fill>
std::vector<HingeScene> sweep(Fill&& fill) {
  std::vector<HingeScene> out;
  for (int decade = kLeastDecade; decade <= kMostDecade; decade += 2) {
    for (const double lever : kLevers) {
      HingeScene hinge;
      reference::Scene& s = hinge.scene;
      s.name = "hinge";
      s.joint.kind = Kind::linear_angular;
      s.points = 1;
      s.outputs = {"theta_x", "theta_y", "theta_z", "u_x", "u_y", "u_z"};
      hinge.where = fmt::format("kt l^2/ks = 1e{}, l = {} m", decade, lever);
      fill(hinge, std::pow(10., decade), lever, int(out.size()));
      out.push_back(std::move(hinge));
    }
  }
  return out;
}

/// kt l^2 = ratio ks; the two other rotations are as stiff beside the hinge.
Eigen::Matrix<double, 6, 1> stiffnesses(double ratio, double lever) {
  const double kt = ratio * kSoft / (lever * lever), kr = ratio * kSoft;
  return {kt, kt, kt, kSoft, kr, kr};
}

/// Symmetric, the unit diagonal included, positive definite: no row sums to 1 beside its diagonal.
Eigen::MatrixXd coupling(Generator& random, bool block_diagonal) {
  Eigen::MatrixXd C = Eigen::MatrixXd::Identity(6, 6);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < i; ++j) C(i, j) = C(j, i) = random.uniform(-0.15, 0.15);
  }
  if (block_diagonal) C.topRightCorner(3, 3).setZero(), C.bottomLeftCorner(3, 3).setZero();
  return C;
}

template <class M>
void nudge(M& m, Generator& random) {
  for (double& x : m.reshaped()) {
    if (x == 0) continue;
    const double to = random.uniform(-1, 1) * std::numeric_limits<double>::infinity();
    x = std::nextafter(x, to);
  }
}

/// Every number moved to a neighbour; frames stay rotations, the law symmetric.
reference::Scene nudged(const reference::Scene& scene, Generator& random) {
  reference::Scene out = scene;
  auto& law = std::get<reference::LinearSpec>(out.joint.law).matrix;
  nudge(law, random);
  law = Eigen::MatrixXd(law.selfadjointView<Eigen::Lower>());
  for (auto* end : {&out.joint.a, &out.joint.b}) nudge(end->o, random), nudge(end->H, random);
  for (auto& load : out.loads) nudge(load.value, random), nudge(load.point, random);
  return out;
}

/// The moment about the hinge over ks, of a rotation by t about it alone.
using Measure = std::function<Real50(const Real50&)>;

Measure measure_of(std::string_view formulation) {
  constexpr std::string_view kRotationVector[] = {"attached_a", "attached_b",  "invariant", "intrinsic",
                                                  "potential",  "field_a",     "field_b",   "simbody_xyz",
                                                  "drake_rpy",  "chrono_body", "rod4"};
  for (const auto name : kRotationVector)
    if (formulation == name) return [](const Real50& t) { return t; };
  // Of the others the strain e(t) and de/dt: the moment is their product.
  if (formulation == "jointc") return [](const Real50& t) { return sin(t) * cos(t); };
  if (formulation == "quaternion" || formulation == "fasse") return [](const Real50& t) { return sin(t); };
  if (formulation == "cayley")
    return [](const Real50& t) {
      const Real50 half = tan(t / Real50(2));
      return Real50(2) * half * (Real50(1) + half * half);
    };
  if (formulation == "conformal")
    return [](const Real50& t) {
      const Real50 quarter = tan(t / Real50(4));
      return Real50(4) * quarter * (Real50(1) + quarter * quarter);
    };
  return {};
}

}  // namespace

std::vector<HingeScene> planar_hinges() {
  return sweep([](HingeScene& hinge, double ratio, double lever, int index) {
    const double turn = index % 2 == 0 ? 0.005 : 0.3;  // rad, about
    const Eigen::MatrixXd K = stiffnesses(ratio, lever).asDiagonal();
    hinge.scene.joint.law = reference::LinearSpec{K, false};
    hinge.scene.joint.b.o = {0, -lever, 0};
    hinge.scene.loads = {{LoadType::fixed_force, Vec3<double>(0, 0.4, 0.6) * (kSoft * turn / lever)},
                         {LoadType::fixed_moment, {0.4 * kSoft * turn, 0, 0}}};
  });
}

std::vector<HingeScene> generic_hinges(bool block_diagonal) {
  Generator random(20262);
  return sweep([&](HingeScene& hinge, double ratio, double lever, int index) {
    reference::JointSpec& joint = hinge.scene.joint;
    const Eigen::VectorXd root = stiffnesses(ratio, lever).cwiseSqrt();
    const Eigen::MatrixXd K = root.asDiagonal() * coupling(random, block_diagonal) * root.asDiagonal();
    joint.law = reference::LinearSpec{(K + K.transpose()) / 2, false};
    for (auto* end : {&joint.a, &joint.b}) {
      end->H = random.rotation(0, 3);
      end->o = lever * random.direction();
    }
    const double moment = 0.15 * kSoft;
    hinge.scene.loads = {{LoadType::fixed_force, moment / lever * random.direction()},
                         {LoadType::fixed_moment, moment * random.direction()}};
    hinge.scene.loads.front().point = lever * random.vector(0.5);
    hinge.setting.nodes_exchanged = index % 2 == 1;
    hinge.setting.frame_turn = random.vector(1);
    hinge.setting.frame_shift = random.vector(2);
    hinge.where += fmt::format(", scene {}", index);
  });
}

std::optional<Real50> planar_root(const reference::Scene& scene, std::string_view formulation) {
  const Measure g = measure_of(formulation);
  if (!g) return std::nullopt;
  const Vec3<Real50> force = scene.loads[0].value.cast<Real50>();
  const Real50 ks(kSoft), moment(scene.loads[1].value[0]), lever(-scene.joint.b.o[1]);
  const auto below = [&](const Real50& t) {
    return ks * g(t) < moment + lever * (force[2] * cos(t) - force[1] * sin(t));
  };
  return last_where(below, Real50(0), Real50(0.7), 180);  // g rises up to pi/4 for each of them
}

double floor_of(const HingeScene& hinge, const reference::Entry& entry, const Vec3<Real50>& exact) {
  constexpr int kDraws = 20;
  Generator random(7);
  Measurement spread;
  for (int i = 0; i < kDraws; ++i) {
    const reference::Scene scene = nudged(hinge.scene, random);
    reference::Path<Real50> path(scene, entry, entry.probe_xi, hinge.setting);
    if (path.advance(1).status != Status::converged)
      return std::nan("");  // no limit comes from a path that stops
    spread.include(double(Real50((rotation_of(path) - exact).norm() / exact.norm())), {});
  }
  return spread.value();
}

}  // namespace halfway::verify
