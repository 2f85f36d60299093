// Rows of eight numbers: a row of a 6 x 6 block with a seventh column beside it. In AVX-512 one register.
#pragma once

#include "halfway/batch/loops/pack.hpp"

namespace halfway::reference::chain::detail {

/// As eight doubles, whatever the instruction set; the tag keeps functions of one out of another's code.
template <class Isa>
struct Row {
  typedef double V __attribute__((vector_size(64)));
  typedef double Anywhere __attribute__((vector_size(64), aligned(8), may_alias));
  typedef long long Bits __attribute__((vector_size(64)));
  V v;

  static HALFWAY_INLINE Row load(const double* from) { return {V(*reinterpret_cast<const Anywhere*>(from))}; }
  HALFWAY_INLINE void store(double* to) const { *reinterpret_cast<Anywhere*>(to) = v; }
  static HALFWAY_INLINE Row all(double x) { return {x - V{}}; }

  template <int k>
  HALFWAY_INLINE Row splat() const {
    return {__builtin_shufflevector(v, v, k, k, k, k, k, k, k, k)};
  }
  /// Columns 0 ... 5 of this, column 6 of another.
  HALFWAY_INLINE Row with_seventh(const Row& o) const {
    return {__builtin_shufflevector(v, o.v, 0, 1, 2, 3, 4, 5, 14, 15)};
  }
  HALFWAY_INLINE Row size() const {
    const V minus_zero = -V{};
    return {V(Bits(v) & ~Bits(minus_zero))};
  }
  HALFWAY_INLINE Row larger(const Row& o) const { return {V(v < o.v ? o.v : v)}; }

  friend HALFWAY_INLINE Row operator+(const Row& a, const Row& b) { return {a.v + b.v}; }
  friend HALFWAY_INLINE Row operator-(const Row& a, const Row& b) { return {a.v - b.v}; }
  friend HALFWAY_INLINE Row operator*(const Row& a, const Row& b) { return {a.v * b.v}; }
  friend HALFWAY_INLINE Row operator/(const Row& a, const Row& b) { return {a.v / b.v}; }
};

/// Eight rows of eight to their columns.
template <class Isa>
HALFWAY_INLINE void transpose(Row<Isa> (&a)[8], Row<Isa> (&to)[8]) {
  using R = Row<Isa>;
  if constexpr (Isa::kBytes == 64) {
    R b[8];
    for (int i = 0; i < 8; i += 2) {
      b[i].v = __builtin_shufflevector(a[i].v, a[i + 1].v, 0, 8, 2, 10, 4, 12, 6, 14);
      b[i + 1].v = __builtin_shufflevector(a[i].v, a[i + 1].v, 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int i = 0; i < 8; i += 4) {
      for (int k = 0; k < 2; ++k) {
        a[i + k].v = __builtin_shufflevector(b[i + k].v, b[i + k + 2].v, 0, 1, 8, 9, 4, 5, 12, 13);
        a[i + k + 2].v = __builtin_shufflevector(b[i + k].v, b[i + k + 2].v, 2, 3, 10, 11, 6, 7, 14, 15);
      }
    }
    for (int k = 0; k < 4; ++k) {
      to[k].v = __builtin_shufflevector(a[k].v, a[k + 4].v, 0, 1, 2, 3, 8, 9, 10, 11);
      to[k + 4].v = __builtin_shufflevector(a[k].v, a[k + 4].v, 4, 5, 6, 7, 12, 13, 14, 15);
    }
  } else {
    alignas(64) double by_column[64];
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 8; ++k) by_column[8 * k + i] = a[i].v[k];
    }
    for (int k = 0; k < 8; ++k) to[k] = R::load(by_column + 8 * k);
  }
}

}  // namespace halfway::reference::chain::detail
