#include "reports/import/tests/support.hpp"

#include "reference/face/registry.hpp"
#include "reference/record/worst.hpp"
#include "reference/scene/scene_head.hpp"
#include "reference/scene/text/toml_tree.hpp"
#include "reports/import/scene/scene_text.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <stdexcept>

namespace halfway::imports::test {
namespace {

/// N, N m: at rest loads are roundings. The data's stiffnesses are some N/m and N m, so this is a strain of
/// 1e-3.
constexpr double kRest = 1e-2;

}  // namespace

std::string sample(const std::string& name) {
  return reports::read_file(std::filesystem::path(HALFWAY_IMPORT_SAMPLES) / name);
}

reference::Scene written_scene(const ImportedJoint& joint, const std::string& as) {
  const std::string text =
      scene_text(joint, "a \"file\"", as.empty() ? joint.formulation : as, example_load(joint));
  reference::Document document;
  reference::read_toml_text(text, "written.toml", document);
  return reference::joint_scene(reference::Field(document), "written.toml");
}

ImportedJoint only_joint(const std::string& text, const ImportOptions& options) {
  const auto joints = read_joints(text, options);
  if (joints.size() != 1) throw std::runtime_error(fmt::format("{} joints", joints.size()));
  return joints[0];
}

Eigen::Matrix<double, 12, 1> loads_of(const reference::Scene& scene, const Pose<double>& a,
                                      const Pose<double>& b) {
  const auto* entry = reference::find_formulation(scene.formulations.at(0));
  return reference::node_loads<double>(*entry, scene.joint, a, b, false).q;
}

double load_error(const Eigen::Matrix<double, 12, 1>& measured, const Eigen::Matrix<double, 12, 1>& truth) {
  double worst = 0;
  for (int part : {0, 3}) {
    const double loads = reference::larger(truth.segment<3>(part).norm(), truth.segment<3>(6 + part).norm());
    const double scale = reference::larger(loads, kRest);
    for (int node : {0, 6}) {
      const double off = (measured - truth).segment<3>(node + part).norm();
      reference::keep_largest(worst, off / scale);
    }
  }
  return worst;
}

std::string words(const Eigen::VectorXd& values, const char* between) {
  std::string out;
  for (double value : values) out += fmt::format("{}{:.17g}", out.empty() ? "" : between, value);
  return out;
}

Pose<double> pose_at(const Eigen::Vector3d& rotation, const Eigen::Vector3d& place) {
  return {place, Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix()};
}

}  // namespace halfway::imports::test
