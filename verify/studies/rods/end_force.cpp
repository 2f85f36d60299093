#include "verify/studies/rods/end_force.hpp"

#include "reference/solve/path.hpp"
#include "reference/truth/rod/rod.hpp"
#include "verify/once.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace halfway::verify {
namespace {

using reference::Entry, reference::Scene;
namespace rod = reference::rod;

const Vec3<double> kBending{0.8, 1, 4};                    ///< GJ, EI2, EI3, N m^2
const Vec3<double> kStretching = {1e8, 1e8, 1e8};          ///< EA, GA2, GA3, N: slender
const Vec3<double> kDirection = Vec3<double>(-1, 0.4, 1);  ///< N, skew to every axis of the section
constexpr double kRodLength = 1;                           ///< m

/// From the tip back to where the force acts, axes of the tip's section, m.
Vec3<double> arm(Where where) { return {where == Where::tip ? 0 : -kRodLength / 2, 0, 0}; }

/// A force at an arm that turns with the tip is a force and a moment of it, which is only known with the
/// tip's rotation: repeated until that stays, each time closer by the angle.
Mat3<double> rod_tip(const Vec3<double>& force, Where where) {
  const rod::Rod straight = rod::straight(kRodLength, rod::of_stiffness(kBending, kStretching));
  Mat3<double> R = Mat3<double>::Identity();
  for (int i = 0; i < 60; ++i) {
    rod::Loads loads;
    loads.force = force;
    loads.moment = (R * arm(where)).cross(force);
    const Mat3<double> before = R;
    R = rod::solve(straight, loads).R;
    if (where == Where::tip || (R - before).norm() < 1e-13) return R;
  }
  throw std::runtime_error("the rod under a force at its middle: the moment of the force does not settle");
}

/// Theta of the rod, rad.
const Vec3<double>& truth(std::size_t i, Where where) {
  static std::array<std::array<Vec3<double>, kForces.size()>, 2> all = [] {
    std::array<std::array<Vec3<double>, kForces.size()>, 2> out;
    for (const Where w : kWhere)
      for (std::size_t j = 0; j < kForces.size(); ++j)
        out[std::size_t(w)][j] = so3::log<double>(rod_tip(kForces[j] * kDirection, w));
    return out;
  }();
  return all[std::size_t(where)][i];
}

/// Joint at mid-length: there a straight rod's bending and shearing decouple, K = (EA/L, 12 EI3/L^3, 12
/// EI2/L^3) and (GJ, EI2, EI3)/L.
Scene joint_scene(double share, Where where) {
  Scene out;
  out.joint.kind = Kind::linear_angular;
  Eigen::VectorXd k(6);
  const double cube = kRodLength * kRodLength * kRodLength;
  k << kStretching[0] / kRodLength, 1 / (cube / (12 * kBending[2]) + kRodLength / kStretching[1]),
      1 / (cube / (12 * kBending[1]) + kRodLength / kStretching[2]), kBending / kRodLength;
  out.joint.law = reference::LinearSpec{Eigen::MatrixXd(k.asDiagonal()), false};
  out.joint.length = kRodLength;
  out.joint.a.o = {kRodLength / 2, 0, 0};
  out.joint.b.o = {-kRodLength / 2, 0, 0};
  out.loads = {{reference::LoadType::fixed_force, share * kDirection, arm(where)}};
  return out;
}

ForceErrors measured(const Entry& entry, Where where) {
  ForceErrors out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Scene scene = joint_scene(kForces[i], where);
    reference::Path<double> path(scene, entry, entry.probe_xi);
    const bool there = is_equilibrium(path.advance(1).status);
    const Vec3<double> theta = so3::log<double>(path.node().R);
    out[i] = there ? (theta - truth(i, where)).norm() / truth(i, where).norm()
                   : std::numeric_limits<double>::quiet_NaN();
  }
  return out;
}

}  // namespace

const char* to_string(Where where) { return where == Where::tip ? "tip" : "middle"; }

const ForceErrors& force_errors(const Entry& entry, Where where) {
  static Once<ForceErrors, Where> once;
  return once(entry, where, [&] { return measured(entry, where); });
}

double growth(const ForceErrors& errors) {
  constexpr std::size_t last = kForces.size() - 1;
  return std::log(errors[last - 1] / errors[last]) / std::log(kForces[last - 1] / kForces[last]);
}

}  // namespace halfway::verify
