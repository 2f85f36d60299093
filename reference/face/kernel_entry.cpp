#include "reference/face/kernel_entry.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace halfway::reference {
namespace {

using Quaternion = Eigen::Quaterniond;

/// About a random axis, drawn in here: after an angle that is drawn in the call.
Quaternion turn(Generator& g, double phi) { return Quaternion(Eigen::AngleAxisd(phi, g.direction())); }

Quaternion third(double sign) { return {0.5, 0.5, sign * 0.5, 0.5}; }

template <class T>
so3::Quaternion<T> unit_of(const QuaternionPose<double>& p) {
  using std::sqrt;
  const Eigen::Matrix<T, 4, 1> q = p.q.cast<T>();
  const T norm = sqrt(q.squaredNorm());
  return {q[0] / norm, Vec3<T>(q.template tail<3>() / norm)};
}

}  // namespace

Pose<Real50> exact_pose(const QuaternionPose<double>& p) {
  return {p.x.cast<Real50>(), so3::matrix(unit_of<Real50>(p))};
}

Pose<double> matrix_pose(const QuaternionPose<double>& p) { return {p.x, so3::matrix(unit_of<double>(p))}; }

Mat3<double> third_of_turn(double sign) { return third(sign).toRotationMatrix(); }

NodePair turned_pair(Generator& g, double phi, bool ends) {
  const Quaternion a = turn(g, g.uniform(0.1, 3));
  const Quaternion relative = turn(g, phi);
  const Quaternion b = ends ? a * third(1) * relative * third(-1).conjugate() : a * relative;
  const double side = g.uniform(0, 1) < 0.5 ? -1 : 1;  // both quaternions of the same rotation
  const auto unit = [](const Quaternion& q) {
    return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()).normalized();
  };
  return {unit(a), side * unit(b)};
}

}  // namespace halfway::reference
