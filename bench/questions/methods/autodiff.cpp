// The tangent by Eigen's AutoDiffScalar, all unknowns at once.
#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include "bench/questions/methods/groups.hpp"
#include "bench/questions/methods/tangent.hpp"

template <class D>
struct halfway::RealDigits<Eigen::AutoDiffScalar<D>> : halfway::RealDigits<double> {};

// Eigen has no atan of it; here, where a scalar's functions are looked up.
namespace Eigen {
template <class D>
AutoDiffScalar<D> atan(const AutoDiffScalar<D>& x) {
  return {std::atan(x.value()), x.derivatives() / (1 + x.value() * x.value())};
}
}  // namespace Eigen

namespace halfway::bench {
namespace {

struct ByAutoDiff {
  static constexpr const char* name = "autodiff";
  static constexpr double limit = kRoundingLimit;
  template <Kind kind>
  using Scalar = Eigen::AutoDiffScalar<Eigen::Matrix<double, unknowns(kind), 1>>;

  template <Kind kind, class J>
  static auto evaluate(const J& joint, const Pose<double>& a, const Pose<double>& b) {
    using T = Scalar<kind>;
    using Derivatives = Eigen::Matrix<double, unknowns(kind), 1>;
    return all_unknowns_at_once<kind, T>(
        joint, a, b, [](double value, const Derivatives& d) { return T(value, d); },
        [](const T& x) { return std::pair<double, const Derivatives&>(x.value(), x.derivatives()); });
  }
};

}  // namespace

Cases autodiff_cases() { return invariant_tangents_by<ByAutoDiff>(); }

}  // namespace halfway::bench
