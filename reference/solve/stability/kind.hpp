// The kind of an instability: small motions of a loaded node round an equilibrium.
//
// M x'' + J x = 0 in x = (dx_b, w_b), J = internal - applied tangent, M = mass matrix of the body at b. With
// mu an eigenvalue of M^-1 J the motions grow as exp(+-sqrt(-mu) t): a real mu that passes through zero is
// divergence, two real mu that meet and become complex are flutter.
// Left out: gyroscopic terms are of second order in the rate of a body at rest, and damping there is none.
// That spins are no coordinates does not matter: at an equilibrium the load that is differentiated is zero,
// so its derivative is the same in any coordinates, symmetric or not.
#pragma once

#include "halfway/rotations/scalar.hpp"
#include "reference/numbers/precision.hpp"

#include <complex>
#include <string>
#include <vector>

namespace halfway::reference {

/// The body at the loaded node: mass centre at the node.
struct BodyInertia {
  std::string name = "1:1:1";
  Vec3<double> principal{1, 1, 1};               ///< kg m^2; each at most the sum of the two others
  double mass = 1;                               ///< kg
  Mat3<double> axes = Mat3<double>::Identity();  ///< the principal axes in those of the node, one a column
};

/// mu^3 - trace mu^2 + minors mu - det, the characteristic polynomial of M^-1 J of three rotations.
template <class T>
struct Characteristic {
  T trace, minors, det;

  /// Positive: three different real roots; negative: one real root and a complex pair.
  T discriminant() const {
    return T(18) * trace * minors * det - T(4) * trace * trace * trace * det +
           trace * trace * minors * minors - T(4) * minors * minors * minors - T(27) * det * det;
  }
  /// All roots, when real, are positive: Descartes' rule.
  bool positive() const { return trace > T(0) && minors > T(0) && det > T(0); }
};

/// T is double or Real50. @param J  N m. @param R  orientation of the node, in the
/// axes of J, which turns the inertia.
template <class T>
Characteristic<T> characteristic(const Mat3<T>& J, const BodyInertia& body, const Mat3<T>& R);

enum class StabilityKind { stable, divergence, flutter, unknown };  ///< unknown: of what is no number
const char* to_string(StabilityKind kind);

/// Of three rotations by signs alone: exact where they are.
template <class T>
StabilityKind stability_kind(const Characteristic<T>& c) {
  const T d = c.discriminant();
  if (!(d == d)) return StabilityKind::unknown;
  if (d < T(0)) return StabilityKind::flutter;
  return c.positive() ? StabilityKind::stable : StabilityKind::divergence;
}

/// M for 3 rotations or (displacements, rotations), in the axes that R is given in.
Eigen::MatrixXd mass_matrix(const BodyInertia& body, const Mat3<double>& R, int unknowns);

/// The eigenvalues mu of M^-1 J, 1/s^2, smallest real part first: the independent road, in double.
std::vector<std::complex<double>> modes(const Eigen::MatrixXd& J, const Eigen::MatrixXd& M);

/// By the eigenvalues. @param rounding  an imaginary part below it, relative to the largest mu, counts as
/// none.
StabilityKind stability_kind(const std::vector<std::complex<double>>& modes, double rounding = 1e-6);

}  // namespace halfway::reference
