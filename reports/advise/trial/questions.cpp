#include "reference/numbers/random.hpp"
#include "reports/advise/trial/trial.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::advise {
namespace {

using reference::Generator, reference::Scene;

double log_uniform(Generator& g, double low, double high) {
  return low * std::pow(high / low, g.uniform(0, 1));
}

/// Principal stiffnesses up to a factor of 100 apart, in the joint's axes or not.
Eigen::MatrixXd random_stiffness(Generator& g) {
  const double scale = log_uniform(g, 1e-2, 1e6), ratio = log_uniform(g, 1, 100);
  Vec3<double> k(1, log_uniform(g, 1, ratio), ratio);
  std::swap(k[0], k[int(g.uniform(0, 2.999))]);
  const Mat3<double> Q = g.uniform(0, 1) < 0.5 ? Mat3<double>(Mat3<double>::Identity()) : g.rotation(0.1, 3);
  const Mat3<double> K = scale * (Q * k.asDiagonal() * Q.transpose());
  return (K + K.transpose()) / 2;
}

Scene angular_scene(Generator& g) {
  Scene out;
  out.name = out.title = "random";
  out.outputs = {"theta_x", "theta_y", "theta_z"};
  const Eigen::MatrixXd K = random_stiffness(g);
  out.joint.law = reference::LinearSpec{K, false};
  if (g.uniform(0, 1) < 0.5) {
    out.joint.a.H = g.rotation(0.2, 3);
    out.joint.b.H = g.rotation(0.2, 3);
  }
  // Turns in any direction, and moments in any direction, which mostly turn about the soft axis.
  Vec3<double> moment = g.direction();
  if (g.uniform(0, 1) < 0.5) moment = (K * moment).normalized();
  out.loads = {{reference::LoadType::fixed_moment, out.joint.a.H * moment * K.norm()}};
  out.factor_end = 1e-3;
  return out;
}

/// A slender rod whose end is at node b, under a force and a moment there.
Scene slender_scene(Generator& g) {
  Scene out;
  out.name = out.title = "random";
  out.outputs = {"theta_x", "theta_y", "theta_z", "u_x", "u_y", "u_z"};
  reference::JointSpec& joint = out.joint;
  joint.kind = Kind::linear_angular;
  joint.length = log_uniform(g, 0.05, 2), joint.axis = 1, out.has_length = true;
  const double L = joint.length, EI = log_uniform(g, 1, 1e4);
  const Vec3<double> bending(EI * log_uniform(g, 0.3, 3), EI, EI * log_uniform(g, 1, 20));
  const double EA = 12 * EI / (L * L) * log_uniform(g, 1e2, 1e5), GA = EA / 2;
  const auto across = [&](double stiffness) { return 1 / (L * L * L / (12 * stiffness) + L / GA); };
  Eigen::VectorXd k(6);
  k << EA / L, across(bending[2]), across(bending[1]), bending / L;
  joint.law = reference::LinearSpec{k.asDiagonal(), false};
  joint.a = {Vec3<double>(L / 2, 0, 0), Mat3<double>::Identity()};
  joint.b = {Vec3<double>(-L / 2, 0, 0), Mat3<double>::Identity()};
  out.loads = {{reference::LoadType::fixed_force, g.direction() * EI / (L * L)},
               {reference::LoadType::fixed_moment, g.direction() * EI / L}};
  out.factor_end = log_uniform(g, 1e-4, 0.6);
  return out;
}

Question of_body(Generator& g) {
  constexpr const char* kScenes[] = {"c2_parallelepiped_small", "c4_frustum", "c6_compression_shear"};
  Question out;
  const std::string name = kScenes[int(g.uniform(0, 2.999))];
  out.scene = reference::read_scene(reference::scenes_folder() / (name + ".toml"));
  out.scene.factor_end *= log_uniform(g, 0.2, 200);
  out.truth = "body";
  return out;
}

}  // namespace

Question random_question(int number) {
  Generator g(20260 + std::uint64_t(number));
  Question out;
  const double sort = g.uniform(0, 1);
  if (sort < 0.15) {
    out = of_body(g);
  } else if (sort < 0.3) {
    out.scene = slender_scene(g);
    out.truth = "rod";
  } else {
    out.scene = angular_scene(g);
    out.truth = sort < 0.45 ? "chain:" + std::to_string(2 + int(g.uniform(0, 6.999))) : "rod";
    out.degrees = log_uniform(g, 0.05, 60);
  }
  out.tolerance = log_uniform(g, 1e-5, 0.1);
  return out;
}

}  // namespace halfway::advise
