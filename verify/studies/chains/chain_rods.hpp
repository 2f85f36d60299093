// The rods that chains are held to: scenes of chains, with the tip by two independent methods.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/scene/chain_scene.hpp"

#include <string>
#include <vector>

namespace halfway::verify {

struct ChainRod {
  const reference::ChainScene* scene;
  reference::chain::EndLoads loads;  ///< at the last load factor
  Vec3<double> tip;                  ///< of the rod there, m
  double uncertainty;                ///< of each of its coordinates, m: ten times half of the last digit kept
};

/// Of the scene of that name.
const ChainRod& chain_rod(const std::string& name);

/// Those that tell an order: where torsion is as stiff as bending the order of nodes does not show.
inline constexpr const char* kOrderRods[] = {"straight_anisotropic", "straight_slender",
                                             "precurved_anisotropic", "bend_45_st_venant"};

/// All scenes of chains, read once.
const std::vector<reference::ChainScene>& chains();
const reference::ChainScene& chain_scene(const std::string& name);

/// The chain of a scene with `links` joints of one formulation, a free xi being its probe's.
reference::chain::Chain chain_with(const reference::ChainScene& scene, const reference::Entry& entry,
                                   long links);

/// Twelve links, turned, shifted and pre-curved.
reference::chain::Chain generic_chain(const reference::Entry& entry);
/// A virial of dead forces on its last node, N m.
extern const Mat3<double> kDeadForces;

}  // namespace halfway::verify
