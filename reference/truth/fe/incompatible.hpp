// Linear compliance by hexahedra of 8 nodes with 13 incompatible modes, the paper's element.
//
// Only to tell the paper's discretisation error from its other errors: the tables' digits come from
// this element on a mesh that is far from converged.
#pragma once

#include "reference/truth/fe/laws.hpp"
#include "reference/truth/fe/mesh.hpp"

namespace halfway::reference::fe {

using Mat24 = Eigen::Matrix<double, 24, 24>;

/// Stiffness of one element with its internal modes condensed, N/m; unknowns (u_1, u_2, u_3) per node.
/// Exact for constant strain whatever the shape. Throws std::invalid_argument for a material
/// that is not positive, std::domain_error for a degenerate shape.
Mat24 incompatible_stiffness(const Eigen::Matrix<double, 3, 8>& X, const Material& material);

/// (d, theta) per (f, m) at the reference point (m), in m and rad per N and N m: face b moves as a rigid
/// body, face a is held. Throws std::invalid_argument unless the mesh is of hex8i, and as above.
Mat6 incompatible_compliance(const Mesh& mesh, const Material& material, const Vec3<double>& reference_point);

}  // namespace halfway::reference::fe
