// A scene's joint in the words of another program, which refuses by name what it cannot say.
#pragma once

#include "reference/scene/scene.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace halfway::imports {

/// What a target cannot say of a scene.
struct CannotSay : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ExportRequest {
  reference::Scene scene{};
  std::string formulation{};  ///< that is meant; empty: the scene names none, or several
  bool law_only = false;      ///< frames and formulation are left out, and named
};

struct Exported {
  std::string text{};
  std::vector<std::string> left_out{};  ///< what does not stand in it
};

struct Target {
  const char* name;       ///< as after --to
  const char* extension;  ///< with the dot
  Exported (*write)(const ExportRequest&);
};
const std::vector<Target>& targets();

Exported bus_of(const ExportRequest& request);
Exported osim_of(const ExportRequest& request);
Exported mbdyn_of(const ExportRequest& request);

/// The stiffness of a linear law. Throws CannotSay of any other law.
const Eigen::MatrixXd& stiffness_of_scene(const reference::Scene& scene, const char* target);
/// Throws CannotSay where it has entries off the diagonal.
void demand_diagonal(const Eigen::MatrixXd& K, const char* target);
void demand_kind(const reference::Scene& scene, Kind kind, const char* target);

/// All digits.
std::string digits_of(double value);
/// "1, 2, 3"
std::string words_of(const Eigen::VectorXd& values, const char* between);

/// Imports the text again and compares: the same stiffness and offsets to the last digit, frames to 1e-15.
/// Throws std::runtime_error saying what came back otherwise.
void demand_same(const ExportRequest& request, const Exported& exported);

}  // namespace halfway::imports
