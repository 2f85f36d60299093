#include "verify/studies/mechanisms/motion.hpp"

#include "reference/numbers/random.hpp"
#include "reference/scene/any_scene.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <cmath>

namespace halfway::verify {

using reference::MechanismScene;

const char* const kTorsion = R"(title = "torsion"
outputs = ["spring.strain_3", "balance"]
[[body]]
name = "b"
inertia = [[2e-3, 0, 0], [0, 4.8432e-3, 0.5376e-3], [0, 0.5376e-3, 3.1568e-3]]
START
[[joint]]
name = "spring"
between = ["ground", "b"]
kind = "angular"
frame_a = [0.8, 0, 0.6, 0]
frame_b = [0.6, 0.8, 0, 0]
damping = [0, 0, DAMPING]
[joint.law]
type = "linear"
stiffness = [0.1, 0.2, 0.3]
[[load]]
type = "fixed_moment"
value = MOMENT
times = [0, 0.5]
factors = [0, 1]
[time]
duration = 2
points = 20
INTEGRATION
)";

/// Free motion of x'' + 2 d x' + w0^2 x = 0 and a particular solution on each part of the way.
double Torsion::angle(double t) const {
  const double d = c / (2 * J), w = std::sqrt(k / J - d * d), rate = M / ramp;
  struct Motion {
    double x, v;
  };
  const auto free = [&](const Motion& at, double s) -> Motion {
    const double C = std::exp(-d * s) * std::cos(w * s), S = std::exp(-d * s) * std::sin(w * s) / w;
    return {C * at.x + S * (at.v + d * at.x), C * at.v - S * (d * at.v + k / J * at.x)};
  };
  const auto growing = [&](double s) -> Motion {
    const Motion own = free({start + rate * c / (k * k), -rate / k}, s);
    return {own.x + rate / k * (s - c / k), own.v + rate / k};
  };
  if (t <= ramp) return growing(t).x;
  const Motion at = growing(ramp);
  return M / k + free({at.x - M / k, at.v}, t - ramp).x;
}

MechanismScene scene_of(std::string text, const std::map<std::string, std::string>& words) {
  for (const auto& [word, by] : words) {
    for (std::size_t at; (at = text.find(word)) != std::string::npos;) text.replace(at, word.size(), by);
  }
  return std::get<MechanismScene>(reference::read_scene_text(text, "scene.toml"));
}

reference::Curve moved(const MechanismScene& scene, const char* formulation) {
  const auto& entry = *reference::find_formulation(formulation);
  return reference::solve_motion(scene, {&entry, entry.probe_xi});
}

MechanismScene generic_motion(const reference::Entry& entry) {
  MechanismScene out = generic_loop(entry, false);
  reference::Generator random(313);
  out.is_in_time = true;
  out.time = reference::SceneTime{reference::Integrator::runge_kutta, 1e-12, 0};
  out.factor_end = 0.5;
  out.points = 10;
  for (const int i : {1, 2}) {
    reference::SceneBody& body = out.bodies[std::size_t(i)];
    const Mat3<double> axes = random.rotation(0.3, 1);
    body.mass = 1 + i;
    body.center = random.vector(0.3);
    body.inertia = axes * Vec3<double>(1, 1.4, 2).asDiagonal() * axes.transpose();
    body.start = {random.vector(0.2), random.vector(0.1), random.vector(0.5), random.vector(1), i == 2};
  }
  for (auto& joint : out.joints) {
    const auto& law = std::get<reference::LinearSpec>(joint.spec.law);
    joint.damping = 0.05 * law.matrix;
  }
  for (auto& load : out.loads) load.held = false;
  out.loads[1].times = {0.1, 0.2, 0.4}, out.loads[1].factors = {0, 1, 0.5};
  out.loads[2].times = {0, 0.5}, out.loads[2].factors = {0, 2};
  return out;
}

}  // namespace halfway::verify
