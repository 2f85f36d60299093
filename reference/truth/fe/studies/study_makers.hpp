// One maker per kind of study; studies.cpp strings them into the list.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/truth/fe/studies/studies.hpp"

namespace halfway::reference::fe {

/// Raised when results change for the same inputs.
inline constexpr int kGeneratorVersion = 1;

/// version, geometry and material: what every study of a body follows from.
nlohmann::json inputs_of(const Body& body);

/// The loads of a canonical scene at factor 1, acting at the joint point.
Load scene_load(const std::string& scene);

Study characterisation_study(const Body& body, const std::vector<MeshPlan>& plans);

/// A scene's load path on a body, one curve per law, 20 points up to `reach` times the scene's load. Beyond 1
/// the curve is named after the study: it tells ranges and belongs to no figure.
struct CurvePlan {
  std::string name, what, scene, body;
  int level;
  double reach = 1;
};
Study curve_study(const CurvePlan& plan);

/// The bearing: fits to Table 4, scans of the hole, xi of each family, Fig. 9.
Study bearing_study();
/// The fitted family that agrees best with the printed text: plane cut, conical hole. Throws
/// std::runtime_error while the study is not kept.
Body fitted_bearing();

/// The block under C3's moment, fixed in direction: paths up to their limits and past them.
Study c3_block_study();

/// Nonlinear solves over meshes (Newton, factors kept while they gain a digit): time and memory.
Study newton_cost_study();
/// CalculiX on the same meshes: xi and time.
Study calculix_study();

/// Outer surfaces, undeformed and deformed, for pictures.
Study shapes_study();

}  // namespace halfway::reference::fe
