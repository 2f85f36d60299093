// Rigid bushings with one soft hinge and a lever, from a stiffness ratio of 1e4 to one of 1e16.
#pragma once

#include "reference/solve/path.hpp"

#include <optional>
#include <string>
#include <vector>

namespace halfway::verify {

struct HingeScene {
  reference::Scene scene;
  reference::Setting setting;
  std::string where;  ///< ratio kt l^2 / ks and lever, for people
};

/// In the plane: the hinge about x, the node a lever l away along -y, forces across the axis and a moment.
std::vector<HingeScene> planar_hinges();

/// Frames on both nodes and the scene turned by what is not exact in binary, offsets on both, nodes exchanged
/// in every other one, loads in all directions and a law that couples the axes: K = D^(1/2) (1 + C) D^(1/2).
/// @param block_diagonal  no coupling of translation and rotation
std::vector<HingeScene> generic_hinges(bool block_diagonal);

/// Rotation about the hinge of a planar scene by the scalar equation ks g(t) = M + l (Fz cos t - Fy sin t);
/// nothing for a formulation whose moment about the hinge is not known to be ks g(t) alone.
std::optional<reference::Real50> planar_root(const reference::Scene& scene, std::string_view formulation);

/// Rotation of the loaded node, scene axes, rad.
template <class T>
Vec3<T> rotation_of(const reference::Path<T>& path) {
  return {path.output("theta_x"), path.output("theta_y"), path.output("theta_z")};
}

/// What double input can say: the relative spread of the rotation at 50 digits when each number of the scene
/// moves to a neighbour, over 20 draws.
double floor_of(const HingeScene& hinge, const reference::Entry& entry, const Vec3<reference::Real50>& exact);

}  // namespace halfway::verify
