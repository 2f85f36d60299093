#include "reports/import/tests/promises.hpp"

#include "reference/scene/scene_head.hpp"
#include "reference/scene/text/toml_tree.hpp"
#include "reports/import/readers/readers.hpp"
#include "reports/import/scene/scene_text.hpp"
#include "reports/import/scene/spread.hpp"
#include "reports/tests/fuzz/refusal_promise.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>

namespace halfway::imports::test {
namespace {

bool is_rotation(const Mat3<double>& R) {
  return (R * R.transpose() - Mat3<double>::Identity()).norm() < 2e-3 && R.determinant() > 0;
}

/// What the scene reader says against the scene, which the command then says.
std::string broken_by_scene(const ImportedJoint& joint, const std::string& formulation) {
  std::string text;
  try {
    text = scene_text(joint, "f", formulation, example_load(joint));
  } catch (const reference::Refusal&) {
    return "";  // nothing is stiff
  }
  reference::Document document;
  try {
    reference::read_toml_text(text, "written.toml", document);
  } catch (const std::exception& error) {
    return fmt::format("what is written is no TOML: {}", error.what());
  }
  try {
    const reference::Scene scene = reference::joint_scene(reference::Field(document), "written.toml");
    const auto* linear = std::get_if<reference::LinearSpec>(&scene.joint.law);
    if (linear && joint.axes.empty() && joint.preload.size() == 0 && joint.K.isDiagonal(0) &&
        linear->matrix != joint.K)
      return "the stiffness is read back otherwise";
    if (scene.joint.a.o != joint.a.o || scene.joint.b.o != joint.b.o)
      return "an offset is read back otherwise";
  } catch (const reference::Refusal& refusal) {
    if (refusal.code == "missing_key" || refusal.code == "wrong_shape" || refusal.code == "not_a_rotation")
      return fmt::format("the scene is refused: {}", refusal.what());
  }
  return "";
}

std::string broken_by(const ImportedJoint& joint) {
  const Eigen::MatrixXd K = stiffness_at_rest(joint);
  if (K.rows() != strains_of(joint.kind) || !K.allFinite()) return "a stiffness that is not finite";
  if (!joint.a.o.allFinite() || !joint.b.o.allFinite()) return "an offset that is not finite";
  if (!is_rotation(joint.a.H) || !is_rotation(joint.b.H)) return "a frame that is no rotation";
  spread_table(joint);
  return broken_by_scene(joint, joint.formulation.empty() ? "field_a" : joint.formulation);
}

}  // namespace

std::string broken_promise(std::string_view text) {
  try {
    const auto joints = read_joints(text, {});
    if (joints.empty()) return "no joint and no refusal";
    for (const ImportedJoint& joint : joints) {
      if (const std::string broken = broken_by(joint); !broken.empty()) return broken;
    }
  } catch (const reference::Refusal& refusal) {
    return reports::test::broken_by(refusal, text);
  } catch (const std::exception& error) {
    return fmt::format("another exception: {}", error.what());
  }
  return "";
}

}  // namespace halfway::imports::test
