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
  const Outcome<double> out = follow<kind>(internal_of(bushing, a), load, rest, 0.0, 1.0);
  if (out.status != Status::converged) return 1;
  std::cout.precision(9);
  std::cout << "rotation     " << so3::log<double>(out.b.R).transpose() << " rad\n"
            << "displacement " << (out.b.x - rest.x).transpose() << " m\n";
}
