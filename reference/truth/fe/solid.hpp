// A meshed solid between a clamped face and a rigid face: total Lagrangian assembly.
#pragma once

#include "reference/truth/fe/laws.hpp"
#include "reference/truth/fe/mesh.hpp"

#include <Eigen/SparseCore>

namespace halfway::reference::fe {

/// Where the solid is: u of every node (m), and the pose of the rigid face, which carries its nodes:
/// u_i = d + (R - I) X_i, with X_i from the reference point.
struct State {
  Eigen::Matrix3Xd u;
  Vec3<double> d = Vec3<double>::Zero();      ///< of the reference point, m
  Mat3<double> R = Mat3<double>::Identity();  ///< of the face
};

/// Internal forces, and their derivatives by interior displacements and by the face's (dx, dw), where dw
/// is a spin: dR = [dw] R. The tangent of a law without potential is taken by its symmetric part.
struct Assembly {
  Eigen::Matrix3Xd force;                           ///< of every node, N
  Eigen::SparseMatrix<double> K;                    ///< interior, lower triangle, N/m
  Eigen::Matrix<double, Eigen::Dynamic, 6> K_face;  ///< interior rows, columns dx, dw
  Mat6 face;                                        ///< the face's own block, with the change of the arms
};

class Solid {
 public:
  /// reference_point: where the face's displacement is read and its force acts, m; it moves with the face.
  /// Throws std::invalid_argument for hex8i (linear analysis only) and as check(material).
  Solid(Mesh mesh, const Material& material, const Vec3<double>& reference_point);

  const Mesh& mesh() const { return mesh_; }
  const Material& material() const { return material_; }
  int unknowns() const { return interior_unknowns() + 6; }
  int interior_unknowns() const { return 3 * numbering_.interior_count; }

  State unloaded() const;
  /// Moves the interior by `interior` (m) and the face by the increment (dx, dw), dw a rotation vector.
  void move(State& state, const Eigen::VectorXd& interior, const Vec6& face) const;
  /// Nodal values of the interior as one vector, in the order of K.
  Eigen::VectorXd interior(const Eigen::Matrix3Xd& nodal) const;

  Assembly assemble(SolidLaw law, const State& state) const;
  /// Force and moment about the moved reference point that the face's nodes exert, N and N m.
  Vec6 face_load(const State& state, const Eigen::Matrix3Xd& force) const;

  /// Material coordinates of the face's nodes from the reference point, m (one column each).
  const Eigen::Matrix3Xd& arms() const { return arms_; }
  /// dN / dX of one point of one element, 3 x nodes per element, 1/m.
  Eigen::Map<const Eigen::Matrix3Xd> gradients(Eigen::Index element, Eigen::Index point) const;
  /// Volume of that point, m^3.
  double volume(Eigen::Index element, Eigen::Index point) const { return volumes_(point, element); }
  Eigen::Index points() const { return volumes_.rows(); }

 private:
  void find_arms();
  void find_gradients();
  void find_pattern();
  void place_face(State& state) const;
  template <int nodes>
  void assemble_range(SolidLaw law, const State& state, Eigen::Index begin, Eigen::Index end,
                      Assembly& out) const;
  template <int nodes>
  Assembly assemble_all(SolidLaw law, const State& state) const;
  void scatter(Eigen::Index element, const Eigen::MatrixXd& K, Assembly& out) const;
  void scatter_face(Eigen::Index element, const Eigen::MatrixXd& K, const State& state, Assembly& out) const;

  Mesh mesh_;
  Material material_;
  Vec3<double> reference_point_;
  Eigen::Matrix3Xd arms_;
  Numbering numbering_;
  Eigen::Matrix3Xd gradients_;  ///< elements x points x nodes columns
  Eigen::MatrixXd volumes_;     ///< points x elements
  Eigen::SparseMatrix<double> pattern_;
  Eigen::MatrixXi slots_;  ///< nodes^2 x elements: rank of a node pair in its block column, or -1
};

}  // namespace halfway::reference::fe
