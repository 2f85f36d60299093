// The strains of a slender straight rod, for the kernel of rod34 (halfway/systems/rod_law.hpp has their
// equations): in the rod's axes x along it, y and z.
#pragma once

#include "halfway/joint/parameters.hpp"
#include "halfway/kernels/laws.hpp"

namespace halfway::kernel {

/// Joint axes named anew, in cyclic order: x is axis `first` (0, 1, 2) of the joint.
struct Renamed {
  int first;

  template <class T>
  HALFWAY_INLINE V3<T> operator()(const V3<T>& v) const {
    return first == 0 ? v : first == 1 ? V3<T>{v.y, v.z, v.x} : V3<T>{v.z, v.x, v.y};
  }
  template <class T>
  HALFWAY_INLINE M3<T> operator()(const M3<T>& m) const {
    const Renamed& by = *this;
    return first == 0 ? m : first == 1 ? M3<T>{by(m.y), by(m.z), by(m.x)} : M3<T>{by(m.z), by(m.x), by(m.y)};
  }
  template <class T>
  HALFWAY_INLINE S3<T> operator()(const S3<T>& k) const {
    return upper_triangle((*this)(full(k)));
  }
  template <class T>
  HALFWAY_INLINE Pair<T> operator()(const Pair<T>& e) const {
    return {(*this)(e.f), (*this)(e.m)};
  }
  template <class T>
  HALFWAY_INLINE Stiffness6<T> operator()(const Stiffness6<T>& k) const {
    return {(*this)(k.ff), (*this)(k.fm), (*this)(k.mm)};
  }
  HALFWAY_INLINE Renamed back() const { return {(3 - first) % 3}; }
};

/// What the rod's length and the law's stiffness at no strain make of the strains.
template <class T>
struct SlenderShape {
  T length;                      ///< negative against the axis
  T aside_y, aside_z;            ///< by twist and bending, over their product
  T shortening_y, shortening_z;  ///< by shear, over half its square

  HALFWAY_INLINE SlenderShape(double L, const Stiffness6<T>& k)
      : length(L),
        aside_y(T(L / 12) * (k.mm.xx - k.mm.yy + k.mm.zz) / k.mm.zz),
        aside_z(T(L / 12) * (k.mm.xx + k.mm.yy - k.mm.zz) / k.mm.yy),
        shortening_y(shortening(L, k.ff.yy / k.mm.zz)),
        shortening_z(shortening(L, k.ff.zz / k.mm.yy)) {}

  HALFWAY_INLINE Pair<T> seen(const Pair<T>& e) const {
    const V3<T>&d = e.f, &t = e.m;
    const T nearer = T(0.5) * (shortening_y * d.y * d.y + shortening_z * d.z * d.z) -
                     T(1.0 / 12) * length * (t.y * t.y + t.z * t.z);
    return {{d.x + nearer, d.y + aside_y * t.x * t.y, d.z + aside_z * t.x * t.z}, t};
  }
  /// d(seen displacement) by the displacement and by the rotation.
  HALFWAY_INLINE M3<T> by_d(const V3<T>& d) const {
    M3<T> A = plus_diagonal(zero33<T>(), T(1));
    A.x.y = shortening_y * d.y, A.x.z = shortening_z * d.z;
    return A;
  }
  HALFWAY_INLINE M3<T> by_theta(const V3<T>& t) const {
    const T sixth = T(-1.0 / 6) * length, zero(0);
    return {{zero, sixth * t.y, sixth * t.z},
            {aside_y * t.y, aside_y * t.x, zero},
            {aside_z * t.z, zero, aside_z * t.x}};
  }
  /// Of the law's force, constant.
  HALFWAY_INLINE S3<T> curvature_d(const V3<T>& f) const {
    const T zero(0);
    return {zero, zero, zero, shortening_y * f.x, zero, shortening_z * f.x};
  }
  HALFWAY_INLINE S3<T> curvature_theta(const V3<T>& f) const {
    const T sixth = T(-1.0 / 6) * length * f.x, zero(0);
    return {zero, aside_y * f.y, aside_z * f.z, sixth, zero, sixth};
  }

 private:
  static HALFWAY_INLINE T shortening(double L, const T& stiffer) {
    const T share = T(L * L / 12) * stiffer;
    return T(1.2 / L) * share * share;
  }
};

template <class L>
struct SlenderLaw {
  static constexpr bool kLinear = false;
  L law;
  Parameters rod;

  template <class T>
  HALFWAY_INLINE Pair<T> stress(const Pair<T>& strain) const {
    const Renamed along = axes();
    const SlenderShape<T> shape = shape_of<T>();
    const Pair<T> e = along(strain), s = along(law.stress(along.back()(shape.seen(e))));
    return along.back()(Pair<T>{s.f * shape.by_d(e.f), s.m + s.f * shape.by_theta(e.m)});
  }
  template <class T>
  HALFWAY_INLINE Stiffness6<T> stiffness(const Pair<T>& strain) const {
    const Renamed along = axes();
    const SlenderShape<T> shape = shape_of<T>();
    const Pair<T> e = along(strain), seen = along.back()(shape.seen(e));
    const V3<T> f = along(law.stress(seen).f);
    const Stiffness6<T> k = along(law.stiffness(seen));
    const M3<T> A = shape.by_d(e.f), G = shape.by_theta(e.m), fm = full(k.ff) * G + k.fm;
    const M3<T> mixed = transposed_times(G, k.fm);
    return along.back()(
        Stiffness6<T>{turned(transposed(A), k.ff) + shape.curvature_d(f), transposed_times(A, fm),
                      upper_triangle(full(turned(transposed(G), k.ff)) + mixed + transposed(mixed)) + k.mm +
                          shape.curvature_theta(f)});
  }

 private:
  HALFWAY_INLINE Renamed axes() const { return {(rod.axis > 0 ? rod.axis : -rod.axis) - 1}; }
  template <class T>
  HALFWAY_INLINE SlenderShape<T> shape_of() const {
    const Pair<T> none{zero3<T>(), zero3<T>()};
    return {rod.axis > 0 ? rod.length : -rod.length, axes()(law.stiffness(none))};
  }
};

}  // namespace halfway::kernel
