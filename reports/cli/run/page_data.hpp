// What a run's page is drawn from: reports/run.schema.json describes it.
#pragma once

#include "reports/cli/run/run_choices.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace halfway::reports {

/// What makes a page, whatever was solved.
struct Ran {
  std::string command;  ///< that makes it again
  std::vector<reference::Curve> curves;
  std::vector<NotRun> left_out;
};

using Json = nlohmann::ordered_json;

/// All but bodies, joints and loads, and without poses of the curves: of any scene.
Json page_head(const reference::SceneHead& scene, const Ran& ran);

/// Of one joint between a clamped and a loaded node.
Json page_data(const reference::Scene& scene, const Ran& ran);

/// Of bodies and joints; what holds them is in the outputs that its scene asks for.
Json page_data(const reference::MechanismScene& scene, const Ran& ran);

/// x (m) and unit quaternion w, x, y, z, node axes to global ones, in eight digits: what a drawing needs.
Json pose_json(const Pose<double>& pose);
Json vector_json(const Vec3<double>& v);
/// A force and a moment, likewise in eight digits.
Json load_numbers(const Eigen::Matrix<double, 6, 1>& load);

}  // namespace halfway::reports
