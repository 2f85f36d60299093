// Bullet's 6-DOF spring as shipped: no force law, since it depends on masses.
#pragma once

#include "halfway/programs/engines.hpp"

namespace halfway::programs {

/// Each of six rows wants the relative velocity f_i dt / m_i and may push between 0 and f_i dt; f_i and its
/// axis are those of `bullet_6dof`, m_i is half the harmonic mean of the masses that the row alone would
/// move. The rows are coupled, so one that others help pushes less: what the bodies get is the solution of a
/// box-constrained complementarity problem.
struct BulletDefault {
  static constexpr const char* name = "bullet_default";
  static constexpr const char* stands_for =
      "Bullet btGeneric6DofSpring2Constraint as shipped (Blender, Godot 3)";
  static constexpr ProgramFacts facts{
      .source = "Bullet 3.24, 6e-15", .balanced = false, .asks_for_masses = true};

  template <class T>
  static TwelveLoads<T> at_nodes(const Situation<T>& s) {
    const Rows<T> rows(s);
    TwelveLoads<T> q = TwelveLoads<T>::Zero();
    const Six<T> pushed = rows.solved();
    for (int i = 0; i < 6; ++i) q += rows.J[i] * pushed[i];
    return q;
  }

 private:
  template <class T>
  using Six = Eigen::Matrix<T, 6, 1>;

  template <class T>
  struct Rows {
    TwelveLoads<T> J[6], moved[6];  ///< the row's loads for a push of one, and the velocities these make
    Six<T> wanted, most;            ///< m_i's velocity and f_i, for a time step of one

    explicit Rows(const Situation<T>& s) {
      const Mat3<T> P_a = frame_a(s);
      const Mat3<T> R = P_a.transpose() * frame_b(s);
      const RelativeMotion<T> m = relative_motion<T>(R, P_a.transpose() * reach(s));
      const Vec3<T> angles = EulerMeasure<2, 1, 0>::strain(m), O = Vec3<T>::Zero();
      for (int i = 0; i < 3; ++i) {
        const Vec3<T> u = AlongReciprocal<2, 1, 0>::moment(m, Vec3<T>(Vec3<T>::Unit(i)));
        set(i, carried<T>(s, P_a.col(i), O, O), s.K_f(i, i) * m.p[i], s, s.mass_a, s.mass_b);
        set(i + 3, carried<T>(s, O, Vec3<T>(-(P_a * u)), P_a * u), s.K_m(i, i) * angles[i], s,
            reach_inertia(s.mass_a, s.end_a.o, s.inertia_a), reach_inertia(s.mass_b, s.end_b.o, s.inertia_b));
      }
    }

    static T reach_inertia(const T& mass, const Vec3<T>& arm, const T& inertia) {
      return mass * arm.squaredNorm() + inertia;
    }

    void set(int i, const TwelveLoads<T>& row, const T& push, const Situation<T>& s, const T& of_a,
             const T& of_b) {
      J[i] = row;
      moved[i] = row;
      for (int k = 0; k < 12; ++k) {
        const T inertias[] = {s.mass_a, s.inertia_a, s.mass_b, s.inertia_b};
        moved[i][k] /= inertias[k / 3];
      }
      most[i] = push;
      wanted[i] = push * (of_a + of_b) / (of_a * of_b);
    }

    /// Projected Gauss-Seidel to the last digit; NaN where it does not get there.
    Six<T> solved() const {
      Six<T> x = Six<T>::Zero(), diagonal;
      for (int i = 0; i < 6; ++i) diagonal[i] = J[i].dot(moved[i]);
      TwelveLoads<T> velocity = TwelveLoads<T>::Zero();
      const T small = T(std::ldexp(1., 2 - RealDigits<T>::value));
      for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        T change(0), size(0);
        for (int i = 0; i < 6; ++i) {
          using std::abs;
          const T next = boxed(T(x[i] + (wanted[i] - J[i].dot(velocity)) / diagonal[i]), most[i]);
          const T step = next - x[i];
          x[i] = next;
          velocity += moved[i] * step;
          change += abs(step);
          size += abs(next);
        }
        if (change <= small * size) return x;
        if (!(change == change)) break;
      }
      return Six<T>::Constant(T(std::numeric_limits<double>::quiet_NaN()));
    }

    static T boxed(const T& x, const T& most) {
      const T zero(0);
      if (most < zero) return x > zero ? zero : x < most ? most : x;
      return x < zero ? zero : x > most ? most : x;
    }

    static constexpr int kMostSweeps = 100000;
  };
};

}  // namespace halfway::programs
