#include "verify/poles.hpp"

namespace halfway::verify {

bool near_pole(const Entry& entry, const JointSpec& spec, const Pose<Real50>& a, const Pose<Real50>& b) {
  using Dual = reference::Dual<Real50>;
  if (spec.kind == Kind::linear) return false;
  const Pose<Dual> fixed = reference::cast<Dual>(a);
  for (int axis = 0; axis < 3; ++axis) {
    const Mat3<Real50> rate = skew<Real50>(Vec3<Real50>::Unit(axis)) * b.R;
    Pose<Dual> turning = reference::cast<Dual>(b);
    for (int i = 0; i < 9; ++i) turning.R(i).d = rate(i);
    const auto strain = entry.in_dual50.strain(spec, fixed, turning);
    double squared = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = double(strain[strain.size() - 3 + i].d);
      squared += d * d;
    }
    if (!(squared <= kLargestCondition * kLargestCondition)) return true;
  }
  return false;
}

}  // namespace halfway::verify
