// The tangent by our own dual numbers, one unknown at a time.
#include "reference/numbers/dual.hpp"
#include "bench/questions/methods/groups.hpp"
#include "bench/questions/methods/tangent.hpp"

namespace halfway::bench {
namespace {

struct ByDual {
  static constexpr const char* name = "dual";
  static constexpr double limit = kRoundingLimit;
  template <Kind>
  using Scalar = reference::Dual<double>;

  template <Kind kind, class J>
  static auto evaluate(const J& joint, const Pose<double>& a, const Pose<double>& b) {
    using D = reference::Dual<double>;
    return one_unknown_at_a_time<kind>(joint, a, b, D(0, 1), [](const D& x) { return std::pair(x.v, x.d); });
  }
};

}  // namespace

Cases dual_cases() { return tangents_by<ByDual>(); }

}  // namespace halfway::bench
