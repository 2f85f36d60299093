// Where three turns one after another lose an axis. No formulation is asked whether it counts Euler angles:
// each is brought near the lock of each sequence, and those whose tangent grows have it.
#include "reference/face/instantiations.hpp"
#include "verify/once.hpp"
#include "verify/studies/limits/turns.hpp"

#include <cmath>

namespace halfway::reference {
namespace {

Mat3<Real50> before_lock(const Sequence& s, const Real50& distance) {
  const auto turn = [](int axis, const Real50& angle) {
    return so3::exp<Real50>(angle * Vec3<Real50>::Unit(axis));
  };
  const Real50 middle = pi50() / Real50(2) - distance;
  return turn(s.i, Real50("0.4")) * turn(s.j, middle) * turn(s.k, Real50("-0.7"));
}

AngularLoads<Real50> exact(const Entry& entry, const Mat3<Real50>& R) {
  return entry.in_real50.angular(turn_joint(entry), {}, {Vec3<Real50>::Zero(), R}, true);
}

/// Of the loads in double, from the rounded matrices of both nodes at a generic orientation.
double error_in_double(const Entry& entry, const Mat3<Real50>& R) {
  Pose<Real50> a, b;
  a.R = so3::exp<Real50>(Vec3<Real50>(0.3, -0.8, 0.5));
  b.R = a.R * R;
  const JointSpec joint = turn_joint(entry);
  const Vec3<double> m = entry.in_double.angular(joint, cast<double>(a), cast<double>(b), false).m_b;
  const Vec3<Real50> expected = entry.in_real50.angular(joint, a, b, false).m_b;
  return double(Real50((m.cast<Real50>() - expected).norm() / expected.norm()));
}

/// The largest distance at which the error exceeds `limit`; 0: none.
double lost_at(const Gimbal& g, double limit) {
  for (std::size_t i = 0; i < g.distance.size(); ++i) {
    if (!(g.error[i] <= limit)) return g.distance[i];
  }
  return 0;
}

std::vector<Gimbal> found(const Entry& entry) {
  std::vector<Gimbal> out;
  for (const Sequence& s : kSequences) {
    const AngularLoads<Real50> far = exact(entry, before_lock(s, Real50("1e-8")));
    const AngularLoads<Real50> near = exact(entry, before_lock(s, Real50("1e-10")));
    const auto growth = [](const auto& a, const auto& b) {
      return std::log10(double(Real50(b.norm() / a.norm()))) / 2;
    };
    Gimbal g{std::string(entry.name), sequence_name(s), growth(far.m_b, near.m_b),
             growth(far.m_b_wb, near.m_b_wb)};
    if (g.tangent_order <= 0.5 && g.load_order <= 0.5)
      continue;                                          // what is no number has not been seen to stay
    for (int quarter = -4; quarter >= -64; --quarter) {  // of a decade: 0.1 to 1e-16 rad
      g.distance.push_back(std::pow(10., quarter / 4.));
      g.error.push_back(error_in_double(entry, before_lock(s, Real50(g.distance.back()))));
    }
    g.lost_1e6 = lost_at(g, 1e-6);
    g.lost_1e3 = lost_at(g, 1e-3);
    out.push_back(g);
  }
  return out;
}

}  // namespace

std::string sequence_name(const Sequence& s) {
  return std::to_string(s.i + 1) + std::to_string(s.j + 1) + std::to_string(s.k + 1);
}

const std::vector<Gimbal>& gimbal_locks(const Entry& entry) {
  static verify::Once<std::vector<Gimbal>> known;
  return known(entry, [&] { return found(entry); });
}

}  // namespace halfway::reference
