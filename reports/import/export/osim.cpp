#include "reports/import/export/export.hpp"
#include "reports/import/record/frames.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

constexpr const char* kFormulation = "simbody_xyz";

std::string frame_text(const char* node, const JointEnd<double>& end) {
  return fmt::format(
      "            <PhysicalOffsetFrame name=\"on_{0}\">\n"
      "              <socket_parent>/bodyset/{0}</socket_parent>\n"
      "              <translation>{1}</translation>\n"
      "              <orientation>{2}</orientation>\n"
      "            </PhysicalOffsetFrame>\n",
      node, words_of(end.o, " "), words_of(angles_xyz(end.H), " "));
}

std::string body_text(const char* node) {
  return fmt::format(
      "        <Body name=\"{}\">\n          <mass>1</mass>\n          <mass_center>0 0 0</mass_center>\n"
      "          <inertia>1 1 1 0 0 0</inertia>\n        </Body>\n",
      node);
}

}  // namespace

Exported osim_of(const ExportRequest& request) {
  const auto& scene = request.scene;
  if (request.formulation != kFormulation)
    throw CannotSay(fmt::format(
        "{}: formulations: OpenSim's BushingForce computes {} and nothing else, not {}; allowed: --as {}",
        scene.name, kFormulation, request.formulation.empty() ? "what is not said" : request.formulation,
        kFormulation));
  demand_kind(scene, Kind::linear_angular, "OpenSim");
  const Eigen::MatrixXd& K = stiffness_of_scene(scene, "OpenSim");
  demand_diagonal(K, "OpenSim");
  Exported out;
  out.text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSimDocument Version=\"40000\">\n  <Model "
      "name=\"bushing\">\n    <BodySet>\n      <objects>\n";
  out.text +=
      body_text("a") + body_text("b") + "      </objects>\n    </BodySet>\n    <ForceSet>\n      <objects>\n";
  out.text += "        <BushingForce name=\"bushing\">\n          <frames>\n" +
              frame_text("a", scene.joint.a) + frame_text("b", scene.joint.b) + "          </frames>\n";
  out.text +=
      "          <socket_frame1>on_a</socket_frame1>\n          <socket_frame2>on_b</socket_frame2>\n";
  out.text += fmt::format(
      "          <rotational_stiffness>{}</rotational_stiffness>\n          "
      "<translational_stiffness>{}</translational_stiffness>\n",
      words_of(K.diagonal().tail<3>(), " "), words_of(K.diagonal().head<3>(), " "));
  out.text +=
      "          <rotational_damping>0 0 0</rotational_damping>\n          <translational_damping>0 0 "
      "0</translational_damping>\n";
  out.text += "        </BushingForce>\n      </objects>\n    </ForceSet>\n  </Model>\n</OpenSimDocument>\n";
  out.left_out.push_back("masses: both bodies have mass 1 and inertia 1");
  return out;
}

}  // namespace halfway::imports
