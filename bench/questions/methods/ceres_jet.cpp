// The tangent by Ceres' Jet, all unknowns at once. Built where CMake finds ceres/jet.h.
#include <ceres/jet.h>

#include "bench/questions/methods/groups.hpp"
#include "bench/questions/methods/tangent.hpp"

template <int N>
struct halfway::RealDigits<ceres::Jet<double, N>> : halfway::RealDigits<double> {};

namespace halfway::bench {
namespace {

struct ByJet {
  static constexpr const char* name = "ceres_jet";
  static constexpr double limit = kRoundingLimit;
  template <Kind kind>
  using Scalar = ceres::Jet<double, unknowns(kind)>;

  template <Kind kind, class J>
  static auto evaluate(const J& joint, const Pose<double>& a, const Pose<double>& b) {
    using T = Scalar<kind>;
    using Derivatives = Eigen::Matrix<double, unknowns(kind), 1>;
    return all_unknowns_at_once<kind, T>(
        joint, a, b, [](double value, const Derivatives& d) { return T(value, d); },
        [](const T& x) { return std::pair<double, const Derivatives&>(x.a, x.v); });
  }
};

}  // namespace

Cases ceres_jet_cases() { return invariant_tangents_by<ByJet>(); }

}  // namespace halfway::bench
