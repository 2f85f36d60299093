// What a scene can ask of a state: motions, reactions, strains, energies.
#pragma once

#include "reference/mechanism/follow.hpp"

#include <complex>

namespace halfway::reference::mechanism {

/// One output of those that all_outputs of the reader names, but for those of modes; see MechanismScene.
template <class T>
T output(const Follower<T>& path, const std::string& name);

/// Estimated error of what the bodies have moved, the worst of all: rad, m.
template <class T>
T motion_error(const Follower<T>& path);

/// What a joint exerts on the body at a node, (f, m) about the node, global axes, N and N m.
template <class T>
Vec6<T> reaction(const Model<T>& model, const Poses<T>& at, std::size_t joint, bool at_a);

/// J: the joint's potential, or the law's energy at its strain where the formulation has none.
template <class T>
T joint_energy(const Model<T>& model, const Poses<T>& at, std::size_t joint);

/// A body's node in global axes.
template <class T>
Pose<T> node_of(const Model<T>& model, const Poses<T>& at, std::size_t body);

/// Small motions about an equilibrium, of the directions that nothing prescribes.
struct Modes {
  std::vector<double> frequencies;  ///< Hz, ascending; of motions that do not oscillate 0
  double growth = 0;                ///< 1/s, the fastest; 0 where none grows
  bool flutters = false;            ///< what grows oscillates
  std::vector<double> eigenvalues;  ///< of the tangent's symmetric part, ascending; N/m and N m/rad
};
/// @param with_masses  else eigenvalues alone
Modes modes(const Follower<double>& path, bool with_masses);

}  // namespace halfway::reference::mechanism
