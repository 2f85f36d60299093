// A joint behind `halfway check`, here one of Halfway's own library.
#include "protocol.hpp"

#include <halfway/joint.hpp>
#include <halfway/systems/intrinsic.hpp>

using namespace halfway;  // SI units, radians

Vec3<double> vector(const std::array<double, 3>& v) { return Vec3<double>(v.data()); }
Mat3<double> rotation(const std::array<double, 4>& q) {
  return so3::matrix<double>({q[0], {q[1], q[2], q[3]}});
}

std::vector<double> loads_of(const check::Question& r) {
  if (r.kind != "linear_angular") throw check::Skipped("linear_angular joints alone");
  Joint<Kind::linear_angular, double, Invariant, LinearLaw<double, 6>> joint;
  for (int i = 0; i < 36; ++i) joint.law.K(i / 6, i % 6) = r.K[i / 6][i % 6];
  joint.a = {vector(r.a.o), rotation(r.a.h)}, joint.b = {vector(r.b.o), rotation(r.b.h)};
  const Pose<double> a{vector(r.a.x), rotation(r.a.q)}, b{vector(r.b.x), rotation(r.b.q)};
  const auto q = loads<false>(joint, a, b).q;  // f_a, m_a, f_b, m_b, in global axes
  return {q.begin(), q.end()};
}

int main() {
  check::serve({{"name", "invariant"}, {"kinds", {"linear_angular"}}, {"law", "full"}, {"frames", true}},
               loads_of);
}
