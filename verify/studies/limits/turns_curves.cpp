#include "halfway/joint/unwrapped.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "halfway/systems/potentials.hpp"
#include "reference/face/instantiations.hpp"
#include "verify/studies/limits/turns.hpp"

#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kPointsPerTurn = 120;
constexpr double kBeside = 1e-6;  ///< rad, on both sides of a multiple of pi, where lines break

Vec3<double> axis() { return turn_axis(0).cast<double>(); }
Mat3<double> stiffness() {
  return Vec3<double>(kTurnStiffness[0], kTurnStiffness[1], kTurnStiffness[2]).asDiagonal();
}

/// Angles from 0 to `last` multiples of pi; a multiple of pi itself is replaced by two beside it.
std::vector<double> angles(int last) {
  std::vector<double> out;
  for (int i = 0; i <= last * kPointsPerTurn / 2; ++i) {
    const double phi = 2 * kPi * i / kPointsPerTurn;
    if (i == 0 || i % (kPointsPerTurn / 2) != 0) {
      out.push_back(phi);
      continue;
    }
    out.push_back(phi - kBeside);
    if (i < last * kPointsPerTurn / 2) out.push_back(phi + kBeside);
  }
  return out;
}

template <class F>
TurnCurve unwrapped_curve(const F& formulation) {
  TurnCurve out{F::name, true, angles(3)};
  const LinearLaw<double, 3> law{stiffness()};
  const double unit = axis().dot(stiffness() * axis());
  UnwrappedRotation<double> path;
  for (const double phi : out.phi) {
    const auto wrapped = relative_motion<double>(so3::exp<double>(phi * axis()), Vec3<double>::Zero());
    const auto step = path.tried(wrapped.q);
    path.commit(step);
    const auto motion = unwrapped_motion(wrapped, step);
    out.moment.push_back(axis().dot(formulation.template angular<false>(motion, law).m) / unit);
  }
  return out;
}

}  // namespace

TurnCurve turn_curve(const Entry& entry) {
  TurnCurve out{std::string(entry.name), false, angles(2)};
  const double unit = axis().dot(stiffness() * axis());
  for (const double phi : out.phi) {
    Pose<double> b;
    b.R = so3::exp<double>(phi * axis());
    out.moment.push_back(axis().dot(entry.in_double.angular(turn_joint(entry), {}, b, false).m_b) / unit);
  }
  return out;
}

std::vector<TurnCurve> unwrapped_curves() {
  return {unwrapped_curve(AttachedA{}), unwrapped_curve(Invariant{}), unwrapped_curve(Potential{}),
          unwrapped_curve(Conformal{})};
}

}  // namespace halfway::reference
