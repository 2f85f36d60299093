// Scenes of chains: a rod as rigid links with joints at their middles, what acts on its end, what is known.
#pragma once

#include "reference/chain/chain.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/text/fields.hpp"

#include <optional>
#include <vector>

namespace halfway::reference {

/// Whose values a chain's are held to by this name in [reference.values]: the rod that it stands for.
inline constexpr const char* kRod = "rod";

/// A uniform rod, clamped at its root, as a chain of joints; outputs are the tip's x, y, z (m) and theta_x,
/// theta_y, theta_z (rad), the log of its rotation from the global axes.
struct ChainScene : SceneHead {
  chain::Chain chain;                  ///< but for the formulation
  chain::EndLoads loads;               ///< at load factor 1; those of a type are summed up
  std::optional<Pose<double>> held{};  ///< of the last node, where it is held instead
  int held_steps = 20;                 ///< on the way there from where it is at rest
};

/// Reads the table [chain] and what stands beside it. Throws Refusal.
ChainScene chain_scene(const Field& file, const std::filesystem::path& path);

}  // namespace halfway::reference
