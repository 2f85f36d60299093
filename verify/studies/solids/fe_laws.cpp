// Material laws of the solids against their energies, by dual numbers and a matrix series: a road that
// shares neither eigenvalues nor divided differences with the laws.
#include "reference/numbers/dual.hpp"
#include "reference/numbers/precision.hpp"
#include "reference/numbers/random.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;
using reference::Real50;
using D = reference::Dual<Real50>;  // 50 digits: what is measured is the rounding of the law alone
using Mat3D = Mat3<D>;

const fe::Material kMaterial{1, 0.3};

/// ln(I + X) by its Taylor series; with |X| <= 0.3 the 80th term is below 1e-43.
Mat3D series_log(const Mat3D& X) {
  Mat3D power = X, sum = X;
  for (int k = 2; k <= 80; ++k) {
    power = -(power * X).eval();
    sum += power / D(k);
  }
  return sum;
}

/// W per unit volume, J/m^3; cauchy_log has none.
D energy(fe::SolidLaw law, const Mat3D& E) {
  const D lambda(Real50(kMaterial.lambda())), mu(Real50(kMaterial.mu()));
  if (law == fe::SolidLaw::st_venant) return lambda * E.trace() * E.trace() / D(2) + mu * (E * E).trace();
  const Mat3D ln_C = series_log(D(2) * E);
  const D ln_J = ln_C.trace() / D(2);
  const D volumetric = lambda * ln_J * ln_J / D(2);
  if (law == fe::SolidLaw::neo_hooke) return volumetric + mu * (E.trace() - ln_J);
  return volumetric + mu * (ln_C * ln_C).trace() / D(4);
}

/// The stress itself for a direction of E in the dual part: its dual part is the tangent's column.
Mat3D stress(fe::SolidLaw law, const Mat3D& E) {
  const D lambda(Real50(kMaterial.lambda())), mu(Real50(kMaterial.mu()));
  const Mat3D I = Mat3D::Identity();
  if (law == fe::SolidLaw::st_venant) return lambda * E.trace() * I + D(2) * mu * E;
  const Mat3D ln_C = series_log(D(2) * E), C = I + D(2) * E;
  const Mat3D C_inverse = C.inverse();
  const D ln_J = ln_C.trace() / D(2);
  if (law == fe::SolidLaw::neo_hooke) return mu * (I - C_inverse) + lambda * ln_J * C_inverse;
  const Mat3D hencky = C_inverse * (lambda * ln_J * I + mu * ln_C);
  return law == fe::SolidLaw::hencky ? hencky : Mat3D(sqrt(C.determinant()) * hencky);
}

constexpr int kRow[6] = {0, 1, 2, 0, 1, 0}, kColumn[6] = {0, 1, 2, 1, 2, 2};

/// E with the unit engineering strain k as its dual part.
Mat3D along(const Mat3<double>& E, int k) {
  Mat3D out = E.cast<Real50>().cast<D>();
  out(kRow[k], kColumn[k]).d += Real50(0.5);
  out(kColumn[k], kRow[k]).d += Real50(0.5);
  return out;
}

/// Strains of 1e-6 to 0.1, one of them with two equal principal values, one zero.
std::vector<Mat3<double>> strains() {
  reference::Generator g(33);
  std::vector<Mat3<double>> out = {Mat3<double>::Zero(), Vec3<double>(0.02, 0.02, -0.03).asDiagonal()};
  for (double size : {1e-6, 1e-3, 0.1}) {
    Mat3<double> m;
    for (double& x : m.reshaped()) x = g.uniform(-size, size);
    out.push_back((m + m.transpose()) / 2);
  }
  return out;
}

std::vector<Finding> law_findings(fe::SolidLaw law) {
  const std::string name = std::string("laws/") + to_string(law);
  Measurement worst_stress, worst_tangent, worst_second;
  for (const Mat3<double>& E : strains()) {
    const fe::LawResponse6 healthy = respond(law, kMaterial, E), r{tapped(healthy.S), tapped(healthy.D)};
    const double size = larger(E.norm(), 1e-300);
    const std::string at = fmt::format("|E| = {:.2g}", E.norm());
    for (int k = 0; k < 6; ++k) {
      const Mat3D dual = stress(law, along(E, k));
      if (law != fe::SolidLaw::cauchy_log)
        worst_stress.include(std::abs(double(energy(law, along(E, k)).d - Real50(r.S[k]))) / size, at);
      for (int i = 0; i < 6; ++i)
        worst_tangent.include(std::abs(double(dual(kRow[i], kColumn[i]).d - Real50(r.D(i, k)))), at);
    }
    // The quadratic part from the tangent at small strains: S_2(E, E) = d/de D(e E) E / 2.
    if (E.norm() < 0.05) continue;
    constexpr double e = 1e-5;
    fe::Vec6 engineering;
    for (int i = 0; i < 6; ++i) engineering[i] = (i < 3 ? 1 : 2) * E(kRow[i], kColumn[i]);
    const fe::Vec6 found =
        (respond(law, kMaterial, e * E).D - respond(law, kMaterial, -e * E).D) * engineering / (4 * e);
    const fe::Quadratic p = quadratic(law, kMaterial);
    const Mat3<double> I = Mat3<double>::Identity(), EE = E * E;
    const Mat3<double> second =
        (p[0] * E.trace() * E.trace() + p[1] * EE.trace()) * I + p[2] * E.trace() * E + p[3] * EE;
    for (int i = 0; i < 6; ++i)
      worst_second.include(std::abs(second(kRow[i], kColumn[i]) - found[i]) / EE.norm(), at);
  }
  std::vector<Finding> out;
  if (law != fe::SolidLaw::cauchy_log) {
    out.push_back(
        solid_finding(name + "/energy_gradient")
            .in("relative")
            .measured(worst_stress)
            .at_most(1e-13,
                     "E = 1: rounding of a few operations on numbers near 1, relative to the strain; "
                     "the energy's own derivative cancels nothing")
            .by(Oracle::independent));
  }
  out.push_back(solid_finding(name + "/tangent")
                    .in("relative")
                    .measured(worst_tangent)
                    .at_most(2e-14, "E = 1: rounding of a few operations on numbers near 1")
                    .by(Oracle::independent));
  out.push_back(
      solid_finding(name + "/quadratic_part")
          .in("relative")
          .measured(worst_second)
          .at_most(1e-9,
                   "central difference with steps of 1e-6 in strain: rounding 1e-16 / 1e-6, truncation 1e-12")
          .by(Oracle::independent));
  return out;
}

}  // namespace

void fe_laws(Checks& checks) {
  for (fe::SolidLaw law : fe::kLaws)
    checks.push_back({std::string("fe/laws/") + to_string(law), "fe", [law] { return law_findings(law); }});
}

}  // namespace halfway::verify
