#include "reference/truth/fe/incompatible.hpp"

#include "reference/truth/fe/cholesky.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace halfway::reference::fe {
namespace {

constexpr int kNodes = 8, kModes = 13;

/// Engineering strain of the displacement gradient e_k (x) g.
Vec6 strain(int k, const Vec3<double>& g) {
  Vec6 e = Vec6::Zero();
  e[k] = g[k];
  e[3] = k == 0 ? g[1] : k == 1 ? g[0] : 0;
  e[4] = k == 1 ? g[2] : k == 2 ? g[1] : 0;
  e[5] = k == 0 ? g[2] : k == 2 ? g[0] : 0;
  return e;
}

using Nodal = Eigen::Matrix<double, 6, 3 * kNodes>;
using Internal = Eigen::Matrix<double, 6, kModes>;

Nodal nodal_strains(const Eigen::Matrix<double, 3, kNodes>& gradients) {
  Nodal B;
  for (int a = 0; a < kNodes; ++a) {
    for (int k = 0; k < 3; ++k) B.col(3 * a + k) = strain(k, gradients.col(a));
  }
  return B;
}

/// Nine modes bend: the bubbles 1 - s_i^2 times each displacement, their gradients taken with the
/// centre's Jacobian. Four swell: s_1 s_2, s_2 s_3, s_3 s_1 and s_1 s_2 s_3 times the unit strain.
/// All are divided by the volume ratio, so that their integral over the element vanishes and constant
/// stress does no work on them, whatever the shape (Taylor, Beresford & Wilson 1976; Simo & Rifai 1990).
Internal internal_strains(const Vec3<double>& s, const Mat3<double>& centre_inverse_transpose, double ratio) {
  Internal G = Internal::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3<double> gradient = -2 * s[i] / ratio * centre_inverse_transpose.col(i);
    for (int k = 0; k < 3; ++k) G.col(3 * i + k) = strain(k, gradient);
    G.col(9 + i).head<3>().setConstant(s[i] * s[(i + 1) % 3] / ratio);
  }
  G.col(12).head<3>().setConstant(s.prod() / ratio);
  return G;
}

Mat3<double> centre_jacobian(const Eigen::Matrix<double, 3, kNodes>& X, const ReferenceElement& reference) {
  Mat3<double> J = Mat3<double>::Zero();
  for (int a = 0; a < kNodes; ++a)
    J += X.col(a) * reference.nodes[std::size_t(a)].cast<double>().transpose() / 8;
  return J;
}

/// What the interior and the face (d, theta) feel of each other.
struct System {
  Eigen::SparseMatrix<double> K;                    ///< interior, lower triangle, N/m
  Eigen::Matrix<double, Eigen::Dynamic, 6> K_face;  ///< interior rows
  Mat6 face;
};

using Motion = Eigen::Matrix<double, 3 * kNodes, 6>;

/// Adds the interior's share of one element; row: of each element unknown in the interior, or negative.
void scatter(const Mat24& K, const Motion& K_motion, const std::array<int, 3 * kNodes>& row,
             std::vector<Eigen::Triplet<double>>& entries, System& out) {
  for (int i = 0; i < 3 * kNodes; ++i) {
    const int r = row[std::size_t(i)];
    if (r < 0) continue;
    out.K_face.row(r) += K_motion.row(i);
    for (int j = 0; j < 3 * kNodes; ++j) {
      const int c = row[std::size_t(j)];
      if (c >= 0 && c <= r) entries.emplace_back(r, c, K(i, j));
    }
  }
}

System assemble(const Mesh& mesh, const Material& material, const Vec3<double>& reference_point) {
  const Numbering numbering = number_nodes(mesh);
  System out;
  out.K.resize(3 * numbering.interior_count, 3 * numbering.interior_count);
  out.K_face = Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(out.K.rows(), 6);
  out.face.setZero();
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Matrix<double, 3, kNodes> X = mesh.X(Eigen::all, mesh.elements.col(e));
    Motion motion = Motion::Zero();
    std::array<int, 3 * kNodes> row;
    for (int a = 0; a < kNodes; ++a) {
      const auto node = std::size_t(mesh.elements(a, e));
      const int place = numbering.interior[node];
      for (int k = 0; k < 3; ++k) row[std::size_t(3 * a + k)] = place < 0 ? place : 3 * place + k;
      if (numbering.face[node] >= 0)
        motion.middleRows<3>(3 * a) << Mat3<double>::Identity(), -skew<double>(X.col(a) - reference_point);
    }
    const Mat24 K = incompatible_stiffness(X, material);
    const Motion K_motion = K * motion;
    out.face += motion.transpose() * K_motion;
    scatter(K, K_motion, row, entries, out);
  }
  out.K.setFromTriplets(entries.begin(), entries.end());
  return out;
}

/// K^-1 K_face of the interior.
Eigen::MatrixXd solve_interior(const System& system) {
  Cholesky cholesky;
  if (!cholesky.factorize(system.K))
    throw std::domain_error("the interior's stiffness is not positive definite: a part of the mesh is loose");
  return cholesky.solve(system.K_face);
}

}  // namespace

Mat24 incompatible_stiffness(const Eigen::Matrix<double, 3, 8>& X, const Material& material) {
  check(material);
  const ReferenceElement& reference = reference_element(ElementKind::hex8i);
  const Mat6 D = respond(SolidLaw::st_venant, material, Mat3<double>::Zero()).D;
  const Mat3<double> centre = centre_jacobian(X, reference);
  const Mat3<double> centre_inverse_transpose = centre.inverse().transpose();
  // Nodal unknowns, then internal modes.
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(24 + kModes, 24 + kModes), strains(6, 24 + kModes);
  for (std::size_t p = 0; p < reference.points.size(); ++p) {
    const Mat3<double> J = X * reference.dN[p].transpose();
    strains << nodal_strains(J.inverse().transpose() * reference.dN[p]),
        internal_strains(reference.points[p], centre_inverse_transpose,
                         J.determinant() / centre.determinant());
    const Eigen::MatrixXd stresses = reference.weights[p] * J.determinant() * D * strains;
    both.noalias() += strains.transpose() * stresses;
  }
  const Eigen::MatrixXd L = both.bottomLeftCorner(kModes, 24);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(both.bottomRightCorner(kModes, kModes));
  if (cholesky.info() != Eigen::Success)
    throw std::domain_error(
        "the internal modes of an element have no positive stiffness: its shape is degenerate");
  const Eigen::MatrixXd released = cholesky.solve(L);
  both.topLeftCorner(24, 24).noalias() -= L.transpose() * released;
  const Mat24 K = both.topLeftCorner(24, 24);
  return (K + K.transpose()) / 2;
}

Mat6 incompatible_compliance(const Mesh& mesh, const Material& material,
                             const Vec3<double>& reference_point) {
  if (mesh.element != ElementKind::hex8i)
    throw std::invalid_argument(std::string("element is \"") + to_string(mesh.element) +
                                "\"; allowed: hex8i");
  const System system = assemble(mesh, material, reference_point);
  Mat6 stiffness = system.face;
  // A single layer of elements has no interior, which CHOLMOD does not take.
  if (system.K.rows() > 0) stiffness -= system.K_face.transpose() * solve_interior(system);
  return ((stiffness + stiffness.transpose()) / 2).inverse();
}

}  // namespace halfway::reference::fe
