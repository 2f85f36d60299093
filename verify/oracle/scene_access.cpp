#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace halfway::verify {

const std::vector<reference::Scene>& scenes() {
  static const std::vector<reference::Scene> all = reference::canonical_scenes();
  return all;
}

const reference::Scene& scene(const std::string& name) {
  const auto it = std::ranges::find(scenes(), name, &reference::Scene::name);
  if (it == scenes().end()) throw std::runtime_error("there is no canonical scene " + name);
  return *it;
}

Vec3<reference::Real50> rotation_at(const std::string& scene_name, const reference::Entry& entry, double xi,
                                    double factor) {
  reference::Path<reference::Real50> path(scene(scene_name), entry, xi);
  if (path.advance(factor).status != Status::converged) {
    throw std::runtime_error(
        fmt::format("{}/{} does not reach load factor {}", scene_name, entry.name, factor));
  }
  return {path.output("theta_x"), path.output("theta_y"), path.output("theta_z")};
}

Eigen::VectorXd compliances(const reference::Scene& scene) {
  const auto& law = std::get<reference::LinearSpec>(scene.joint.law);
  if (!law.is_compliance) throw std::runtime_error(scene.name + " has no compliance");
  return law.matrix.diagonal();
}

}  // namespace halfway::verify
