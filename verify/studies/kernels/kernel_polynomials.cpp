// Every polynomial of halfway/kernels/core/coefficients.hpp against its function at 50 digits, and the jets
// that are made of them.
//
// The functions are taken from their closed forms in sines and arctangents, the derivatives of
// h(w) = phi / sin(phi/2), w = cos(phi/2), from (1 - w^2) h_w = w h - 2 and what follows by
// differentiation. The limit is what interpolation can leave, from the function's own Chebyshev series.
#include "halfway/kernels/core/functions.hpp"
#include "reference/numbers/precision.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace halfway::verify {
namespace {

using reference::Real50;

/// A function of its variable on (0, end].
struct Function {
  const char* name;
  Real50 end;
  Real50 (*value)(const Real50& x);
};

struct Angle {
  Real50 h, h1, h2, h3;  ///< by w
};

/// t = 1 - w. At t = 1e-6 the three quotients lose 18 of the 50 digits.
Angle angle(const Real50& t) {
  const Real50 w = 1 - t, s2 = t * (2 - t), s = sqrt(s2);
  Angle a;
  a.h = 2 * atan2(s, w) / s;
  a.h1 = (w * a.h - 2) / s2;
  a.h2 = (a.h + 3 * w * a.h1) / s2;
  a.h3 = (4 * a.h1 + 5 * w * a.h2) / s2;
  return a;
}

Real50 sine(const Real50& y) {
  const Real50 x = sqrt(y);
  return (sin(x) / x - 1) / y;
}

/// d(sin(x)/x)/dy = (x cos(x) - sin(x)) / (2 x^3).
Real50 sine_1(const Real50& y) {
  const Real50 x = sqrt(y);
  return (x * cos(x) - sin(x)) / (2 * x * y);
}

Real50 arctangent(const Real50& y) { return atan(sqrt(y)) / sqrt(y); }

/// 2 sum of |a_k|, k > degree: what interpolation of that degree at Chebyshev points can leave, since
/// every T_k left out is replaced by one of the kept, of size 1 as well. For degrees up to half kNodes.
class ChebyshevTail {
 public:
  explicit ChebyshevTail(const Function& f) {
    std::vector<Real50> cosine(4 * kNodes), values(kNodes);  // of multiples of pi / (2 kNodes)
    for (int i = 0; i < 4 * kNodes; ++i) cosine[i] = cos(Real50(i) * reference::pi50() / (2 * kNodes));
    for (int j = 0; j < kNodes; ++j) values[j] = f.value(f.end * (1 + cosine[2 * j + 1]) / 2);
    for (int k = 0; k < kNodes; ++k) {
      Real50 sum(0);
      for (int j = 0; j < kNodes; ++j) sum += values[j] * cosine[k * (2 * j + 1) % (4 * kNodes)];
      coefficients_[k] = std::abs(double(2 * sum / kNodes));
    }
  }
  double beyond(int degree) const {
    double sum = 0;
    for (int k = kNodes - 1; k > degree; --k) sum += coefficients_[k];
    return 2 * sum;
  }

