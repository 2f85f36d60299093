#include "reference/truth/fe/laws.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr int kRow[6] = {0, 1, 2, 0, 1, 0}, kColumn[6] = {0, 1, 2, 1, 2, 2};

Vec6 stress_vector(const Mat3<double>& S) {
  Vec6 v;
  for (int k = 0; k < 6; ++k) v[k] = S(kRow[k], kColumn[k]);
  return v;
}

/// The symmetric tensor dE of a unit engineering strain k.
Mat3<double> unit_strain(int k) {
  Mat3<double> e = Mat3<double>::Zero();
  e(kRow[k], kColumn[k]) += 0.5;
  e(kColumn[k], kRow[k]) += 0.5;
  return e;
}

/// log1p(x) / x.
double log1p_quotient(double x) { return x == 0 ? 1 : std::log1p(x) / x; }

LawResponse6 st_venant(double lambda, double mu, const Mat3<double>& E) {
  LawResponse6 r;
  r.S = stress_vector(lambda * E.trace() * Mat3<double>::Identity() + 2 * mu * E);
  r.D = Mat6::Zero();
  r.D.topLeftCorner<3, 3>().setConstant(lambda);
  r.D.diagonal().head<3>().array() += 2 * mu;
  r.D.diagonal().tail<3>().setConstant(mu);
  return r;
}

/// S = lambda ln J C^-1 + mu T(C): the volumetric part is common, T differs.
/// dS = lambda (C^-1 : dE) C^-1 - 2 lambda ln J C^-1 dE C^-1 + mu dT.
template <class Tangent>
LawResponse6 logarithmic_volume(double lambda, double mu, double ln_J, const Mat3<double>& C_inverse,
                                const Mat3<double>& T, const Tangent& dT) {
  LawResponse6 r;
  r.S = stress_vector(lambda * ln_J * C_inverse + mu * T);
  for (int k = 0; k < 6; ++k) {
    const Mat3<double> dE = unit_strain(k);
    const Mat3<double> CdC = C_inverse * dE * C_inverse;
    const double rate = (C_inverse * dE).trace();
    r.D.col(k) = stress_vector(lambda * (rate * C_inverse - 2 * ln_J * CdC) + mu * dT(dE, CdC));
  }
  return r;
}

double ln_J(const Mat3<double>& E) {
  // det(I + 2E) - 1 from the invariants of 2E: exact for small strains.
  const Mat3<double> e = 2 * E;
  const double i1 = e.trace(), i2 = (i1 * i1 - (e * e).trace()) / 2, i3 = e.determinant();
  return std::log1p(i1 + i2 + i3) / 2;
}

LawResponse6 neo_hooke(double lambda, double mu, const Mat3<double>& E) {
  const Mat3<double> C_inverse = (Mat3<double>::Identity() + 2 * E).inverse();
  const Mat3<double> T = 2 * C_inverse * E;  // I - C^-1 without its cancellation
  return logarithmic_volume(
      lambda, mu, ln_J(E), C_inverse, T,
      [](const Mat3<double>&, const Mat3<double>& CdC) { return Mat3<double>(2 * CdC); });
}

/// T(C) = C^-1 ln C by its eigenvalues c = 1 + 2e: t(c) = ln c / c, and its derivative by the divided
/// differences t[a, b] = (log1p(d) / d - ln b) / (a b), d = (a - b) / b, free of cancellation.
LawResponse6 hencky(double lambda, double mu, const Mat3<double>& E) {
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> eigen(E);
  const Mat3<double> Q = eigen.eigenvectors();
  const Vec3<double> e = eigen.eigenvalues();
  const Vec3<double> c = (1 + 2 * e.array()).matrix();
  Vec3<double> ln_c;
  for (int i = 0; i < 3; ++i) ln_c[i] = std::log1p(2 * e[i]);
  Mat3<double> difference;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      difference(i, j) = (log1p_quotient(2 * (e[i] - e[j]) / c[j]) - ln_c[j]) / (c[i] * c[j]);
  }
  const Mat3<double> C_inverse = Q * c.cwiseInverse().asDiagonal() * Q.transpose();
  const Mat3<double> T = Q * ln_c.cwiseQuotient(c).asDiagonal() * Q.transpose();
  const auto dT = [&](const Mat3<double>& dE, const Mat3<double>&) -> Mat3<double> {
    return 2 * Q * difference.cwiseProduct(Q.transpose() * dE * Q) * Q.transpose();
  };
  return logarithmic_volume(lambda, mu, ln_c.sum() / 2, C_inverse, T, dT);
}

/// S = J S_hencky; dJ = J C^-1 : dE.
LawResponse6 cauchy_log(double lambda, double mu, const Mat3<double>& E) {
  LawResponse6 r = hencky(lambda, mu, E);
  const double J = std::exp(ln_J(E));
  const Vec6 C_inverse = stress_vector((Mat3<double>::Identity() + 2 * E).inverse());
  // One engineering shear 2 E_12 counts E_12 and E_21 once each: C^-1 : dE is the plain product.
  r.D = J * (r.D + r.S * C_inverse.transpose());
  r.S *= J;
  return r;
}

}  // namespace

const char* to_string(SolidLaw law) {
  switch (law) {
    case SolidLaw::st_venant:
      return "st_venant";
    case SolidLaw::neo_hooke:
      return "neo_hooke";
    case SolidLaw::hencky:
      return "hencky";
    default:
      return "cauchy_log";
  }
}

SolidLaw law_named(const std::string& name) {
  for (SolidLaw law : kLaws) {
    if (name == to_string(law)) return law;
  }
  throw std::invalid_argument("law is \"" + name + "\"; allowed: st_venant, neo_hooke, hencky, cauchy_log");
}

void check(const Material& material) {
  if (material.E > 0 && material.nu > -1 && material.nu < 0.5) return;
  throw std::invalid_argument("material has E = " + std::to_string(material.E) +
                              ", nu = " + std::to_string(material.nu) + "; allowed: E > 0, -1 < nu < 0.5");
}

LawResponse6 respond(SolidLaw law, const Material& material, const Mat3<double>& E) {
  const double lambda = material.lambda(), mu = material.mu();
  switch (law) {
    case SolidLaw::st_venant:
      return st_venant(lambda, mu, E);
    case SolidLaw::neo_hooke:
      return neo_hooke(lambda, mu, E);
    case SolidLaw::hencky:
      return hencky(lambda, mu, E);
    default:
      return cauchy_log(lambda, mu, E);
  }
}

// With C^-1 = I - 2E + 4E^2 - ..., ln J = tr E - tr E^2 + ..., ln C = 2E - 2E^2 + ...
Quadratic quadratic(SolidLaw law, const Material& material) {
  const double lambda = material.lambda(), mu = material.mu();
  switch (law) {
    case SolidLaw::st_venant:
      return {0, 0, 0, 0};
    case SolidLaw::neo_hooke:
      return {0, -lambda, -2 * lambda, -4 * mu};
    case SolidLaw::hencky:
      return {0, -lambda, -2 * lambda, -6 * mu};
    default:
      return {lambda, -lambda, -2 * lambda + 2 * mu, -6 * mu};  // J = 1 + tr E
  }
}

}  // namespace halfway::reference::fe
