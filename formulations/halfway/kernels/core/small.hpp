// Vectors and matrices of three for the kernels: no alignment, no expression templates, so that a
// pack of joints is as good a scalar as a double. The readable transcription uses Eigen instead.
#pragma once

#include "halfway/rotations/cpp20.hpp"

#define HALFWAY_INLINE inline __attribute__((always_inline))
#define HALFWAY_INLINE_LAMBDA __attribute__((always_inline))

namespace halfway::kernel {

template <class T>
struct V3 {
  T x, y, z;
};

/// Rows x, y, z.
template <class T>
struct M3 {
  V3<T> x, y, z;
};

/// Symmetric: the upper triangle, by rows.
template <class T>
struct S3 {
  T xx, xy, xz, yy, yz, zz;
};

template <class T>
HALFWAY_INLINE V3<T> operator+(const V3<T>& a, const V3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
HALFWAY_INLINE V3<T> operator-(const V3<T>& a, const V3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
HALFWAY_INLINE V3<T> operator-(const V3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
HALFWAY_INLINE V3<T> operator*(const T& s, const V3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
HALFWAY_INLINE T dot(const V3<T>& a, const V3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
HALFWAY_INLINE V3<T> cross(const V3<T>& a, const V3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
HALFWAY_INLINE M3<T> operator+(const M3<T>& a, const M3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
HALFWAY_INLINE M3<T> operator-(const M3<T>& a, const M3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
HALFWAY_INLINE M3<T> operator-(const M3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
HALFWAY_INLINE M3<T> operator*(const T& s, const M3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
HALFWAY_INLINE V3<T> operator*(const M3<T>& a, const V3<T>& v) {
  return {dot(a.x, v), dot(a.y, v), dot(a.z, v)};
}
/// v^T A, that is A^T v.
template <class T>
HALFWAY_INLINE V3<T> operator*(const V3<T>& v, const M3<T>& a) {
  return v.x * a.x + v.y * a.y + v.z * a.z;
}
template <class T>
HALFWAY_INLINE M3<T> operator*(const M3<T>& a, const M3<T>& b) {
  return {a.x * b, a.y * b, a.z * b};
}
template <class T>
HALFWAY_INLINE M3<T> transposed(const M3<T>& a) {
  return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}};
}
/// A^T B.
template <class T>
HALFWAY_INLINE M3<T> transposed_times(const M3<T>& a, const M3<T>& b) {
  return transposed(a) * b;
}
/// A B^T.
template <class T>
HALFWAY_INLINE M3<T> times_transposed(const M3<T>& a, const M3<T>& b) {
  return {b * a.x, b * a.y, b * a.z};
}

/// a b^T.
template <class T>
HALFWAY_INLINE M3<T> outer(const V3<T>& a, const V3<T>& b) {
  return {a.x * b, a.y * b, a.z * b};
}
/// A + s.
template <class T>
HALFWAY_INLINE M3<T> plus_diagonal(M3<T> a, const T& s) {
  a.x.x = a.x.x + s, a.y.y = a.y.y + s, a.z.z = a.z.z + s;
  return a;
}
/// A + [v].
template <class T>
HALFWAY_INLINE M3<T> plus_skew(const M3<T>& a, const V3<T>& v) {
  return {{a.x.x, a.x.y - v.z, a.x.z + v.y},
          {a.y.x + v.z, a.y.y, a.y.z - v.x},
          {a.z.x - v.y, a.z.y + v.x, a.z.z}};
}
template <class T>
HALFWAY_INLINE M3<T> minus_skew(const M3<T>& a, const V3<T>& v) {
  return plus_skew(a, -v);
}
/// [v] A.
template <class T>
HALFWAY_INLINE M3<T> skew_times(const V3<T>& v, const M3<T>& a) {
  return {v.y * a.z - v.z * a.y, v.z * a.x - v.x * a.z, v.x * a.y - v.y * a.x};
}
/// A [v].
template <class T>
HALFWAY_INLINE M3<T> times_skew(const M3<T>& a, const V3<T>& v) {
  return {cross(a.x, v), cross(a.y, v), cross(a.z, v)};
}

template <class T>
HALFWAY_INLINE S3<T> operator+(const S3<T>& a, const S3<T>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
template <class T>
HALFWAY_INLINE V3<T> operator*(const S3<T>& k, const V3<T>& v) {
  return {k.xx * v.x + k.xy * v.y + k.xz * v.z, k.xy * v.x + k.yy * v.y + k.yz * v.z,
          k.xz * v.x + k.yz * v.y + k.zz * v.z};
}
template <class T>
HALFWAY_INLINE M3<T> full(const S3<T>& k) {
  return {{k.xx, k.xy, k.xz}, {k.xy, k.yy, k.yz}, {k.xz, k.yz, k.zz}};
}
/// Of a symmetric matrix.
template <class T>
HALFWAY_INLINE S3<T> upper_triangle(const M3<T>& a) {
  return {a.x.x, a.x.y, a.x.z, a.y.y, a.y.z, a.z.z};
}
/// F K F^T.
template <class T>
HALFWAY_INLINE S3<T> turned(const M3<T>& F, const S3<T>& K) {
  const M3<T> G{K * F.x, K * F.y, K * F.z};  // F K, K symmetric
  return {dot(G.x, F.x), dot(G.x, F.y), dot(G.x, F.z), dot(G.y, F.y), dot(G.y, F.z), dot(G.z, F.z)};
}
/// F X H^T.
template <class T>
HALFWAY_INLINE M3<T> turned(const M3<T>& F, const M3<T>& X, const M3<T>& H) {
  return times_transposed(F * X, H);
}

template <class T>
HALFWAY_INLINE V3<T> zero3() {
  return {T(0), T(0), T(0)};
}
template <class T>
HALFWAY_INLINE M3<T> zero33() {
  return {zero3<T>(), zero3<T>(), zero3<T>()};
}

}  // namespace halfway::kernel
