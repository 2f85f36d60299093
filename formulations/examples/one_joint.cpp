// One bushing between two bodies: loads on both, and how they change.
#include <halfway/joint.hpp>
#include <halfway/systems/potentials.hpp>

#include <iostream>

using namespace halfway;  // SI units, radians

int main() {
  // The joint point sits 0.2 m along x of body a and -0.2 m along x of body b, its axes are turned about z.
  const Mat3<double> H = so3::exp<double>({0, 0, 0.5});
  const JointEnd<double> end_a{{0.2, 0, 0}, H}, end_b{{-0.2, 0, 0}, H};
  const auto law = orthotropic_law<double, 6>({1e5, 2e5, 3e5, 100, 200, 300});  // N/m, N m/rad
  const Joint<Kind::linear_angular, double, Conformal, LinearLaw<double, 6>> bushing{
      .law = law, .a = end_a, .b = end_b};

  const Pose<double> a, b{{0.401, 0.006, -0.002}, so3::exp<double>({0.01, 0.02, 0.03})};
  const NodeLoads<double> q = loads<true>(bushing, a, b);

  // q = dU/dx: internal loads. A body of mass m moves by m x'' = applied - q.
  std::cout.precision(6);
  std::cout << "force on a  " << q.q.segment<3>(0).transpose() << " N\n"
            << "moment on a " << q.q.segment<3>(3).transpose() << " N m\n"
            << "force on b  " << q.q.segment<3>(6).transpose() << " N\n"
            << "moment on b " << q.q.segment<3>(9).transpose() << " N m\n"
            << "energy      " << law.energy(strain(bushing, a, b)) << " J\n"
            << "d f_b/d x_b " << q.tangent.diagonal().segment<3>(6).transpose() << " N/m\n";
}
