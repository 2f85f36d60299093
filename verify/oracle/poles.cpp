#include "verify/oracle/poles.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

using Dual = reference::Dual<Real50>;

/// |d(angular strain)/d(spin of b)|.
Real50 rate(const Entry& entry, const JointSpec& spec, const Pose<Real50>& a, const Pose<Real50>& b) {
  const Pose<Dual> fixed = reference::cast<Dual>(a);
  Real50 squared(0);
  for (int axis = 0; axis < 3; ++axis) {
    const Mat3<Real50> turning = skew<Real50>(Vec3<Real50>::Unit(axis)) * b.R;
    Pose<Dual> moving = reference::cast<Dual>(b);
    for (int i = 0; i < 9; ++i) moving.R(i).d = turning(i);
    const auto strain = entry.in_dual50.strain(spec, fixed, moving);
    for (int i = 1; i <= 3; ++i) squared += strain[strain.size() - i].d * strain[strain.size() - i].d;
  }
  return sqrt(squared);
}

}  // namespace

double steepness(const Entry& entry, const JointSpec& spec, const Pose<Real50>& a, const Pose<Real50>& b) {
  if (spec.kind == Kind::linear) return 0;
  const Real50 here = rate(entry, spec, a, b), step(1e-18);
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    Pose<Real50> turned = b;
    turned.R = so3::exp<Real50>(step * Vec3<Real50>::Unit(axis)) * b.R;
    const double growth = double((rate(entry, spec, a, turned) - here) / (step * here));
    squared += growth * growth;
  }
  return std::sqrt(squared);
}

}  // namespace halfway::verify
