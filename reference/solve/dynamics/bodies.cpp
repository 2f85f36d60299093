#include "reference/solve/dynamics/bodies.hpp"

#include <cmath>

namespace halfway::reference::dynamics {
namespace {

QuaternionPose<double> pose(const BodyState& s) { return {s.x, s.q.normalized()}; }

Loads angular_loads(const Vec3<double>& m_b) {
  Loads q = Loads::Zero();
  q.segment<3>(3) = -m_b;
  q.segment<3>(9) = m_b;
  return q;
}

Loads joint_loads(const Entry& entry, const JointSpec& spec, const State& s) {
  const auto a = pose(s[0]), b = pose(s[1]);
  const auto& kernel = entry.kernel.in_double;
  if (spec.kind == Kind::angular) {
    if (kernel.angular) return angular_loads(kernel.angular(spec, a, b, false).m_b);
    return angular_loads(entry.in_double.angular(spec, node_pose(s[0]), node_pose(s[1]), false).m_b);
  }
  if (kernel.point) return kernel.point(spec, a, b, false).q;
  return entry.in_double.point(spec, node_pose(s[0]), node_pose(s[1]), false).q;
}

}  // namespace

System elastic_system(const Entry& entry, const JointSpec& spec, const std::array<Body, 2>& bodies) {
  return {bodies, [&entry, &spec](const State& s) { return joint_loads(entry, spec, s); },
          [&entry, &spec](const State& s) {
            return stored_energy(entry, spec, node_pose(s[0]), node_pose(s[1]));
          }};
}

System free_system(const std::array<Body, 2>& bodies) {
  return {bodies, [](const State&) -> Loads { return Loads::Zero(); }, [](const State&) { return 0.0; }};
}

Mat3<double> orientation(const Vec4& q) {
  const Vec4 unit = q.normalized();
  return so3::matrix(so3::Quaternion<double>{unit[0], unit.tail<3>()});
}

Pose<double> node_pose(const BodyState& s) { return {s.x, orientation(s.q)}; }

Vec3<double> spin(const Body& body, const BodyState& s) {
  if (body.clamped) return Vec3<double>::Zero();
  const Mat3<double> R = orientation(s.q);
  return R * (R.transpose() * s.L).cwiseQuotient(body.inertia);
}

Vec3<double> velocity(const Body& body, const BodyState& s) {
  if (body.clamped) return Vec3<double>::Zero();
  return s.p / body.mass;
}

double kinetic_energy(const System& system, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Body& body = system.bodies[i];
    sum += state[i].p.dot(velocity(body, state[i])) / 2 + state[i].L.dot(spin(body, state[i])) / 2;
  }
  return sum;
}

double energy(const System& system, const State& state) {
  return kinetic_energy(system, state) + system.strain_energy(state);
}

Momenta momenta(const State& state) {
  return {state[0].p + state[1].p,
          state[0].L + state[1].L + state[0].x.cross(state[0].p) + state[1].x.cross(state[1].p)};
}

void set_motion(const Body& body, const Vec3<double>& v, const Vec3<double>& w, BodyState& s) {
  const Mat3<double> R = orientation(s.q);
  s.p = body.mass * v;
  s.L = R * body.inertia.cwiseProduct(R.transpose() * w);
}

double relative_angle(const JointSpec& spec, const State& state) {
  const Mat3<double> P_a = orientation(state[0].q) * spec.a.H, P_b = orientation(state[1].q) * spec.b.H;
  return so3::log<double>(P_a.transpose() * P_b).norm();
}

}  // namespace halfway::reference::dynamics
