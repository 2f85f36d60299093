// The joints as their sources print them, in global axes and with sines and cosines: an independent
// road to the loads that formulations/ computes in the axes of P_a from quaternions and series.
//
// Good for generic angles only, 0 < phi < pi: the formulas divide by sin(phi) and phi. Each form has
//   loads(spec, a, b)         (f_a, m_a, f_b, m_b), global axes, N and N m, moments about the nodes
// Equation numbers are the paper's. Nothing here calls halfway/rotations/so3.hpp.
#pragma once

#include "reference/face/joint_spec.hpp"

#include <cmath>

namespace halfway::reference::closed {

template <class T>
using Loads = Eigen::Matrix<T, 12, 1>;

/// Rodrigues' formula.
template <class T>
Mat3<T> rotation(const Vec3<T>& theta) {
  using std::cos, std::sin;
  const T phi = theta.norm();
  const Mat3<T> n = skew<T>(theta / phi);
  return Mat3<T>::Identity() + sin(phi) * n + (T(1) - cos(phi)) * n * n;
}

/// ax(log R) [5] by the angle between sin(phi) and cos(phi).
template <class T>
Vec3<T> rotation_vector(const Mat3<T>& R) {
  using std::atan2;
  const Vec3<T> sine = axial(R);
  const T size = sine.norm();
  return atan2(size, T((R.trace() - T(1)) / T(2))) / size * sine;
}

/// Gamma [27].
template <class T>
Mat3<T> gamma(const Vec3<T>& theta) {
  using std::cos, std::sin;
  const T phi = theta.norm();
  const Mat3<T> x = skew(theta);
  return Mat3<T>::Identity() + (T(1) - cos(phi)) / (phi * phi) * x +
         (phi - sin(phi)) / (phi * phi * phi) * x * x;
}

/// What every form reads of the two poses, in global axes.
template <class T>
struct Geometry {
  Mat3<T> P_a, P_b;
  Vec3<T> arm_a, arm_b;  ///< R_i o_i
  Vec3<T> d;             ///< p_b - p_a [9]
  Vec3<T> theta;         ///< in the axes of P_a [4, 5]
};

template <class T>
Geometry<T> geometry(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
  Geometry<T> g;
  g.P_a = a.R * spec.a.H.template cast<T>();
  g.P_b = b.R * spec.b.H.template cast<T>();
  g.arm_a = a.R * spec.a.o.template cast<T>();
  g.arm_b = b.R * spec.b.o.template cast<T>();
  g.d = b.x + g.arm_b - a.x - g.arm_a;
  g.theta = rotation_vector<T>(g.P_a.transpose() * g.P_b);
  return g;
}

/// fbar and mbar of the spec's law, and its energy; what the kind has not is zero.
template <class T>
struct Stress {
  Vec3<T> f = Vec3<T>::Zero(), m = Vec3<T>::Zero();
  T energy{0};
};

template <class T>
Stress<T> stress(const JointSpec& spec, const Vec3<T>& dbar, const Vec3<T>& angle) {
  Stress<T> out;
  if (spec.kind == Kind::linear_angular) {
    const AnyLaw<T, 6> law(spec.law);
    Eigen::Matrix<T, 6, 1> strain;
    strain << dbar, angle;
    const auto all = law(strain).stress;
    return {all.template head<3>(), all.template tail<3>(), law.energy(strain)};
  }
  const AnyLaw<T, 3> law(spec.law);
  const bool linear = spec.kind == Kind::linear;
  (linear ? out.f : out.m) = law(linear ? dbar : angle).stress;
  out.energy = law.energy(linear ? dbar : angle);
  return out;
}

template <class T>
Loads<T> join(const Vec3<T>& f_a, const Vec3<T>& m_a, const Vec3<T>& f_b, const Vec3<T>& m_b) {
  Loads<T> q;
  q << f_a, m_a, f_b, m_b;
  return q;
}

/// The frame xi of the paper and the loads that follow from it.
struct Intrinsic {
  /// R^ [20a].
  template <class T>
  static Mat3<T> frame(const Geometry<T>& g, const T& xi) {
    return xi == T(0) ? g.P_a : Mat3<T>(g.P_a * rotation<T>(xi * g.theta));
  }
  /// I^ [26].
  template <class T>
  static Mat3<T> frame_spin(const Geometry<T>& g, const T& xi) {
    if (xi == T(0)) return Mat3<T>::Zero();
    const Mat3<T> R = frame(g, xi);
    const Mat3<T> tilde = gamma<T>(xi * g.theta) * gamma(g.theta).inverse();
    return xi * g.P_a * tilde * (g.P_a.transpose() * R) * R.transpose();
  }
  /// Moments of F = R^ fbar about the nodes [30b, 30d].
  template <class T>
  static Vec3<T> moment_a(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return -(g.arm_a.cross(F) + frame_spin<T>(g, T(1) - xi) * g.d.cross(F));
  }
  template <class T>
  static Vec3<T> moment_b(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return g.arm_b.cross(F) - frame_spin(g, xi).transpose() * g.d.cross(F);
  }
  /// [19] and [30] together.
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = geometry(spec, a, b);
    const T xi(spec.xi);
    const Mat3<T> R = frame(g, xi);
    const Stress<T> s = stress<T>(spec, R.transpose() * g.d, g.theta);
    const Vec3<T> F = R * s.f, M = R * s.m;
    return join<T>(-F, moment_a(g, xi, F) - M, F, moment_b(g, xi, F) + M);
  }
};

