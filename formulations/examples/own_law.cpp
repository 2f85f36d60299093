// A law of one's own: any callable from strains to stress and stiffness. Here a bump stop: k e, and beyond a
// gap g a second spring.
#include <halfway/joint.hpp>
#include <halfway/systems/potentials.hpp>

#include <cmath>
#include <iostream>

using namespace halfway;  // SI units, radians

struct BumpStop {
  double k = 1e4, stop = 1e6, gap = 0.005;  // N/m, N/m, m

  LawResponse<double, 3> operator()(const Vec3<double>& e) const {
    LawResponse<double, 3> r;
    r.stiffness.setZero();
    for (int i = 0; i < 3; ++i) {
      const double beyond = std::max(0.0, std::abs(e[i]) - gap);
      r.stress[i] = k * e[i] + std::copysign(stop * beyond, e[i]);
      r.stiffness(i, i) = k + (beyond > 0 ? stop : 0);
    }
    return r;
  }
};
static_assert(Law<BumpStop, double, 3>);

int main() {
  const Joint<Kind::linear, double, Conformal, BumpStop> stop{.law = {}};
  std::cout.precision(6);
  for (const double x : {0.004, 0.006, 0.008}) {
    const Pose<double> a, b{{x, 0, 0}, so3::exp<double>({0, 0, 0.2})};
    const NodeLoads<double> q = loads<true>(stop, a, b);
    std::cout << x << " m: " << q.q[6] << " N, " << q.tangent(6, 6) << " N/m\n";
  }
}
