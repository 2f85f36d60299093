// Poses that are not quite rotations, and joints far from their nodes or from the origin.
#include "reference/face/instantiations.hpp"
#include "reference/record/worst.hpp"
#include "verify/studies/limits/conditioning.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

constexpr double kStiffest = 30;  ///< of the law, N/m and N m/rad; the softest is 1
constexpr int kPoses = 4;         ///< at each distance, of which the worst counts

JointSpec joint_of(const Entry& entry, Kind kind) {
  JointSpec spec;
  spec.kind = kind;
  spec.xi = entry.probe_xi;
  const int n = strain_count(kind);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; i += 3) K.block(i, i, 3, 3) = spread_stiffness(kStiffest, true);
  spec.law = LinearSpec{K, false};
  return spec;
}

/// Forces and moments on both nodes, the worse of the two, each over its own size.
double miss(const Eigen::Matrix<Real50, 12, 1>& value, const Eigen::Matrix<Real50, 12, 1>& exact) {
  Real50 wrong[2], size[2];
  for (int i = 0; i < 12; ++i) {
    const int part = (i / 3) % 2;
    const Real50 d = value[i] - exact[i];
    wrong[part] += d * d;
    size[part] += exact[i] * exact[i];
  }
  Measurement worst;
  for (int part = 0; part < 2; ++part) {
    const bool no_such_load = size[part] == Real50(0) && wrong[part] == Real50(0);
    if (!no_such_load) worst.include(std::sqrt(double(Real50(wrong[part] / size[part]))), {});
  }
  return worst.value();
}

template <class T>
Mat3<T> polar_step(const Mat3<T>& R) {
  return (R + R.inverse().transpose()) / T(2);
}

Mat3<Real50> nearest_rotation(Mat3<Real50> R) {
  for (int i = 0; i < 6; ++i) R = polar_step(R);  // from 1e-3, squared each time: 1e-50 after five
  return R;
}

/// A matrix without any symmetry, |E| = 1.
Mat3<double> drift() {
  Mat3<double> E;
  E << 0.3, -0.7, 0.2, 0.9, 0.4, -0.5, -0.1, 0.6, -0.8;
  return E / E.norm();
}

constexpr const char* kDrifts[] = {"drift/", "drift_quaternion/", "drift_polar/"};

Mat3<Real50> treated(int how, const Mat3<Real50>& R) {
  return how == 0 ? R : how == 1 ? so3::matrix(so3::quaternion(R)) : polar_step(R);
}

/// Two nodes whose joint points are 0.1 m apart, turned by 0.5 rad.
struct Placed {
  JointSpec spec;
  QuaternionPose<double> a, b;
};

Placed placed(Generator& g, const Entry& entry, Kind kind, double length, bool offset) {
  Placed p{joint_of(entry, kind), {}, {}};
  const auto pair = turned_pair(g, 0.5, false);
  const double arm = offset ? length : 0.3;
  const Vec3<double> n(2. / 7, 3. / 7, 6. / 7), m(6. / 7, -2. / 7, 3. / 7);
  p.spec.a.o = arm * n, p.spec.b.o = arm * m;
  p.a = {(offset ? 0.2 : length) * m, pair.a};
  p.b.q = pair.b;
  const Vec3<double> strain(0.06, -0.05, 0.0625);
  p.b.x = p.a.x + matrix_pose(p.a).R * p.spec.a.o + strain - matrix_pose(p.b).R * p.spec.b.o;
  return p;
}

/// Of |K| times the strain, with the lever for the moments: along the softest axis there are fewer digits by
/// the law alone.
double distance_error(const Entry& entry, const Placed& p) {
  const auto exact = node_loads<Real50>(entry, p.spec, exact_pose(p.a), exact_pose(p.b), false);
  const auto value = node_loads<double>(entry, p.spec, matrix_pose(p.a), matrix_pose(p.b), false);
  const Eigen::Matrix<double, 12, 1> wrong =
      (value.q.template cast<Real50>() - exact.q).template cast<double>();
  const double force = kStiffest * 0.1, lever = 0.1 + p.spec.a.o.norm();
  const double moment = force * lever + (p.spec.kind == Kind::linear ? 0 : kStiffest * 0.5);
  Measurement worst;
  for (int i = 0; i < 12; i += 3)
    worst.include(wrong.segment<3>(i).norm() / (i % 6 == 0 ? force : moment), {});
  return worst.value();
}

}  // namespace

ErrorRows errors_over_drift(const Entry& entry) {
  ErrorRows rows;
  for (const Kind kind : {Kind::angular, Kind::linear_angular}) {
    const JointSpec spec = joint_of(entry, kind);
    Pose<Real50> a, b;
    a.R = so3::exp<Real50>(Vec3<Real50>(0.3, -0.8, 0.5));
    b.x = Vec3<Real50>(0.1, 0.3, -0.2);
    const Mat3<Real50> R = a.R * so3::exp<Real50>(Real50(0.1) * Vec3<Real50>(2, 3, 6));
    for (int decade = -12; decade <= -3; ++decade) {
      const double eps = std::pow(10., decade);
      const Mat3<Real50> drifted = R + (eps * drift()).cast<Real50>();
      b.R = nearest_rotation(drifted);
      const auto exact = node_loads<Real50>(entry, spec, a, b, false);
      for (int how = 0; how < 3; ++how) {
        b.R = treated(how, drifted);
        const auto value = node_loads<Real50>(entry, spec, a, b, false);
        rows.push_back({kDrifts[how] + std::string(to_string(kind)), std::string(entry.name), eps,
                        miss(value.q, exact.q)});
      }
    }
  }
  return rows;
}

ProjectionCost projection_cost() {
  const Mat3<Counting> R = so3::exp<double>(Vec3<double>(0.3, -0.8, 0.5)).cast<Counting>();
  return {counted([&] { (void)so3::matrix(so3::quaternion(R)); }), counted([&] { (void)polar_step(R); })};
}

ErrorRows errors_over_distance(const Entry& entry) {
  ErrorRows rows;
  Generator g(77);
  for (const Kind kind : {Kind::linear, Kind::linear_angular}) {
    for (const bool offset : {false, true}) {
      const std::string series = std::string(offset ? "offset/" : "distance/") + to_string(kind);
      for (int decade = -9; decade <= 9; ++decade) {
        const double length = std::pow(10., decade);
        Measurement worst;
        for (int i = 0; i < kPoses; ++i)
          worst.include(distance_error(entry, placed(g, entry, kind, length, offset)), {});
        rows.push_back({series, std::string(entry.name), length, worst.value()});
      }
    }
  }
  return rows;
}

}  // namespace halfway::reference
