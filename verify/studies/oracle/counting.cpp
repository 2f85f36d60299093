// The counting scalar against operations counted by hand, and what a joint that needs less computes.
#include "reference/numbers/counting.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

using reference::counted;
using reference::Counting;
using reference::OperationCount;

Finding equal(const std::string& name, long value, long expected, Oracle oracle) {
  return finding("counting/" + name)
      .about("counting")
      .measured(tapped(double(value)))
      .in("operations")
      .equal(double(expected), 0, "counts are whole numbers")
      .by(oracle);
}

/// One finding per sort of operation, each with the number that was counted by hand.
void compare(std::vector<Finding>& out, const std::string& name, const OperationCount& found,
             const OperationCount& by_hand) {
  const auto add = [&](const char* what, long OperationCount::*member) {
    out.push_back(equal(name + '/' + what, found.*member, by_hand.*member, Oracle::closed_form));
  };
  add("additions", &OperationCount::additions);
  add("multiplications", &OperationCount::multiplications);
  add("divisions", &OperationCount::divisions);
  add("roots", &OperationCount::roots);
  add("comparisons", &OperationCount::comparisons);
  add("functions", &OperationCount::functions);
}

/// The larger root of x^2 - 3 x + 2, clamped from below by an angle; ADL finds every function.
template <class T>
T expression(const T& a, const T& b, const T& c) {
  using std::atan2, std::fma, std::max, std::sqrt;
  const T root = (-b + sqrt(b * b - T(4) * a * c)) / (2 * a);  // 4 products, 2 sums, a root, a quotient
  return max(fma(a, root, c), atan2(b, c));                    // a product, a sum, a comparison, a function
}

std::vector<Finding> by_hand() {
  std::vector<Finding> out;
  const Mat3<Counting> A = Mat3<Counting>::Constant(2), B = Mat3<Counting>::Constant(0.5);
  const Vec3<Counting> v(1, 2, 3);
  Mat3<Counting> product;
  Counting dot, value;
  compare(out, "matrix_product", counted([&] { product = A * B; }), {.additions = 18, .multiplications = 27});
  compare(out, "dot_product", counted([&] { dot = v.dot(v); }), {.additions = 2, .multiplications = 3});
  compare(
      out, "expression", counted([&] { value = expression<Counting>(1, -3, 2); }),
      {.additions = 3, .multiplications = 5, .divisions = 1, .roots = 1, .comparisons = 1, .functions = 1});
  long inner = 0;
  const auto outer = counted([&] {
    dot += 1;
    inner = counted([&] { dot *= 2; }).flops();
  });
  compare(out, "nested", outer, {.additions = 1});
  out.push_back(equal("nested/inner", inner, 1, Oracle::closed_form));
  out.push_back(finding("counting/value")
                    .about("counting")
                    .measured(double(value) - expression<double>(1, -3, 2))
                    .equal(0, 0, "the very same operations in double: not one rounding differs")
                    .by(Oracle::independent));
  return out;
}

Pose<Counting> pose(const Vec3<double>& x, const Vec3<double>& theta) {
  return {x.cast<Counting>(), so3::exp<double>(theta).cast<Counting>()};
}

template <class F, Kind kind, bool with_tangent>
OperationCount cost(const Vec3<double>& x_b) {
  constexpr int n = strain_count(kind);
  const LinearLaw<Counting, n> law{Eigen::Matrix<Counting, n, n>::Identity()};
  const Joint<kind, Counting, F, LinearLaw<Counting, n>> joint{F{}, law, {}, {}};
  const Pose<Counting> a = pose(Vec3<double>::Constant(x_b[0]), {0.3, -0.2, 0.5});
  const Pose<Counting> b = pose(x_b, {-0.4, 0.7, 0.1});
  return counted([&] { (void)loads<with_tangent>(joint, a, b); });
}

Finding less(const std::string& name, long value, long than) {
  return finding("counting/" + name)
      .about("counting")
      .measured(tapped(double(value)))
      .in("flops")
      .at_most(double(than - 1), "a whole number below that of the dearer computation")
      .by(Oracle::independent);
}

/// What a joint does not need, it does not compute. Positions that are NaN show every operation that
/// reads one, whatever becomes of its result.
template <class F>
std::vector<Finding> needs() {
  const std::string name = F::name;
  const Vec3<double> x(0.1, -0.2, 0.3);
  const Vec3<double> poison = Vec3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto angular = cost<F, Kind::angular, false>(x), poisoned = cost<F, Kind::angular, false>(poison);
  const auto full = cost<F, Kind::linear_angular, false>(x);
  std::vector<Finding> out;
  const auto count = [&](const char* what, long value, long expected) {
    out.push_back(equal(name + '/' + what, value, expected, Oracle::independent));
  };
  count("angular/reads_no_position", poisoned.undefined, 0);
  count("angular/independent_of_x", poisoned.flops(), angular.flops());
  count("angular_tangent/reads_no_position", cost<F, Kind::angular, true>(poison).undefined, 0);
  // The other way round, so that the poison is known to work.
  const auto reads = cost<F, Kind::linear_angular, false>(poison);
  out.push_back(
      less(name + "/linear_angular/without_position", reads.flops() - reads.undefined, full.flops()));
  out.push_back(less(name + "/angular_below_linear_angular", angular.flops(), full.flops()));
  out.push_back(
      less(name + "/residual_below_tangent", full.flops(), cost<F, Kind::linear_angular, true>(x).flops()));
  return out;
}

std::vector<Finding> between_formulations() {
  const Vec3<double> x(0.1, -0.2, 0.3);
  const auto attached = cost<AttachedA, Kind::angular, false>(x);
  const auto invariant = cost<Invariant, Kind::linear_angular, false>(x);
  const auto linear = cost<AttachedA, Kind::linear, false>(x);
  return {less("attached_a_angular_below_invariant_linear_angular", attached.flops(), invariant.flops()),
          equal("attached_a/linear/rotates_nothing", linear.functions + linear.roots + linear.comparisons, 0,
                Oracle::independent)};
}

}  // namespace

void counting(Checks& checks) {
  checks.push_back({"counting/by_hand", "properties", by_hand});
  checks.push_back({"counting/attached_a", "properties", needs<AttachedA>});
  checks.push_back({"counting/invariant", "properties", needs<Invariant>});
  checks.push_back({"counting/between_formulations", "properties", between_formulations});
}

}  // namespace halfway::verify
