// The tangent by differences of the loads: what a code does that has no derivative.
//
// A step that is a rotation is a rotation matrix, so no pose is off the manifold. Where the step crosses
// phi = pi the rotation vector jumps by 2 pi, and the quotient is 2 pi / h: nothing guards against it here.
#include "bench/questions/methods/groups.hpp"
#include "bench/questions/methods/tangent.hpp"

#include <cmath>

namespace halfway::bench {
namespace {

/// Steps, m and rad, where the truncation of a quotient of functions and arguments of order one equals
/// its rounding: eps^(1/2) = 2^-26 one-sided, eps^(1/3) two-sided.
constexpr double kForwardStep = 0x1p-26;
constexpr double kCentralStep = 6.0554544523933429e-6;

/// A pose displaced by +h or -h along an unknown; the rotations of a fixed step are kept.
class Steps {
 public:
  explicit Steps(double h) : h_(h) {
    for (int axis = 0; axis < 3; ++axis) {
      forward_[axis] = so3::exp<double>(h * Vec3<double>::Unit(axis));
      backward_[axis] = forward_[axis].transpose();
    }
  }
  void displace(Pose<double>& pose, const Direction& d, bool back) const {
    if (d.spin)
      pose.R = (back ? backward_ : forward_)[d.axis] * pose.R;
    else
      pose.x[d.axis] += back ? -h_ : h_;
  }

 private:
  double h_;
  std::array<Mat3<double>, 3> forward_, backward_;
};

template <Kind kind, class J>
auto moved(const J& joint, const Pose<double>& a, const Pose<double>& b, const Steps& steps, int k,
           bool back) {
  std::array<Pose<double>, 2> nodes{a, b};
  const Direction d = direction(kind, k);
  steps.displace(nodes[d.node], d, back);
  return loads<false>(joint, nodes[0], nodes[1]);
}

template <bool central>
struct ByDifferences {
  static constexpr const char* name = central ? "central" : "forward";
  static constexpr double step = central ? kCentralStep : kForwardStep;
  /// Rounding eps/h, magnified by the stiffness' and the arms' size over the largest entry, and as much
  /// truncation.
  static constexpr double limit = 20 * kEps / step;
  template <Kind>
  using Scalar = double;

  template <Kind kind, class J>
  static auto evaluate(const J& joint, const Pose<double>& a, const Pose<double>& b) {
    static const Steps steps(step);
    Loads<kind> out = loads<false>(joint, a, b);
    for (int k = 0; k < unknowns(kind); ++k) {
      Loads<kind> ahead = moved<kind>(joint, a, b, steps, k, false);
      Loads<kind> behind = out;
      if constexpr (central) behind = moved<kind>(joint, a, b, steps, k, true);
      constexpr double span = central ? 2 * step : step;
      for (int i = 0; i < vector_of(out).size(); ++i) {
        entry(out, i, k) = (vector_of(ahead)[i] - vector_of(behind)[i]) / span;
      }
    }
    return out;
  }
};

}  // namespace

Cases forward_cases() { return tangents_by<ByDifferences<false>>(); }
Cases central_cases() { return tangents_by<ByDifferences<true>>(); }

}  // namespace halfway::bench
