#include "reference/truth/rod/closed/elastica.hpp"

#include "reference/truth/rod/zero.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <numbers>

namespace halfway::reference::rod::closed {
namespace {

constexpr gsl_mode_t kMode = GSL_PREC_DOUBLE;
constexpr double kHalfPi = std::numbers::pi / 2;

/// Modulus and amplitude at the clamp: k^2 = (1 + sin theta)/2, sin(phi0) = 1/(k sqrt 2), by the tip's angle.
struct Amplitude {
  explicit Amplitude(double angle)
      : k(std::sqrt((1 + std::sin(angle)) / 2)), phi0(std::atan2(1, std::sqrt(std::sin(angle)))) {}
  double k, phi0;
};

}  // namespace

Elastica under_transverse_force(double alpha) {
  // The curvature integrates to sqrt(alpha) = K(k) - F(phi0, k).
  const auto excess = [&](double angle) {
    const Amplitude a(angle);
    return gsl_sf_ellint_Kcomp(a.k, kMode) - gsl_sf_ellint_F(a.phi0, a.k, kMode) - std::sqrt(alpha);
  };
  Elastica out{first_zero(excess, 1e-9, kHalfPi - 1e-9, 16), 0, 0};
  const Amplitude a(out.angle);
  const double E = gsl_sf_ellint_Ecomp(a.k, kMode) - gsl_sf_ellint_E(a.phi0, a.k, kMode);
  out.x = std::sqrt(2 * std::sin(out.angle) / alpha);
  out.y = 1 - 2 * E / std::sqrt(alpha);
  return out;
}

Elastica under_thrust(double alpha) {
  // sqrt(alpha) = K(k), k = sin(theta/2).
  const auto excess = [&](double half) {
    return gsl_sf_ellint_Kcomp(std::sin(half), kMode) - std::sqrt(alpha);
  };
  const double half = first_zero(excess, 0, kHalfPi - 1e-9, 16), k = std::sin(half);
  const double K = std::sqrt(alpha);
  return {2 * half, 2 * gsl_sf_ellint_Ecomp(k, kMode) / K - 1, 2 * k / K};
}

}  // namespace halfway::reference::rod::closed
