// The paper's joints as one writes them down from the paper: matrices, Eigen's own rotations, no tricks.
//
// Equation numbers in brackets are the paper's. Nothing here is shared with the library but the types that
// carry poses in and loads out. Two frames: attached to node a (xi = 0) and half-way (xi = 1/2).
#pragma once

#include "halfway/joint.hpp"

#include <cmath>

namespace halfway::bench::textbook {

using Eigen::Matrix3d;
using Eigen::Vector3d;

enum class Frame { attached, halfway };

/// A linear joint or an angular one: its law's stiffness (N/m or N m/rad) and its ends.
struct Properties {
  Matrix3d K;
  JointEnd<double> a, b;
};

/// v x
inline Matrix3d cross(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// [27] in closed form.
inline Matrix3d gamma(const Vector3d& theta) {
  const double phi = theta.norm();
  if (phi == 0) return Matrix3d::Identity();
  const Matrix3d x = cross(theta);
  return Matrix3d::Identity() + (1 - std::cos(phi)) / (phi * phi) * x +
         (phi - std::sin(phi)) / (phi * phi * phi) * x * x;
}

/// What both kinds of joint need of the nodes' orientations.
struct Frames {
  Matrix3d R_a;      ///< of the joint's frame on node a
  Vector3d theta;    ///< relative rotation vector
  Matrix3d R_tilde;  ///< of the law's frame, seen from node a
  Matrix3d R_hat;    ///< of the law's frame
};

template <Frame frame>
Frames frames(const Properties& joint, const Pose<double>& a, const Pose<double>& b) {
  Frames f;
  f.R_a = a.R * joint.a.H;
  const Matrix3d R_rel = f.R_a.transpose() * b.R * joint.b.H;  // [4]
  const Eigen::AngleAxisd turn(R_rel);
  f.theta = turn.angle() * turn.axis();  // [5]
  f.R_tilde.setIdentity();
  if (frame == Frame::halfway) f.R_tilde = Eigen::AngleAxisd(turn.angle() / 2, turn.axis());  // [10, 11]
  f.R_hat = f.R_a * f.R_tilde;                                                                // [20a]
  return f;
}

/// I^, the share of node b in the spin of the law's frame [25]: [32], or zero where attached.
template <Frame frame>
Matrix3d share_of_b(const Frames& f) {
  if (frame == Frame::attached) return Matrix3d::Zero();
  return f.R_hat * (Matrix3d::Identity() + f.R_tilde).inverse() * f.R_hat.transpose();
}

template <Frame frame, bool with_tangent>
AngularLoads<double> angular(const Properties& joint, const Pose<double>& a, const Pose<double>& b) {
  const Frames f = frames<frame>(joint, a, b);
  AngularLoads<double> out;
  out.m_b = f.R_hat * joint.K * f.theta;  // [19b, 35]
  if (with_tangent) {
    const Matrix3d I_hat = share_of_b<frame>(f);
    const Matrix3d theta_w = gamma(f.theta).inverse() * f.R_a.transpose();  // [27], by w_b - w_a
    const Matrix3d material = f.R_hat * joint.K * theta_w;
    out.m_b_wb = -cross(out.m_b) * I_hat + material;  // [44] in global axes
    out.m_b_wa = -cross(out.m_b) * (Matrix3d::Identity() - I_hat) - material;
  }
  return out;
}

/// 3x12: derivative by (dx_a, w_a, dx_b, w_b).
using Rows = Eigen::Matrix<double, 3, 12>;

inline Rows rows(const Matrix3d& xa, const Matrix3d& wa, const Matrix3d& xb, const Matrix3d& wb) {
  Rows r;
  r << xa, wa, xb, wb;
  return r;
}

template <Frame frame, bool with_tangent>
NodeLoads<double> linear(const Properties& joint, const Pose<double>& a, const Pose<double>& b) {
  const Matrix3d I = Matrix3d::Identity(), O = Matrix3d::Zero();
  const Frames f = frames<frame>(joint, a, b);
  const Matrix3d I_hat = share_of_b<frame>(f);
  const Vector3d o_a = a.R * joint.a.o, o_b = b.R * joint.b.o;     // [8]
  const Vector3d d = b.x + o_b - a.x - o_a;                        // [9]
  const Vector3d F = f.R_hat * joint.K * f.R_hat.transpose() * d;  // [21, 30c]
  const Vector3d dxF = d.cross(F);
  const Vector3d couple = I_hat.transpose() * dxF;

  NodeLoads<double> out;
  out.q << -F, -o_a.cross(F) - (dxF - couple), F, o_b.cross(F) - couple;  // [30, 28]
  if (with_tangent) {
    const Rows frame_spin = rows(O, I - I_hat, O, I_hat);  // [25, 28]
    const Rows d_d = rows(-I, cross(o_a), I, -cross(o_b));
    const Rows d_strain = d_d + cross(d) * frame_spin;  // R^ times [29]
    const Rows d_F = -cross(F) * frame_spin + f.R_hat * joint.K * f.R_hat.transpose() * d_strain;
    const Rows d_dxF = -cross(F) * d_d + cross(d) * d_F;

    Rows d_couple = -cross(couple) * frame_spin + I_hat.transpose() * (cross(dxF) * frame_spin + d_dxF);
    if (frame == Frame::halfway) {
      // d(I + R~)^-1 = -(I + R~)^-1 dR~ (I + R~)^-1, with the spin of R~ from [66].
      const Matrix3d A = (I + f.R_tilde).inverse();
      const Rows tilde_spin = A * f.R_a.transpose() * rows(O, -I, O, I);
      const Vector3d y = A.transpose() * f.R_hat.transpose() * dxF;
      d_couple -= f.R_hat * A.transpose() * f.R_tilde.transpose() * cross(y) * tilde_spin;
    }
    // The arms turn with their nodes: d(o x F) = [F][o] w + o x dF.
    const Rows d_arm_a = cross(F) * cross(o_a) * rows(O, I, O, O) + cross(o_a) * d_F;
    const Rows d_arm_b = cross(F) * cross(o_b) * rows(O, O, O, I) + cross(o_b) * d_F;
    out.tangent << -d_F, -d_arm_a - (d_dxF - d_couple), d_F, d_arm_b - d_couple;
  }
  return out;
}

}  // namespace halfway::bench::textbook
