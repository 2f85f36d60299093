#include "reference/numbers/piecewise.hpp"

#include <gsl/gsl_interp.h>

#include <memory>

namespace halfway::reference {
namespace {

const gsl_interp_type* gsl_type(Interpolation method) {
  switch (method) {
    case Interpolation::akima:
      return gsl_interp_akima;
    case Interpolation::monotone:
      return gsl_interp_steffen;
    default:
      return gsl_interp_linear;
  }
}

/// Slopes at the points; of a polygon those to the right, of its last point to the left.
std::vector<double> slopes_at(std::span<const double> x, std::span<const double> y, Interpolation method) {
  const std::unique_ptr<gsl_interp, void (*)(gsl_interp*)> curve(gsl_interp_alloc(gsl_type(method), x.size()),
                                                                 &gsl_interp_free);
  gsl_interp_init(curve.get(), x.data(), y.data(), x.size());
  std::vector<double> out;
  for (const double at : x)
    out.push_back(gsl_interp_eval_deriv(curve.get(), x.data(), y.data(), at, nullptr));
  return out;
}

/// The cubic of values and slopes at both ends, from the left one.
PiecewisePolynomial::Piece hermite(double h, double y0, double y1, double d0, double d1) {
  const double chord = (y1 - y0) / h;
  return {y0, d0, (3 * chord - 2 * d0 - d1) / h, (d0 + d1 - 2 * chord) / (h * h)};
}

}  // namespace

std::size_t fewest_points(Interpolation method) { return gsl_interp_type_min_size(gsl_type(method)); }

PiecewisePolynomial interpolated(std::span<const double> x, std::span<const double> y, Interpolation method) {
  const std::vector<double> slopes = slopes_at(x, y, method);
  PiecewisePolynomial out;
  out.interpolation = method;
  out.knots.assign(x.begin(), x.end());
  out.pieces = {{y.front(), slopes.front()}};
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const bool is_straight = method == Interpolation::linear;
    out.pieces.push_back(is_straight ? PiecewisePolynomial::Piece{y[i], slopes[i]}
                                     : hermite(x[i + 1] - x[i], y[i], y[i + 1], slopes[i], slopes[i + 1]));
  }
  out.pieces.push_back({y.back(), slopes.back()});
  return out;
}

}  // namespace halfway::reference
