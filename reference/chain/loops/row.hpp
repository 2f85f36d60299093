// Rows of eight numbers: a row of a 6 x 6 block with a seventh column beside it. In AVX-512 one register.
#pragma once

#include "halfway/batch/loops/pack.hpp"

namespace halfway::reference::chain::detail {

/// Eight doubles in registers of one instruction set; the tag keeps functions of one out of another's code.
template <class Isa>
struct Row {
  using Part = batch::Pack<double, Isa>;
  static constexpr int kLanes = Part::kLanes, kParts = 8 / kLanes;
  Part part[kParts];

  static HALFWAY_INLINE Row load(const double* from) {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return Part::load(from + p * kLanes); });
  }
  static HALFWAY_INLINE Row all(double x) {
    return made([&](int) HALFWAY_INLINE_LAMBDA { return Part(x); });
  }
  HALFWAY_INLINE void store(double* to) const {
    for (int p = 0; p < kParts; ++p) part[p].store(to + p * kLanes);
  }
  HALFWAY_INLINE double at(int k) const { return part[k / kLanes].v[k % kLanes]; }
  HALFWAY_INLINE void set(int k, double x) { part[k / kLanes].v[k % kLanes] = x; }

  template <int k>
  HALFWAY_INLINE Row splat() const {
    if constexpr (kParts == 1) {
      const auto& v = part[0].v;
      return {Part(__builtin_shufflevector(v, v, k, k, k, k, k, k, k, k))};
    } else {
      return all(at(k));
    }
  }
  /// Columns 0 ... 5 of this, column 6 of another; the eighth is the other's too.
  HALFWAY_INLINE Row with_seventh(const Row& o) const {
    Row out = *this;
    if constexpr (kParts == 1)
      out.part[0].v = __builtin_shufflevector(part[0].v, o.part[0].v, 0, 1, 2, 3, 4, 5, 14, 15);
    else
      out.set(6, o.at(6)), out.set(7, o.at(7));
    return out;
  }
  HALFWAY_INLINE Row size() const {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return where_negative(part[p], -part[p], part[p]); });
  }
  HALFWAY_INLINE Row larger(const Row& o) const {
    return made(
        [&](int p) HALFWAY_INLINE_LAMBDA { return where_negative(part[p] - o.part[p], o.part[p], part[p]); });
  }

  friend HALFWAY_INLINE Row operator-(const Row& a) {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return -a.part[p]; });
  }
  friend HALFWAY_INLINE Row operator+(const Row& a, const Row& b) {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return a.part[p] + b.part[p]; });
  }
  friend HALFWAY_INLINE Row operator-(const Row& a, const Row& b) {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return a.part[p] - b.part[p]; });
  }
  friend HALFWAY_INLINE Row operator*(const Row& a, const Row& b) {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return a.part[p] * b.part[p]; });
  }
  friend HALFWAY_INLINE Row operator/(const Row& a, const Row& b) {
    return made([&](int p) HALFWAY_INLINE_LAMBDA { return a.part[p] / b.part[p]; });
  }

 private:
  template <class F>
  static HALFWAY_INLINE Row made(const F& part_at) {
    Row out{};
    for (int p = 0; p < kParts; ++p) out.part[p] = part_at(p);
    return out;
  }
};

/// Eight rows of eight to their columns.
template <class Isa>
HALFWAY_INLINE void transpose(const Row<Isa> (&rows)[8], Row<Isa> (&to)[8]) {
  if constexpr (Row<Isa>::kParts == 1) {
    typename Row<Isa>::Part::V a[8], b[8];
    for (int i = 0; i < 8; ++i) a[i] = rows[i].part[0].v;
    for (int i = 0; i < 8; i += 2) {
      b[i] = __builtin_shufflevector(a[i], a[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
      b[i + 1] = __builtin_shufflevector(a[i], a[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int i = 0; i < 8; i += 4) {
      for (int k = i; k < i + 2; ++k) {
        a[k] = __builtin_shufflevector(b[k], b[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        a[k + 2] = __builtin_shufflevector(b[k], b[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
      }
    }
    for (int k = 0; k < 4; ++k) {
      to[k].part[0].v = __builtin_shufflevector(a[k], a[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
      to[k + 4].part[0].v = __builtin_shufflevector(a[k], a[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
  } else {
    alignas(64) double by_row[64], by_column[64];
    for (int i = 0; i < 8; ++i) rows[i].store(by_row + 8 * i);
    for (int i = 0; i < 64; ++i) by_column[i] = by_row[i % 8 * 8 + i / 8];
    for (int k = 0; k < 8; ++k) to[k] = Row<Isa>::load(by_column + 8 * k);
  }
}

}  // namespace halfway::reference::chain::detail
