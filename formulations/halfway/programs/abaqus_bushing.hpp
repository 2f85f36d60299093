// Abaqus BUSHING = PROJECTION CARTESIAN + PROJECTION FLEXION-TORSION, axis 3 the shaft. In-plane axes and
// conjugacy are reconstructed.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// The frame half the swing and half the twist away from both nodes: third axis along the sum of both shafts,
/// the others the planar mean of the nodes'. A second choice, with a distinguished axis, that is invariant,
/// balanced and conservative.
struct AbaqusBushing {
  static constexpr const char* name = "abaqus_bushing";
  static constexpr const char* stands_for = "Abaqus BUSHING; OptiStruct JOINTG PCART + PFLTR";
  static constexpr ProgramFacts facts{.known = Known::reconstructed,
                                      .source = "Abaqus connector library",
                                      .order_free = true,
                                      .isotropic_conservative = true,
                                      .anisotropic_conservative = true};

  template <class T>
  static ProgramLoads<T> at_points(const RelativeMotion<T>& m, const Mat3<T>& K_f, const Mat3<T>& K_m) {
    const Geometry<T> g(m);
    const Vec3<T> stress = K_m * g.strain();
    const Vec3<T> force = K_f * Vec3<T>(g.E.transpose() * m.p);
    const Vec3<T> f = g.E * force;
    const Vec3<T> M = g.moment(stress), lever = m.p.cross(f);
    const Vec3<T> share = g.spin_transposed_times(lever);  // B^T (d x F)
    return {f, Vec3<T>(-M - lever + share), Vec3<T>(M - share)};
  }

 private:
  /// Swing alpha about n, torsion tau, and the frame E. Where the shafts agree n is any normal: e_1.
  template <class T>
  struct Geometry {
    T s, alpha, torsion, s_over;  ///< s_over: alpha / s
    Vec3<T> n, c, p;
    Mat3<T> E;

    explicit Geometry(const RelativeMotion<T>& m) {
      using std::atan2, std::sqrt;
      const so3::Quaternion<T>& q = m.q;
      const T squared = q.v[0] * q.v[0] + q.v[1] * q.v[1];
      s = sqrt(squared);
      const T rest = sqrt(T(q.w * q.w + q.v[2] * q.v[2]));
      alpha = T(2) * atan2(s, rest);
      s_over = T(2) * so3::detail::atan_quotient<T>(T(squared / (rest * rest))) / rest;
      torsion = T(2) * atan2(q.v[2], q.w);
      in_a_ = Vec3<T>(s_over * q.v[0], s_over * q.v[1], torsion);
      const Vec3<T> z = Vec3<T>::Unit(2), shaft = m.R.col(2), across = z.cross(shaft);
      n = across.squaredNorm() > T(0) ? unit<T>(across) : Vec3<T>(Vec3<T>::Unit(0));
      c = unit<T>(Vec3<T>(z + shaft));
      p = n.cross(c);
      const Mat3<T> swing = so3::exp<T>((alpha / T(2)) * n), twist = so3::exp<T>((torsion / T(2)) * z);
      E = swing * twist;
    }

    const Vec3<T>& strain() const { return in_a_; }

    Vec3<T> moment(const Vec3<T>& stress) const {
      using std::cos, std::sin;
      const Vec3<T> g = E.transpose() * n;
      const T along = stress[0] * g[0] + stress[1] * g[1], across = -stress[0] * g[1] + stress[1] * g[0];
      const T half = alpha / T(2);
      const T ratio = T(1) / stumpff<T>(T(half * half))[1];  // half / sin(half)
      return along * n + ratio * across * c.cross(n) + T(stress[2] / cos(half)) * c;
    }

    /// B^T v, B = 1/2 + tan(alpha/4)/2 c p^T - tan(alpha/2)/2 p c^T: the spin of E is B w_b + (1 - B) w_a.
    Vec3<T> spin_transposed_times(const Vec3<T>& v) const {
      using std::tan, std::cos, std::sin;
      const T quarter = alpha / T(4), half = alpha / T(2);
      const T t4 = T(sin(quarter)) / T(cos(quarter)), t2 = T(sin(half)) / T(cos(half));
      return v / T(2) + T(t4 / T(2)) * c.dot(v) * p - T(t2 / T(2)) * p.dot(v) * c;
    }

   private:
    Vec3<T> in_a_;
  };
};

}  // namespace halfway::programs
