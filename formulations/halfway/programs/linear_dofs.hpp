// Elements that add and subtract the nodes' own freedoms, used past small angles.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// Linear CBUSH, code_aster's DIS_TR, SPRING2, twoNodeLink: axes that stay where they were, differences of
/// the nodes' total rotation vectors. The nodes start unturned, so the
/// axes are those of H_a, and the order of the nodes matters where H_b is another. A rigid turn of
/// the pair makes force and energy.
struct LinearDofs {
  static constexpr const char* name = "linear_dofs";
  static constexpr const char* stands_for = "linear CBUSH, code_aster DIS_TR, SPRING2, twoNodeLink";
  static constexpr ProgramFacts facts{.known = Known::read_in_source,
                                      .source = "code_aster te0047.F90, OpenSees TwoNodeLink.cpp",
                                      .balanced = false,

                                      .objective = false,
                                      .isotropic_conservative = true,
                                      .tensorial = true};

  template <class T>
  static TwelveLoads<T> at_nodes(const Situation<T>& s) {
    const Mat3<T>& H = s.end_a.H;
    const Vec3<T> turn = so3::log<T>(s.b.R) - so3::log<T>(s.a.R);
    const Vec3<T> seen = H.transpose() * reach(s), turned = H.transpose() * turn;
    const Vec3<T> force = s.K_f * seen, moment = s.K_m * turned;
    const Vec3<T> f = H * force, M = H * moment;
    return carried<T>(s, f, -M, M);
  }
};

}  // namespace halfway::programs
