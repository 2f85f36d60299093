#include <halfway/joint.hpp>
#include <halfway/systems/intrinsic.hpp>

#include <iostream>

int main() {
  using namespace halfway;  // SI units, radians
  const auto law = orthotropic_law<double, 6>({1e5, 2e5, 3e5, 100, 200, 300});
  const Joint<Kind::linear_angular, double, Invariant, LinearLaw<double, 6>> bushing{.law = law};
  const Pose<double> a, b{{0.001, 0, 0.002}, so3::exp<double>({0.1, 0.2, 0.3})};
  const NodeLoads<double> loads = halfway::loads<true>(bushing, a, b);
  std::cout.precision(5);
  std::cout << "force on b  " << loads.q.segment<3>(6).transpose() << " N\n"
            << "moment on b " << loads.q.segment<3>(9).transpose() << " N m\n"
            << "stiffness   " << loads.tangent.diagonal().segment<3>(6).transpose() << " N/m\n";
}
