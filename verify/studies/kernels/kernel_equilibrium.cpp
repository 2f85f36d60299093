// Newton on a kernel: the equilibria of C1 against those of the transcription at 50 digits, and a load
// that no equilibrium carries.
#include "halfway/kernels/equilibrium.hpp"

#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "halfway/systems/jointc.hpp"
#include "reference/face/kernel_instance.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

using kernel::Quat;
using kernel::V3;

constexpr Quat<double> kOne{1, {0, 0, 0}};

template <class F>
auto angular_joint(const Eigen::MatrixXd& stiffness) {
  reference::JointSpec spec;
  spec.law = reference::LinearSpec{stiffness, false};
  return reference::make_kernel_joint<F, Kind::angular, double, kernel::NoEnds>(F{}, spec);
}

Vec3<double> rotation_vector(const Quat<double>& q) {
  return so3::log<double>(so3::matrix(so3::Quaternion<double>{q.w, {q.v.x, q.v.y, q.v.z}}));
}

/// Largest error of theta over load factors 1 ... 300 of C1, relative to theta: 3 rad in the end.
template <class F>
std::vector<Finding> c1_extended() {
  const reference::Scene& c1 = scene("c1_skewed_torque");
  const auto joint = angular_joint<F>(std::get<reference::LinearSpec>(c1.joint.law).matrix);
  const Vec3<double> moment = c1.loads.front().value;
  Measurement worst;
  Quat<double> b = kOne;
  for (double factor : {1.0, 10.0, 50.0, 100.0, 200.0, 300.0}) {
    const auto found = kernel::solve(joint, kOne, b, reference::plain<double>(Vec3<double>(factor * moment)));
    const Vec3<double> exact =
        rotation_at(c1.name, *reference::find_formulation(F::name), 0.5, factor).template cast<double>();
    const double error =
        found.iterations == 0 ? std::nan("") : (rotation_vector(found.b) - exact).norm() / exact.norm();
    worst.include(error, fmt::format("load factor {:g}", factor));
    b = found.b;
  }
  return {
      finding(fmt::format("kernel_equilibrium/c1/{}", F::name))
          .of(F::name)
          .about("kernel_equilibrium")
          .measured(worst)
          .in("relative")
          .at_most(1e-13,
                   "loads to 5e-15 of |K||strain| = 100 N m/rad * phi, on the softest direction of 1 N m/rad "
                   "at the largest share of the loads: 100 * 5e-15 / 5 at most seen by theta")
          .by(Oracle::independent)};
}

/// m = k sin(phi) cos(phi) carries no more than k/2 [53]: no iteration count is returned beyond.
std::vector<Finding> beyond_reach() {
  const auto joint = angular_joint<Jointc>(Eigen::Vector3d(1, 1, 1).asDiagonal());
  const int wrong = kernel::solve(joint, kOne, kOne, V3<double>{0.51, 0, 0}).iterations +
                    (kernel::solve(joint, kOne, kOne, V3<double>{0.49, 0, 0}).iterations == 0);
  return {finding("kernel_equilibrium/beyond_reach/iterations")
              .of("jointc")
              .about("kernel_equilibrium")
              .measured(tapped(double(wrong)))
              .equal(0, 0,
                     "0 iterations say that nothing converged: 0.51 k is more than the law can carry, 0.49 k "
                     "is not")
              .by(Oracle::closed_form)};
}

}  // namespace

void kernel_equilibrium(Checks& checks) {
  checks.push_back({"kernel_equilibrium/c1/attached_a", "kernels", c1_extended<AttachedA>});
  checks.push_back({"kernel_equilibrium/c1/attached_b", "kernels", c1_extended<AttachedB>});
  checks.push_back({"kernel_equilibrium/c1/invariant", "kernels", c1_extended<Invariant>});
  checks.push_back({"kernel_equilibrium/beyond_reach", "kernels", beyond_reach});
}

}  // namespace halfway::verify
