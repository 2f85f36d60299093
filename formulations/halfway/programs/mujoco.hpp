// MuJoCo: soft weld, and the stiffness of a free joint. Its ball joint is a rotation vector with one
// stiffness, its chain of hinges is `simbody_xyz`.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// The `quaternion` potential with MuJoCo's own factors: S is divided by D = 1/m_a + 1/m_b, and by four for
/// rotation; the inertias do not enter. K_f and K_m both say S.
struct MujocoWeld {
  static constexpr const char* name = "mujoco_weld";
  static constexpr const char* stands_for = "MuJoCo equality weld, soft";
  static constexpr ProgramFacts facts{.source = "MuJoCo 2.2.2, 7e-12; one stiffness S for everything",
                                      .order_free = true,
                                      .isotropic_conservative = true,
                                      .tensorial = true,
                                      .isotropic_moments = true,
                                      .isotropic_forces = true,
                                      .asks_for_masses = true};

  template <class T>
  static TwelveLoads<T> at_nodes(const Situation<T>& s) {
    const Mat3<T> P_a = frame_a(s);
    const Mat3<T> R = P_a.transpose() * frame_b(s);
    const T D = T(1) / s.mass_a + T(1) / s.mass_b;
    const Vec3<T> pulled = s.K_f * Vec3<T>(P_a.transpose() * reach(s)), turned = s.K_m * axial(R);
    const Vec3<T> f = P_a * Vec3<T>(pulled / D), M = P_a * Vec3<T>(turned / (T(4) * D));
    return carried<T>(s, f, -M, M);
  }
};

/// A spring to the world, whose pose at rest is that of joint frame a: body a gets nothing.
struct MujocoFree {
  static constexpr const char* name = "mujoco_free";
  static constexpr const char* stands_for = "MuJoCo free joint stiffness (to the world)";
  static constexpr ProgramFacts facts{.source = "MuJoCo 2.2.2, 5e-16; one stiffness for everything",
                                      .balanced = false,
                                      .isotropic_conservative = true,
                                      .tensorial = true,
                                      .isotropic_moments = true,
                                      .isotropic_forces = true};

  template <class T>
  static TwelveLoads<T> at_nodes(const Situation<T>& s) {
    const Mat3<T> P_a = frame_a(s);
    const Mat3<T> R = P_a.transpose() * frame_b(s);
    const Vec3<T> force = s.K_f * Vec3<T>(P_a.transpose() * reach(s)), moment = s.K_m * so3::log<T>(R);
    TwelveLoads<T> q = carried<T>(s, P_a * force, Vec3<T>(Vec3<T>::Zero()), P_a * moment);
    q.template head<6>().setZero();
    return q;
  }
};

}  // namespace halfway::programs
