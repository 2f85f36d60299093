#include "reference/solve/buckling.hpp"

#include <Eigen/LU>

namespace halfway::reference {
namespace {

template <class T>
AngularLoads<T> turned(const Entry& entry, const JointSpec& spec, int axis, const T& angle) {
  Pose<T> b;
  b.R = so3::exp<T>(angle * Vec3<T>::Unit(axis));
  return entry.in<T>().angular(spec, Pose<T>{}, b, true);
}

template <class T>
T determinant(const Entry& entry, const JointSpec& spec, int axis, const T& angle) {
  return turned(entry, spec, axis, angle).m_b_wb.determinant();
}

/// Bisects a sign change; a pole ends with a determinant that has grown.
std::optional<Real50> bisect(const Entry& entry, const JointSpec& spec, int axis, double low, double high) {
  Real50 a(low), b(high);
  const bool negative = determinant(entry, spec, axis, a) < Real50(0);
  const Real50 scale = abs(determinant(entry, spec, axis, a));
  for (int i = 0; i < 160; ++i) {
    const Real50 middle = (a + b) / Real50(2);
    ((determinant(entry, spec, axis, middle) < Real50(0)) == negative ? a : b) = middle;
  }
  if (abs(determinant(entry, spec, axis, b)) > scale) return std::nullopt;
  return (a + b) / Real50(2);
}

}  // namespace

std::optional<Buckling> first_buckling(const Entry& entry, const JointSpec& spec, int axis) {
  constexpr int kSteps = 3000;  // about 1 mrad: zeros of these smooth determinants lie far wider apart
  double previous = determinant(entry, spec, axis, 0.0);
  for (int i = 1; i < kSteps; ++i) {
    const double angle = 3.141592653589793 * i / kSteps;
    const double now = determinant(entry, spec, axis, angle);
    if ((now < 0) != (previous < 0)) {
      const auto root = bisect(entry, spec, axis, 3.141592653589793 * (i - 1) / kSteps, angle);
      if (root) return Buckling{turned(entry, spec, axis, *root).m_b[axis], *root};
    }
    previous = now;
  }
  return std::nullopt;
}

}  // namespace halfway::reference
