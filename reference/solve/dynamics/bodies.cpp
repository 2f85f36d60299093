#include "reference/solve/dynamics/bodies.hpp"

#include "reference/record/worst.hpp"

#include <cmath>

namespace halfway::reference::dynamics {
namespace {

QuaternionPose<double> pose(const BodyState& s) { return {s.x, s.q.normalized()}; }

using OfNodes = Eigen::Matrix<double, 12, 1>;  ///< (f_a, m_a, f_b, m_b)

OfNodes angular_loads(const Vec3<double>& m_b) {
  OfNodes q = OfNodes::Zero();
  q.segment<3>(3) = -m_b;
  q.segment<3>(9) = m_b;
  return q;
}

OfNodes joint_loads(const Entry& entry, const JointSpec& spec, const BodyState& s_a, const BodyState& s_b) {
  const auto a = pose(s_a), b = pose(s_b);
  const auto& kernel = entry.kernel.in_double;
  if (spec.kind == Kind::angular) {
    if (kernel.angular) return angular_loads(kernel.angular(spec, a, b, false).m_b);
    return angular_loads(entry.in_double.angular(spec, node_pose(s_a), node_pose(s_b), false).m_b);
  }
  if (kernel.point) return kernel.point(spec, a, b, false).q;
  return entry.in_double.point(spec, node_pose(s_a), node_pose(s_b), false).q;
}

}  // namespace

System elastic_system(const Entry& entry, const std::vector<Joint>& joints, const std::vector<Body>& bodies) {
  const auto loads = [&entry, &joints](const State& s, Loads& sum) {
    sum.setZero(6 * long(s.size()));
    for (const Joint& j : joints) {
      const OfNodes q = joint_loads(entry, j.spec, s[j.a], s[j.b]);
      sum.segment<6>(6 * long(j.a)) += q.head<6>();
      sum.segment<6>(6 * long(j.b)) += q.tail<6>();
    }
  };
  const auto strain_energy = [&entry, &joints](const State& s) {
    double sum = 0;
    for (const Joint& j : joints) sum += stored_energy(entry, j.spec, node_pose(s[j.a]), node_pose(s[j.b]));
    return sum;
  };
  return {bodies, loads, strain_energy};
}

System free_system(const std::vector<Body>& bodies) {
  return {bodies, [](const State& s, Loads& sum) { sum.setZero(6 * long(s.size())); },
          [](const State&) { return 0.0; }};
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
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = system.bodies[i];
    sum += state[i].p.dot(velocity(body, state[i])) / 2 + state[i].L.dot(spin(body, state[i])) / 2;
  }
  return sum;
}

double energy(const System& system, const State& state) {
  return kinetic_energy(system, state) + system.strain_energy(state);
}

Momenta momenta(const State& state) {
  Momenta out{Vec3<double>::Zero(), Vec3<double>::Zero()};
  for (const BodyState& s : state) out.linear += s.p, out.angular += s.L;
  for (const BodyState& s : state) out.angular += s.x.cross(s.p);
  return out;
}

void set_motion(const Body& body, const Vec3<double>& v, const Vec3<double>& w, BodyState& s) {
  const Mat3<double> R = orientation(s.q);
  s.p = body.mass * v;
  s.L = R * body.inertia.cwiseProduct(R.transpose() * w);
}

double relative_angle(const std::vector<Joint>& joints, const State& state) {
  double out = 0;
  for (const Joint& j : joints) {
    const Mat3<double> P_a = orientation(state[j.a].q) * j.spec.a.H,
                       P_b = orientation(state[j.b].q) * j.spec.b.H;
    keep_largest(out, so3::log<double>(P_a.transpose() * P_b).norm());
  }
  return out;
}

}  // namespace halfway::reference::dynamics
