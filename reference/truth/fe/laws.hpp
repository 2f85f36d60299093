// Isotropic elastic laws at finite strain: second Piola-Kirchhoff stress S(E) and its tangent.
//
// All agree to first order (Lame constants lambda, mu) and differ from the second on, which is what
// moves xi of a body without mirror symmetry.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <array>
#include <string>

namespace halfway::reference::fe {

/// hencky: Kirchhoff stress tau = lambda tr(ln V) I + 2 mu ln V, hyperelastic.
/// cauchy_log: the same for the Cauchy stress (what Abaqus documents), tau / J: not hyperelastic, its
/// tangent is not symmetric.
/// neo_hooke: W = mu/2 (tr C - 3 - 2 ln J) + lambda/2 (ln J)^2.
/// st_venant: S = lambda tr(E) I + 2 mu E.
enum class SolidLaw { st_venant, neo_hooke, hencky, cauchy_log };
inline constexpr std::array<SolidLaw, 4> kLaws = {SolidLaw::st_venant, SolidLaw::neo_hooke, SolidLaw::hencky,
                                                  SolidLaw::cauchy_log};

const char* to_string(SolidLaw law);
/// Throws std::invalid_argument naming the value and what is allowed.
SolidLaw law_named(const std::string& name);

struct Material {
  double E;   ///< Young's modulus, Pa
  double nu;  ///< Poisson's ratio, in (-1, 0.5)
  double lambda() const { return E * nu / ((1 + nu) * (1 - 2 * nu)); }
  double mu() const { return E / (2 * (1 + nu)); }
};

/// Throws std::invalid_argument, with both values, unless E > 0 and -1 < nu < 0.5.
void check(const Material& material);

/// Symmetric tensors as vectors (11, 22, 33, 12, 23, 13); strains carry 2 E_12 and so on.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

struct LawResponse6 {
  Vec6 S;  ///< Pa
  Mat6 D;  ///< dS / dE, columns per engineering strain
};

/// E is Green's strain, given itself and not as C so that no digit of a small strain is lost.
LawResponse6 respond(SolidLaw law, const Material& material, const Mat3<double>& E);

/// Coefficients of the quadratic part of S at E = 0:
/// S_2 = [p1 tr(E)^2 + p2 tr(E^2)] I + p3 tr(E) E + p4 E^2, Pa.
using Quadratic = std::array<double, 4>;
Quadratic quadratic(SolidLaw law, const Material& material);

}  // namespace halfway::reference::fe
