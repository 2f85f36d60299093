// Scenes: a joint, loads, wanted outputs and reference values, as a person writes them (TOML).
#pragma once

#include "reference/finding.hpp"
#include "reference/joint_spec.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace halfway::reference {

/// A mistake in a scene file: "FILE:LINE: KEY = VALUE: what is wrong; allowed: ...".
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class LoadType {
  fixed_moment,     ///< moment on node b, global axes, N m
  follower_moment,  ///< moment on node b, axes of node b, N m
  fixed_force       ///< force on node b, global axes, N, at `point` in the axes of node b, m
};

struct SceneLoad {
  LoadType type = LoadType::fixed_moment;
  Vec3<double> value = Vec3<double>::Zero();  ///< at load factor 1
  Vec3<double> point = Vec3<double>::Zero();
};

/// One reference value of the scene: output at a load factor.
struct SceneReference {
  std::string formulation;
  double factor = 1;
  std::string output;        ///< theta_x, theta_y, theta_z, u_x, u_y, u_z, critical_moment, critical_angle
  std::string value;         ///< decimal text, all digits kept for 50-digit comparison
  double tolerance = 1e-12;  ///< relative, or absolute where `absolute`
  bool absolute = false;
  Oracle oracle = Oracle::fifty_digits;
  std::string source;
  double xi = 0.5;
};

struct Scene {
  std::string name;         ///< file name without extension, e.g. c1_skewed_torque
  std::string title;
  std::string description;
  std::string source;
  JointSpec joint;
  std::vector<SceneLoad> loads;
  double factor_end = 1;    ///< the load factor runs from 0 to here
  int points = 20;          ///< output points of the curve
  std::vector<std::string> outputs;       ///< theta_x ... u_z: the curves' columns
  std::vector<std::string> formulations;  ///< which to solve; empty: all of the catalog
  std::vector<double> xis;                ///< further xi for `intrinsic`
  std::vector<SceneReference> references;
};

/// Reads and checks one scene. Throws SceneError.
Scene read_scene(const std::filesystem::path& file);

/// The canonical scenes, by name. `folder` defaults to the one that was built in or $HALFWAY_SCENES.
std::vector<Scene> canonical_scenes();
std::filesystem::path scenes_folder();

}  // namespace halfway::reference