/// The law sees nu = 4 tan(phi/4) n in the half-way frame; M = sec^2(phi/4) R^ mbar.
struct Conformal {
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    using std::cos, std::sin;
    const Geometry<T> g = geometry(spec, a, b);
    const T phi = g.theta.norm();
    const T cosine = cos(T(phi / T(4)));
    const Mat3<T> R = Intrinsic::frame(g, T(0.5));
    const Vec3<T> nu = T(4) * sin(T(phi / T(4))) / cosine / phi * g.theta;
    const Stress<T> s = stress<T>(spec, R.transpose() * g.d, nu);
    const Vec3<T> F = R * s.f, M = R * s.m / (cosine * cosine);
    return join<T>(-F, Intrinsic::moment_a(g, T(0.5), F) - M, F, Intrinsic::moment_b(g, T(0.5), F) + M);
  }
};

/// The geometric spring by the axes of the nodes alone, as its definition has it for the stiffnesses K_f and
/// K_m. A coupling C, which the definition has not, adds d . (P_a + P_b) C e/2 to the potential.
struct Fasse {
  template <class T>
  struct Stiffness {
    Mat3<T> f = Mat3<T>::Zero(), m = Mat3<T>::Zero(), c = Mat3<T>::Zero();
  };
  template <class T>
  static Stiffness<T> stiffness(const JointSpec& spec) {
    const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> K =
        std::get<LinearSpec>(spec.law).matrix.template cast<T>();
    Stiffness<T> out;
    if (spec.kind != Kind::angular) out.f = K.template topLeftCorner<3, 3>();
    if (spec.kind != Kind::linear) out.m = K.template bottomRightCorner<3, 3>();
    if (spec.kind == Kind::linear_angular) out.c = K.template topRightCorner<3, 3>();
    return out;
  }
  /// M = P_a (A32 - A23, A13 - A31, A21 - A12), A = R (tr(K_m)/2 - K_m): of the potential tr((1 - R) G).
  template <class T>
  static Vec3<T> moment(const Mat3<T>& P_a, const Mat3<T>& R, const Mat3<T>& Km) {
    const Mat3<T> A = R * (Km.trace() / T(2) * Mat3<T>::Identity() - Km);
    return P_a * Vec3<T>(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));
  }
  /// e = 2 sin(phi/2) n = 2 ax(R)/sqrt(1 + tr(R)), and de = rate psi by the rates of ax(R) and tr(R).
  template <class T>
  struct Turn {
    Vec3<T> e;
    Mat3<T> rate;
  };
  template <class T>
  static Turn<T> turn(const Mat3<T>& R) {
    using std::sqrt;
    const T root = sqrt(T(T(1) + R.trace()));
    const Vec3<T> ax = axial(R);
    const Mat3<T> of_ax = (R.trace() * Mat3<T>::Identity() - R) / root;
    return {T(2) / root * ax, of_ax + T(2) / (root * root * root) * ax * ax.transpose()};
  }
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = geometry(spec, a, b);
    const Stiffness<T> K = stiffness<T>(spec);
    const Mat3<T> R = g.P_a.transpose() * g.P_b;
    const Turn<T> t = turn(R);
    const Vec3<T> F_a = (g.P_a * K.f * g.P_a.transpose() * g.d + g.P_a * K.c * t.e) / T(2);
    const Vec3<T> F_b = (g.P_b * K.f * g.P_b.transpose() * g.d + g.P_b * K.c * t.e) / T(2);
    const Vec3<T> by_coupling = K.c.transpose() * ((g.P_a + g.P_b).transpose() * g.d) / T(2);
    const Vec3<T> F = F_a + F_b, M = moment(g.P_a, R, K.m) + g.P_a * (t.rate.transpose() * by_coupling);
    return join<T>(-F, -g.d.cross(F_a) - M - g.arm_a.cross(F), F, -g.d.cross(F_b) + M + g.arm_b.cross(F));
  }
};

/// JOINTC literally: strains and their gradients by products of the axes e_i of the two nodes [52-56];
/// the force refers to node a [31].
struct Jointc {
  static constexpr int kNext[] = {1, 2, 0};  // i, j, k = 1 2 3, 2 3 1, 3 1 2

  template <class T>
  static Vec3<T> strain(const Geometry<T>& g) {  // [52]
    Vec3<T> psi;
    for (int i = 0; i < 3; ++i) {
      const int j = kNext[i], k = kNext[j];
      psi[k] = (g.P_b.col(i) - g.P_a.col(i)).dot(g.P_b.col(j) + g.P_a.col(j)) / T(2);
    }
    return psi;
  }
  /// Row k: d(psi_k) by the spin of node a, or b [55].
  template <class T>
  static Mat3<T> gradient(const Geometry<T>& g, bool of_a) {
    Mat3<T> out;
    for (int i = 0; i < 3; ++i) {
      const int j = kNext[i], k = kNext[j];
      const Vec3<T> sum = g.P_b.col(j) + g.P_a.col(j), step = g.P_b.col(i) - g.P_a.col(i);
      const Vec3<T> a_i = g.P_a.col(i), a_j = g.P_a.col(j), b_i = g.P_b.col(i), b_j = g.P_b.col(j);
      const Vec3<T> by_a = (sum.cross(a_i) - step.cross(a_j)) / T(2);
      const Vec3<T> by_b = -(sum.cross(b_i) + step.cross(b_j)) / T(2);
      out.row(k) = (of_a ? by_a : by_b).transpose();
    }
    return out;
  }
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = geometry(spec, a, b);
    const Stress<T> s = stress<T>(spec, g.P_a.transpose() * g.d, strain(g));
    const Vec3<T> F = g.P_a * s.f;
    return join<T>(-F, -(g.arm_a + g.d).cross(F) + gradient(g, true).transpose() * s.m, F,
                   g.arm_b.cross(F) + gradient(g, false).transpose() * s.m);
  }
};

}  // namespace halfway::reference::closed
