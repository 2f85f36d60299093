// Scenes: a joint, loads, wanted outputs and reference values, as a person writes them (TOML). Of chains see
// chain_scene.hpp.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/record/finding.hpp"
#include "reference/scene/text/document.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace halfway::reference {

enum class LoadType {
  fixed_moment,            ///< moment on node b, global axes, N m
  follower_moment,         ///< moment on node b, axes of node b, N m
  fixed_force,             ///< force on node b, global axes, N, at `point` in the axes of node b, m
  follower_force,          ///< force on node b, axes of node b, N, at `point` likewise
  semi_tangential_moment,  ///< four dead forces on a cross fixed to node b, see halfway/equilibrium; N m
  quasi_tangential_moment  ///< a pair of dead forces on an arm fixed to node b; N m
};
inline bool is_force(LoadType type) {
  return type == LoadType::fixed_force || type == LoadType::follower_force;
}
/// Is the value given in axes of the node?
inline bool follows(LoadType type) {
  return type == LoadType::follower_moment || type == LoadType::follower_force;
}
const char* to_string(LoadType type);

struct SceneLoad {
  LoadType type = LoadType::fixed_moment;
  Vec3<double> value = Vec3<double>::Zero();  ///< at load factor 1
  Vec3<double> point = Vec3<double>::Zero();
  Vec3<double> arm = Vec3<double>::UnitX();  ///< of a quasi_tangential_moment, axes of node b
  bool held = false;                         ///< in full from load factor 0 on
};

/// One reference value of the scene: output at a load factor.
struct SceneReference {
  std::string formulation;  ///< or kRod, in a scene of a chain
  double factor = 1;
  std::string output;        ///< one of the scene's, or one of critical_*
  std::string value;         ///< decimal text, all digits kept for 50-digit comparison; empty if `none`
  bool none = false;         ///< the statement is that there is none: no critical moment below pi
  double tolerance = 1e-12;  ///< relative, or absolute (unit of the output) where `absolute`
  bool absolute = false;
  std::string reason;  ///< why the tolerance is what it is
  Oracle oracle = Oracle::fifty_digits;
  std::string source;
  double xi = 0.5;  ///< of a formulation that has one
};

/// rad, m, N, N m, J, Hz, 1/s, m/s, rad/s, W, kg m/s or kg m^2/s: the unit of an output of any scene; ""
/// where it depends on more than its name.
std::string_view unit_of_output(std::string_view output);

/// critical_factor is the first load factor up to factor_end at which the tangent is singular, of scenes that
/// ask for it (path.critical).
/// critical_moment (N m) and critical_angle (rad): the first singular tangent under a moment about the joint
/// axis Scene::critical_axis, counted from the unstrained pose whatever frames the nodes have. They belong to
/// the joint, not to a load factor; `factor` is 0 for them.
bool is_critical(const std::string& output);

/// What a scene says whatever it is of, a joint or a chain.
struct SceneHead {
  std::string name;  ///< file name without extension, e.g. c1_skewed_torque
  std::string title;
  std::string description;
  std::string source;
  bool is_in_time = false;           ///< what runs is the time, s, and no load factor
  double factor_end = 1;             ///< the load factor, or the time, runs from 0 to here
  int points = 20;                   ///< output points of the curve
  bool asks_critical = false;        ///< for the first load factor of a singular tangent, critical_factor
  int critical_axis = 0;             ///< joint axis 1, 2, 3 about which critical_* are asked; 0: not asked
  std::vector<std::string> outputs;  ///< the curves' columns
  std::vector<std::string> formulations;  ///< which to solve, in the order of the file; empty: all
  std::vector<double> xis;                ///< at which a formulation with a free xi is solved
  std::vector<SceneReference> references;
  std::vector<std::string> notes;  ///< what the file says otherwise than it was taken: a frame normalised
};

/// What the curves of a scene run over, in words: "load factor" or "time".
inline const char* runs_over(const SceneHead& scene) { return scene.is_in_time ? "time" : "load factor"; }

/// A joint between a clamped node and a loaded one; outputs theta_x ... u_z.
struct Scene : SceneHead {
  JointSpec joint;
  bool has_length = false;  ///< does the file say the joint's rod, which formulations of one need?
  std::vector<SceneLoad> loads;
};

/// Reads and checks one scene of a joint; the format is described in reference/scenes/README.md. Throws
/// SceneError, also where the file says a chain or a mechanism.
Scene read_scene(const std::filesystem::path& file);

/// $HALFWAY_SCENES, or the folder of the sources that was built in.
std::filesystem::path scenes_folder();

/// The scenes of that folder, ordered by name. Throws SceneError, also when there is none.
std::vector<Scene> canonical_scenes();

/// Those of another folder, likewise.
std::vector<Scene> scenes_in(const std::filesystem::path& folder);

}  // namespace halfway::reference
