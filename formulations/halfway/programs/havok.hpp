// Havok Physics, six spring motors: angles about bisectors. Closed source: the law was found by measuring.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// e_i: the angle about the bisector m_i of both bodies' axes i, from axis j of a to axis j of b, both seen
/// along m_i; (i, j) = (x, y), (y, x), (z, x). The choice of j makes the three axes unlike.
struct BisectorMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    constexpr int kOther[] = {1, 0, 0};
    Vec3<T> e;
    for (int i = 0; i < 3; ++i) e[i] = angle<T>(m.R, i, kOther[i]);
    return e;
  }

 private:
  template <class T>
  static T angle(const Mat3<T>& R, int i, int j) {
    using std::atan2;
    const Vec3<T> axis = unit<T>(Vec3<T>::Unit(i) + R.col(i));
    const auto across = [&](const Vec3<T>& v) { return Vec3<T>(v - axis * axis.dot(v)); };
    const Vec3<T> on_a = across(Vec3<T>::Unit(j)), on_b = across(R.col(j));
    return atan2(T(axis.dot(on_a.cross(on_b))), T(on_a.dot(on_b)));
  }
};

struct Havok : Composed<FrameA, BisectorMeasure, Along<FrameA>, AtB> {
  static constexpr const char* name = "havok";
  static constexpr const char* stands_for = "Havok Physics, six spring motors";
  static constexpr ProgramFacts facts{.source = "Havok (npm @babylonjs/havok 1.3.14), 1.4e-5"};
};

}  // namespace halfway::programs
