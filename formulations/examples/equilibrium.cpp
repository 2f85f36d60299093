// A bracket on a bushing, pulled at a lever: where it comes to rest, in double precision and at once.
#include <halfway/equilibrium.hpp>
#include <halfway/systems/intrinsic.hpp>

#include <iostream>

using namespace halfway;  // SI units, radians

int main() {
  constexpr Kind kind = Kind::linear_angular;
  const auto law = orthotropic_law<double, 6>({1e5, 1e5, 1e5, 200, 300, 400});
  const Joint<kind, double, Invariant, LinearLaw<double, 6>> bushing{.law = law, .b = {{0, -0.1, 0}}};
  const NodeLoad<double> load{.force = {0, 0, 150}, .point = {0.05, 0.1, 0}};  // global axes; axes of b

  const Pose<double> a, rest = unstrained(bushing.a, bushing.b, a);
  const Outcome<double> out = follow(bushing, a, load, Outcome<double>{}, 1.0);
  if (out.status != Status::converged) return 1;
  const Pose<double> b = node_b(bushing.a, bushing.b, a, out.joint);
  std::cout.precision(9);
  std::cout << "rotation     " << so3::log<double>(b.R).transpose() << " rad\n"
            << "displacement " << (b.x - rest.x).transpose() << " m\n";
}
