#include "reference/truth/rod/chebyshev.hpp"

#include <cmath>
#include <numbers>

namespace halfway::reference::rod {
namespace {

/// T_k at the point i, which is cos((degree - i) pi/degree) on [-1, 1].
double polynomial(int k, int i, int degree) { return std::cos(std::numbers::pi * k * (degree - i) / degree); }

/// The integral of T_k over [-1, x]: (T_{k+1}/(k+1) - T_{k-1}/(k-1))/2 between the two, for k > 1.
double integral_of_polynomial(int k, int i, int degree) {
  const auto primitive = [&](int at) {
    if (k == 0) return polynomial(1, at, degree);
    if (k == 1) return polynomial(2, at, degree) / 4;
    return polynomial(k + 1, at, degree) / (2 * (k + 1)) - polynomial(k - 1, at, degree) / (2 * (k - 1));
  };
  return primitive(i) - primitive(0);
}

}  // namespace

ChebyshevRule chebyshev_rule(int degree) {
  ChebyshevRule out{Eigen::VectorXd(degree + 1), Eigen::MatrixXd::Zero(degree + 1, degree + 1)};
  const auto is_end = [&](int i) { return i == 0 || i == degree; };
  for (int i = 0; i <= degree; ++i) {
    const double sine = std::sin(std::numbers::pi * i / (2 * degree));
    out.points[i] = sine * sine;
    for (int j = 0; j <= degree; ++j) {
      for (int k = 0; k <= degree; ++k) {
        const double weight =
            (is_end(j) ? 0.5 : 1.) * (is_end(k) ? 0.5 : 1.) / degree;  // [0, 1]: half of 2/degree
        out.integral(i, j) += weight * polynomial(k, j, degree) * integral_of_polynomial(k, i, degree);
      }
    }
  }
  return out;
}

}  // namespace halfway::reference::rod