 private:
  static constexpr int kNodes = 60;  // 5.8^-60 = 1e-46 is left
  double coefficients_[kNodes];
};

/// Of doubles as coefficients: half an eps of the leading term and of those that cancel beside it.
constexpr double kRounded = 3e-16;

struct PolynomialErrors {
  Measurement error;
  Extent size;  ///< |f|
};

template <int count>
PolynomialErrors measured(const Function& f, const double (&c)[count]) {
  constexpr int kPoints = 300;
  PolynomialErrors worst;
  for (int i = 0; i <= kPoints; ++i) {
    // Dense at both ends, as the error's waves are; 1e-6: not 0/0.
    const double share = std::max(1e-6, (1 - std::cos(std::numbers::pi * i / kPoints)) / 2);
    const Real50 x = Real50(share) * f.end, exact = f.value(x);
    Real50 p(0);
    for (int k = count - 1; k >= 0; --k) p = p * x + Real50(c[k]);
    const double error = std::abs(double((tapped(p) - exact) / exact));
    worst.size.include(std::abs(double(exact)));
    worst.error.include(error, fmt::format("at {:.4g}", double(x)));
  }
  return worst;
}

template <int count>
void add(std::vector<Finding>& out, const Function& f, const ChebyshevTail& tail, const double (&c)[count]) {
  if constexpr (count > 1) {  // the primary template stands for a degree that there is not
    constexpr int degree = count - 1;
    const PolynomialErrors worst = measured(f, c);
    out.push_back(at_most(fmt::format("kernel_polynomials/{}/degree_{}", f.name, degree),
                          "kernel_polynomials", worst.error,
                          tail.beyond(degree) / worst.size.low() + kRounded, "relative", Oracle::closed_form,
                          "interpolation at Chebyshev points leaves at most twice the rest of the Chebyshev "
                          "series; 3e-16 for coefficients rounded to double"));
  }
}

// Every degree that the header has, up to 40.
#define HALFWAY_ADD_DEGREES(name, end, value, coefficients)         \
  [&]<int... degree>(std::integer_sequence<int, degree...>) {       \
    const Function f{name, end, value};                             \
    const ChebyshevTail tail(f);                                    \
    (add(out, f, tail, kernel::detail::coefficients<degree>), ...); \
  }                                                                 \
  (std::make_integer_sequence<int, 41>())

std::vector<Finding> polynomials() {
  std::vector<Finding> out;
  const Real50 right_angle = reference::pi50() / 2, sine_end = right_angle * right_angle;
  HALFWAY_ADD_DEGREES(
      "angle", 1, [](const Real50& t) { return angle(t).h; }, kAngle);
  HALFWAY_ADD_DEGREES(
      "angle_from_1", 1, [](const Real50& t) { return (angle(t).h - 2) / t; }, kAngleFrom1);
  HALFWAY_ADD_DEGREES(
      "angle_from_3", 1,
      [](const Real50& t) { return ((angle(t).h - 2) / t - Real50(2) / 3 - Real50(4) / 15 * t) / (t * t); },
      kAngleFrom3);
  HALFWAY_ADD_DEGREES("sine", sine_end, sine, kSine);
  HALFWAY_ADD_DEGREES("sine_1", sine_end, sine_1, kSine1);
  HALFWAY_ADD_DEGREES("arctangent", 1, arctangent, kArctangent);
  return out;
}
#undef HALFWAY_ADD_DEGREES

/// One order of the jet of a scalar: h and what of d, d1, d2 it has, in eps.
template <int order, class T>
void include_jet(const T& t, Measurement (&errors)[4]) {
  const T w = T(1) - t;
  const auto j = kernel::ExactAngle::jet<order>(kernel::HalfAngle<T>{t, w, T(1) / (T(1) + w)});
  const Angle exact = angle(Real50(t));
  const std::string at = fmt::format("order {} at {:.4g}", order, double(t));
  const T values[] = {j.h, j.d, j.d1, j.d2};
  const Real50 truth[] = {exact.h, -exact.h1 / 2, -exact.h2 / 2, -exact.h3 / 2};
  for (int k = 0; k <= order; ++k) {
    const double error = std::abs(double((tapped(Real50(values[k])) - truth[k]) / truth[k]));
    errors[k].include(error / double(std::numeric_limits<T>::epsilon()), at);
  }
}

template <class T>
void add_jets(std::vector<Finding>& out, const char* scalar) {
  Measurement errors[4];
  constexpr int kPoints = 1000;
  for (int i = 1; i <= kPoints; ++i) {
    for (const double t : {double(i) / kPoints, std::pow(1e-6, double(i) / kPoints)}) {
      include_jet<0>(T(t), errors), include_jet<1>(T(t), errors);
      include_jet<2>(T(t), errors), include_jet<3>(T(t), errors);
    }
  }
  constexpr const char* kNames[] = {"h", "d", "d1", "d2"};
  constexpr double kLimits[] = {1, 3, 5, 6};
  for (int k = 0; k < 4; ++k) {
    out.push_back(
        at_most(fmt::format("kernel_polynomials/jet/{}/{}", scalar, kNames[k]), "kernel_polynomials",
                errors[k], kLimits[k], "eps", Oracle::closed_form,
                "the last sum's rounding; derivatives have those of 1 / (1 + w) and its powers, and "
                "half the polynomial's, besides"));
  }
}

std::vector<Finding> jets() {
  std::vector<Finding> out;
  add_jets<double>(out, "double"), add_jets<float>(out, "float");
  return out;
}

}  // namespace

void kernel_polynomials(Checks& checks) {
  checks.push_back({"kernel_polynomials", "kernels", polynomials});
  checks.push_back({"kernel_polynomials/jet", "kernels", jets});
}

}  // namespace halfway::verify
