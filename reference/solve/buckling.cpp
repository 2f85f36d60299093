#include "reference/solve/buckling.hpp"

#include "reference/numbers/zeros.hpp"
#include "reference/solve/turned_joint.hpp"

#include <Eigen/LU>

#include <numbers>

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

/// Where the sign changes; a pole ends with a determinant that has grown.
std::optional<Real50> zero_between(const Way& way, double low, double high) {
  const Real50 start = way.determinant(Real50(low));
  const auto as_before = [&](const Real50& angle) { return !opposite(way.determinant(angle), start); };
  const Real50 zero = last_where(as_before, Real50(low), Real50(high), 160);
  if (abs(way.determinant(zero)) > abs(start)) return std::nullopt;
  return zero;
}

}  // namespace

std::optional<Buckling> first_buckling(const Entry& entry, const JointSpec& spec, int axis,
                                       bool nodes_exchanged) {
  constexpr int kSteps = 3000;  // about 1 mrad: zeros of these smooth determinants lie far wider apart
  const Way way{entry, spec, axis, nodes_exchanged};
  double previous = way.determinant(0.0);
  for (int i = 1; i < kSteps; ++i) {
    const double angle = std::numbers::pi * i / kSteps;
    const double now = way.determinant(angle);
    if ((now < 0) != (previous < 0)) {
      const auto root = zero_between(way, std::numbers::pi * (i - 1) / kSteps, angle);
      if (root) return Buckling{way.at(*root).m[axis], *root};
    }
    previous = now;
  }
  return std::nullopt;
}

}  // namespace halfway::reference
