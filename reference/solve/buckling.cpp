#include "reference/solve/buckling.hpp"

#include "reference/solve/turned_joint.hpp"

#include <Eigen/LU>

namespace halfway::reference {
namespace {

/// The joint on its way round the axis.
struct Way {
  const Entry& entry;
  const JointSpec& spec;
  int axis;
  bool nodes_exchanged;

  template <class T>
  TurnedJoint<T> at(const T& angle) const {
    return turned_joint<T>(entry, spec, about(axis, angle), nodes_exchanged);
  }
  template <class T>
  T determinant(const T& angle) const {
    return at(angle).m_w.determinant();
  }
};

/// Bisects a sign change; a pole ends with a determinant that has grown.
std::optional<Real50> bisect(const Way& way, double low, double high) {
  Real50 a(low), b(high);
  const Real50 start = way.determinant(a);
  const bool negative = start < Real50(0);
  for (int i = 0; i < 160; ++i) {
    const Real50 middle = (a + b) / Real50(2);
    ((way.determinant(middle) < Real50(0)) == negative ? a : b) = middle;
  }
  if (abs(way.determinant(b)) > abs(start)) return std::nullopt;
  return (a + b) / Real50(2);
}

}  // namespace

std::optional<Buckling> first_buckling(const Entry& entry, const JointSpec& spec, int axis,
                                       bool nodes_exchanged) {
  constexpr int kSteps = 3000;  // about 1 mrad: zeros of these smooth determinants lie far wider apart
  const Way way{entry, spec, axis, nodes_exchanged};
  double previous = way.determinant(0.0);
  for (int i = 1; i < kSteps; ++i) {
    const double angle = 3.141592653589793 * i / kSteps;
    const double now = way.determinant(angle);
    if ((now < 0) != (previous < 0)) {
      const auto root = bisect(way, 3.141592653589793 * (i - 1) / kSteps, angle);
      if (root) return Buckling{way.at(*root).m[axis], *root};
    }
    previous = now;
  }
  return std::nullopt;
}

}  // namespace halfway::reference
