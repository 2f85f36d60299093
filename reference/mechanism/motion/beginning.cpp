#include "reference/mechanism/motion/beginning.hpp"

#include "reference/mechanism/solve.hpp"

#include <fmt/format.h>

namespace halfway::reference::mechanism {
namespace {

/// The loads of time 0 as those of one step; the springs alone, as nothing moves.
MechanismScene at_time_zero(MechanismScene scene) {
  scene.time.reset();
  scene.is_in_time = false;
  scene.outputs.clear();
  scene.steps = scene.points = 1;
  scene.factor_end = 1;
  for (BodyLoad& load : scene.loads) {
    if (!load.times.empty()) load.factors.resize(1);
    load.times.clear();
  }
  return scene;
}

Beginning equilibrium(const MechanismScene& scene, const Choice& choice) {
  const Curve curve = solve_scene(at_time_zero(scene), choice);
  if (curve.converged) return {curve.poses.back(), curve.errors.back()};
  const std::string share =
      curve.rows.empty() ? "" : fmt::format(" at {:.3g} of them", curve.rows.back().front());
  return {{}, 0, fmt::format("no equilibrium under the loads of time 0{}: {}", share, curve.cause)};
}

}  // namespace

Beginning beginning(const MechanismScene& scene, const Choice& choice) {
  if (scene.time->from_equilibrium) return equilibrium(scene, choice);
  Beginning out;
  const auto rest = initial_poses<double>(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneStart& start = scene.bodies[i].start;
    out.nodes.push_back({rest[i]->x + start.u, so3::exp<double>(start.theta) * rest[i]->R});
  }
  return out;
}

}  // namespace halfway::reference::mechanism
