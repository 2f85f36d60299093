// Isoparametric hexahedra on [-1, 1]^3: nodes, shape functions, Gauss points.
//
// Own code, because no kept library of Debian gives large-strain solids with rigid faces to a C++
// program without becoming its framework (deal.II, MFEM and FEniCS own mesh, solver and main loop).
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <string>
#include <vector>

namespace halfway::reference::fe {

/// Nodes and integration. hex20 is the default; hex20_full and hex27 are its cross-checks; hex8i
/// (13 incompatible modes, linear analysis only) has the nodes and points of a plain hex8.
enum class ElementKind { hex20, hex20_full, hex27, hex8i };

const char* to_string(ElementKind kind);
/// Throws std::invalid_argument naming the value and what is allowed.
ElementKind element_kind(const std::string& name);

struct ReferenceElement {
  ElementKind kind;
  std::vector<Vec3<int>> nodes;      ///< coordinates -1, 0, 1; corners, then edges, as CalculiX orders them
  std::vector<Vec3<double>> points;  ///< of the integration
  std::vector<double> weights;       ///< sum to 8
  std::vector<Eigen::Matrix3Xd> dN;  ///< per point 3 x nodes, d N / d local coordinate
};

/// One object per kind, built at first use.
const ReferenceElement& reference_element(ElementKind kind);

}  // namespace halfway::reference::fe
