#include "reference/identify/model.hpp"

#include "halfway/rotations/so3.hpp"

#include <algorithm>

namespace halfway::reference::identify {
namespace {

/// (f at the joint point, m about it) of the terms of second order, joint axes; p, theta in joint axes.
Vec6 extra_stress(const Model& model, const Vec3<double>& p, const Vec3<double>& theta) {
  const Vec3<double> products(theta[1] * theta[2], theta[2] * theta[0], theta[0] * theta[1]);
  const Vec3<double> Kp = model.K_u * p, eta = model.bending.cwiseProduct(theta);
  const Vec3<double> by_theta = model.cubic * products - model.bending.cwiseProduct(p.cross(Kp));
  Vec6 out;
  // The moment works on the spin: dU = (dU/dtheta) Gamma^-1 spin.
  out << -(Kp.cross(eta) + model.K_u * eta.cross(p)),
      so3::gamma_inverse<double>(theta).transpose() * by_theta + model.pair.cwiseProduct(products);
  return out;
}

Vec6 extra_loads(const Model& model, const Vec6& motion) {
  const Mat3<double>& H = model.spec.a.H;
  const Vec3<double> theta = motion.tail<3>();
  const Vec3<double> arm = so3::exp<double>(theta) * model.spec.b.o;
  const Vec3<double> p = motion.head<3>() + arm - model.spec.a.o;
  const Vec6 stress = extra_stress(model, H.transpose() * p, H.transpose() * theta);
  const Vec3<double> f = H * stress.head<3>(), m = H * stress.tail<3>();
  Vec6 out;
  out << f, m + arm.cross(f);
  return out;
}

bool has_extra(const Model& model) {
  return !model.pair.isZero(0) || model.cubic != 0 || !model.bending.isZero(0);
}

/// By central differences: they are polynomials of low degree, and steer Newton alone.
void add_extra(const Model& model, const Vec6& motion, bool with_derivative, Loads& out) {
  if (!has_extra(model)) return;
  out.q += extra_loads(model, motion);
  if (!with_derivative) return;
  const double length = std::max(model.spec.b.o.norm(), motion.head<3>().norm()) + 1e-12;
  for (int j = 0; j < 6; ++j) {
    const double h = 1e-5 * (j < 3 ? length : 1);
    Vec6 step = Vec6::Zero();
    step[j] = h;
    out.by_motion.col(j) += (extra_loads(model, motion + step) - extra_loads(model, motion - step)) / (2 * h);
  }
}

Eigen::MatrixXd stiffness(const Frame& frame, const JointValues& v) {
  if (frame.kind == Kind::angular) return v.angular.asDiagonal();
  const Mat3<double> K_u = v.E * v.linear.asDiagonal() * v.E.transpose();
  if (frame.kind == Kind::linear) return K_u;
  Mat6 K = Mat6::Zero();
  if (v.S.isZero(0)) {
    K.topLeftCorner<3, 3>() = K_u;
    K.bottomRightCorner<3, 3>() = v.angular.asDiagonal();
    return (K + K.transpose()) / 2;
  }
  // The inverse of [[F_u + S F S, -S F], [-F S, F]], F = F_psi: the blocks of a Schur complement.
  const Mat3<double> SK = v.S * K_u;
  K.topLeftCorner<3, 3>() = K_u;
  K.bottomLeftCorner<3, 3>() = SK;
  K.topRightCorner<3, 3>() = SK.transpose();
  K.bottomRightCorner<3, 3>() = Mat3<double>(v.angular.asDiagonal()) + SK * v.S;
  return (K + K.transpose()) / 2;
}

/// Curves along the axes take the diagonal alone: where there are cubes no coupling is asked for.
LawSpec law_of(const Frame& frame, const JointValues& v) {
  if (v.angular_cube.isZero(0) && v.linear_cube.isZero(0)) return LinearSpec{stiffness(frame, v), false};
  const int n = strain_count(frame.kind);
  PolynomialSpec law{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd::Zero(n)};
  if (frame.kind == Kind::linear_angular) {
    law.k1 << v.linear, v.angular;
    law.k3 << v.linear_cube, v.angular_cube;
  } else {
    law.k1 = frame.kind == Kind::linear ? v.linear : v.angular;
    law.k3 = frame.kind == Kind::linear ? v.linear_cube : v.angular_cube;
  }
  return law;
}

}  // namespace

Unknowns no_unknowns() {
  Unknowns p = Unknowns::Zero();
  p.segment<3>(kXiAngular).setConstant(0.5);
  p.segment<3>(kXiLinear).setConstant(0.5);
  return p;
}

JointValues values_of(const Frame& frame, const Unknowns& p) {
  JointValues v;
  const auto three = [&](int place) -> Vec3<double> { return p.segment<3>(place); };
  v.angular = frame.angular.cwiseProduct(three(kAngularStiffness).array().exp().matrix());
  v.linear = frame.linear.cwiseProduct(three(kLinearStiffness).array().exp().matrix());
  v.H = frame.H * so3::exp<double>(three(kAngularAxes));
  v.E = frame.E * so3::exp<double>(three(kLinearAxes));
  const auto S = p.segment<6>(kCoupling);
  v.S << S[0], S[5], S[4], S[5], S[1], S[3], S[4], S[3], S[2];
  v.S *= frame.length;
  v.point = frame.length * three(kJointPoint);
  v.xi_angular = three(kXiAngular);
  v.xi_linear = three(kXiLinear);
  v.cubic = p[kCubic] * v.angular.mean();
  v.angular_cube = v.angular.cwiseProduct(three(kAngularCube)) / (frame.turn * frame.turn);
  v.linear_cube = v.linear.cwiseProduct(three(kLinearCube)) / (frame.reach * frame.reach);
  return v;
}

JointSpec joint_spec(const Frame& frame, const JointValues& v) {
  JointSpec spec;
  spec.kind = frame.kind;
  spec.law = law_of(frame, v);
  if (frame.kind != Kind::linear)
    spec.a.H = spec.b.H = v.H;
  else if (!v.linear_cube.isZero(0))
    spec.a.H = spec.b.H = v.E;
  if (frame.kind == Kind::linear_angular) spec.a.o = spec.b.o = v.point;
  return spec;
}

Model second_order_model(const Frame& frame, const JointValues& v) {
  const bool is_one = (v.xi_angular.array() == v.xi_angular[0]).all();
  const double base = v.cubic != 0 ? 0.5 : is_one ? v.xi_angular[0] : std::clamp(v.xi_angular.mean(), 0., 1.);
  Model out;
  out.entry = find_formulation(v.cubic != 0 ? "potential" : base == 0.5 ? "invariant" : "intrinsic");
  out.spec = joint_spec(frame, v);
  out.spec.xi = base;
  out.cubic = v.cubic;
  if (frame.kind == Kind::linear) return out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (v.cubic == 0) out.pair[i] = (v.xi_angular[i] - base) * (v.angular[k] - v.angular[j]);
  }
  if (frame.kind == Kind::linear_angular) {
    out.bending = v.xi_linear.array() - base;
    out.K_u = v.E * v.linear.asDiagonal() * v.E.transpose();
  }
  return out;
}

Model catalog_model(const Entry& entry, const Frame& frame, const JointValues& v) {
  Model out;
  out.entry = &entry;
  out.spec = joint_spec(frame, v);
  out.spec.xi = v.xi_angular[0];
  return out;
}

Loads loads_at(const Model& model, const Vec6& motion, bool with_derivative) {
  const Vec3<double> theta = motion.tail<3>();
  const Pose<double> a, b{motion.head<3>(), so3::exp<double>(theta)};
  const NodeLoads<double> loads = node_loads<double>(*model.entry, model.spec, a, b, with_derivative);
  Loads out{loads.q.tail<6>(), Mat6::Zero()};
  if (with_derivative) {
    out.by_motion = loads.tangent.bottomRightCorner<6, 6>();
    out.by_motion.rightCols<3>() *= so3::gamma<double>(theta);
  }
  add_extra(model, motion, with_derivative, out);
  return out;
}

}  // namespace halfway::reference::identify
