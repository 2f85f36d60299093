// Structured, graded hexahedral meshes of a body held at one face and moved rigidly at another.
#pragma once

#include "reference/truth/fe/shapes.hpp"

#include <array>
#include <functional>
#include <vector>

namespace halfway::reference::fe {

/// A solid between two faces. Global axes are those of the paper's figures.
struct Mesh {
  ElementKind element = ElementKind::hex20;
  Eigen::Matrix3Xd X;        ///< 3 x nodes, m, unloaded
  Eigen::MatrixXi elements;  ///< nodes per element x elements
  std::vector<int> clamped;  ///< nodes of the face of node a
  std::vector<int> rigid;    ///< nodes of the face of node b
};

/// Per node its place among the interior nodes, and its column among those of the rigid face; -1: not one.
struct Numbering {
  std::vector<int> interior, face;
  int interior_count = 0;
};
Numbering number_nodes(const Mesh& mesh);

/// A box of elements: the image of [0, 1]^3, whose side t_1 = 0 may be clamped and t_1 = 1 rigid.
struct Patch {
  std::array<int, 3> divisions;
  std::array<double, 3> grading;    ///< exponent p toward both ends: 1 uniform, 3 for edge singularities
  std::array<bool, 3> one_sided{};  ///< grade toward t = 1 only (the other end is an inner interface)
  std::function<Vec3<double>(const Vec3<double>&)> map;
};

/// Patches that meet share the nodes that coincide (to 1e-9 of the body's size). Every patch has its
/// clamped side at t_1 = 0 and its rigid side at t_1 = 1. Throws std::invalid_argument where an element
/// is turned inside out.
Mesh structured(ElementKind element, const std::vector<Patch>& patches);

/// Parallelepiped and frustum: rectangular sections normal to axis 1, linear in between, m.
struct TaperedBlock {
  double length;                  ///< along axis 1; clamped at x_1 = 0, free face at x_1 = length
  std::array<double, 2> clamped;  ///< edges along axes 2 and 3 of the clamped section
  std::array<double, 2> free;     ///< of the free section
};

/// Divisions along axes 1, 2, 3. grading = 3 resolves the singular edges, 1 is the paper's mesh.
Mesh tapered_block(ElementKind element, const TaperedBlock& body, const std::array<int, 3>& divisions,
                   double grading);

}  // namespace halfway::reference::fe
