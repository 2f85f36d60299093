// The tangent that the joint itself offers.
#include "bench/questions/methods/groups.hpp"
#include "bench/questions/methods/tangent.hpp"

namespace halfway::bench {
namespace {

struct Analytic {
  static constexpr const char* name = "analytic";
  static constexpr double limit = kRoundingLimit;
  template <Kind>
  using Scalar = double;

  template <Kind, class J>
  static auto evaluate(const J& joint, const Pose<double>& a, const Pose<double>& b) {
    return loads<true>(joint, a, b);
  }
};

}  // namespace

Cases analytic_cases() { return tangents_by<Analytic>(); }

}  // namespace halfway::bench
