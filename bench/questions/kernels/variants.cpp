// What each digit costs: the invariant angular kernel with cheaper angles, dearer differences, in float;
// and what joints without ends save.
#include "bench/questions/kernels/kernel_case.hpp"

#include "halfway/kernels/compensated.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/fasse.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "halfway/systems/jointc.hpp"

#include <cmath>

namespace halfway::bench {

Cases kernel_variant_cases();

namespace {

using Shared = std::shared_ptr<const Inputs>;

template <class F, Kind kind, class T, class Accuracy, class E = kernel::Ends<T>>
void add(Cases& cases, const Shared& in, const std::string& variant, const Tolerance& tolerance) {
  cases.push_back(kernel_case<F, kind, false, T, Accuracy, E>(in, variant, tolerance));
  cases.push_back(kernel_case<F, kind, true, T, Accuracy, E>(in, variant, tolerance));
}

/// The invariant angular joint with another angle.
template <class Angle>
void add_angle(Cases& cases, const Shared& in, const std::string& variant, double approximation) {
  using With = kernel::Accuracy<Angle>;
  add<Invariant, Kind::angular, double, With>(cases, in, variant, {.approximation = approximation});
}

/// Interpolated at Chebyshev points: the angle's relative error is about 5.8^-degree / 5 at any phi;
/// its derivative in the tangent loses 2 degree^2 of it at the end of the interval, rarely more than 50.
template <int degree>
void add_polynomial(Cases& cases, const Shared& in) {
  const double error = std::pow(5.8, -degree) / 5;
  add_angle<kernel::PolynomialAngle<degree>>(cases, in, "log_" + std::to_string(degree), 50 * error);
}

/// Terms at phi = 0: at the 3 rad of the timed poses the first term left out, which is at most
/// a(terms) u^terms, u = sin(phi/4)^2, with a(1) = 2/3, and with a derivative larger by 1/u.
template <int terms>
void add_small(Cases& cases, const Shared& in) {
  const double u = std::pow(std::sin(3. / 4), 2);
  const double rest = 2. / 3 * std::pow(u, terms) / (1 - u);
  add_angle<kernel::SmallAngle<terms>>(cases, in, "order_" + std::to_string(terms), 4 * rest / u);
}

/// Joint points and frames at the nodes: fewer operations.
template <class F, Kind kind, class Accuracy = kernel::Accuracy<>>
void add_bare(Cases& cases, const std::string& variant = "no_ends") {
  const auto in = std::make_shared<const Inputs>(inputs_of<F>(kind, false));
  add<F, kind, double, Accuracy, kernel::NoEnds>(cases, in, variant, {});
}

}  // namespace

Cases kernel_variant_cases() {
  Cases cases;
  const auto in = std::make_shared<const Inputs>(inputs_of<Invariant>(Kind::angular));
  add_small<1>(cases, in), add_small<2>(cases, in), add_small<3>(cases, in);
  add_polynomial<4>(cases, in), add_polynomial<8>(cases, in), add_polynomial<12>(cases, in);
  add_polynomial<18>(cases, in);
  add_bare<Invariant, Kind::angular, kernel::Accuracy<kernel::ExactAngle, kernel::Compensated>>(
      cases, "compensated");
  const Tolerance single{.eps = std::numeric_limits<float>::epsilon()};
  add<Invariant, Kind::angular, float, kernel::Accuracy<>>(cases, in, "", single);
  const auto point = std::make_shared<const Inputs>(inputs_of<Invariant>(Kind::linear_angular));
  add<Invariant, Kind::linear_angular, float, kernel::Accuracy<>>(cases, point, "", single);
  add_bare<AttachedA, Kind::angular>(cases), add_bare<Invariant, Kind::angular>(cases);
  add_bare<Intrinsic, Kind::angular>(cases), add_bare<Jointc, Kind::angular>(cases);
  add_bare<Fasse, Kind::angular>(cases);
  add_bare<AttachedA, Kind::linear>(cases), add_bare<Invariant, Kind::linear>(cases);
  add_bare<Intrinsic, Kind::linear>(cases), add_bare<Invariant, Kind::linear_angular>(cases);
  return cases;
}

}  // namespace halfway::bench
