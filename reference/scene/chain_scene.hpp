// Scenes of chains: a rod as rigid links with joints at their middles, loads on its end, what is known.
#pragma once

#include "reference/scene/scene.hpp"

#include <variant>
#include <vector>

namespace halfway::reference {

/// Whose values a chain's are held to by this name in [reference.values]: the rod that it stands for.
inline constexpr const char* kRod = "rod";

/// On the last node at load factor 1, summed up by type, N and N m: fixed ones in global axes, followers in
/// those of the node.
struct ChainLoads {
  Vec3<double> fixed_force = Vec3<double>::Zero(), follower_force = Vec3<double>::Zero();
  Vec3<double> fixed_moment = Vec3<double>::Zero(), follower_moment = Vec3<double>::Zero();
};

/// A uniform rod along axis 1 of its sections, clamped at its root, as a chain of joints; outputs are the
/// tip's x, y, z (m) and theta_x, theta_y, theta_z (rad), the log of its rotation from the global axes.
struct ChainScene : SceneHead {
  int links = 1;
  double length = 1;                               ///< of the rod, m
  Vec3<double> bending = Vec3<double>::Zero();     ///< GJ, EI2, EI3, N m^2
  Vec3<double> stretching = Vec3<double>::Zero();  ///< EA, GA2, GA3, N
  Vec3<double> curvature = Vec3<double>::Zero();   ///< without stress, axes of the section, 1/m
  Pose<double> root;                               ///< of the first node
  ChainLoads loads;
};

/// A scene of either.
using AnyScene = std::variant<Scene, ChainScene>;

/// Reads and checks one scene, of a chain where it has a table [chain]. Throws SceneError.
AnyScene read_any_scene(const std::filesystem::path& file);

/// The scenes of chains in the folder `chains` of scenes_folder(), where there is one, ordered by name. Throws
/// SceneError.
std::vector<ChainScene> chain_scenes();

}  // namespace halfway::reference
