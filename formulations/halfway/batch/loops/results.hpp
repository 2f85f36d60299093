// Where a pack's results go.
#pragma once

#include "halfway/batch/loops/job.hpp"
#include "halfway/batch/loops/pack.hpp"
#include "halfway/batch/loops/same.hpp"
#include "halfway/kernels/core/loads.hpp"
#include "halfway/kernels/dual.hpp"

#include <type_traits>

namespace halfway::batch::detail {

/// Rows of numbers at the joints of one pack.
template <bool past_caches, class Number>
struct Writer {
  Number* first;
  long stride;

  HALFWAY_INLINE Writer from(int row) const { return {first + row * stride, stride}; }
  template <class P>
  HALFWAY_INLINE void one(int row, const P& x) const {
    if constexpr (past_caches)
      x.stream(first + row * stride);
    else
      x.store(first + row * stride);
  }
  template <class P>
  HALFWAY_INLINE void vector(int row, const kernel::V3<P>& v) const {
    one(row, v.x), one(row + 1, v.y), one(row + 2, v.z);
  }
  /// Rows of a matrix `step` apart.
  template <class P>
  HALFWAY_INLINE void matrix(int row, const kernel::M3<P>& m, int step = 3) const {
    vector(row, m.x), vector(row + step, m.y), vector(row + 2 * step, m.z);
  }
};

template <class Number>
HALFWAY_INLINE Writer<false, Number> writer(const Place<Number>& place, long i) {
  return {place.at(i), place.stride};
}

/// What takes a load's parts as they come: all rows of a vector or a matrix, its upper triangle, none.
template <class Number>
struct Rows {
  Writer<false, Number> to;
  template <class P>
  HALFWAY_INLINE void operator=(const kernel::V3<P>& v) const {
    to.vector(0, v);
  }
  template <class P>
  HALFWAY_INLINE void operator=(const kernel::M3<P>& m) const {
    to.matrix(0, m);
  }
};
template <class Number>
struct UpperRows {
  Writer<false, Number> to;
  template <class P>
  HALFWAY_INLINE void operator=(const kernel::M3<P>& m) const {
    to.vector(0, m.x), to.one(3, m.y.y), to.one(4, m.y.z), to.one(5, m.z.z);
  }
};
struct NoRows {
  template <class X>
  HALFWAY_INLINE void operator=(const X&) const {}
};
template <class M, class Wa, class Wb>
struct MomentRows {
  M m;
  Wa wa;
  Wb wb;
};
template <class Value, class X, class Wa, class Wb>
struct LoadRows {
  Value value;
  X x;
  Wa wa;
  Wb wb;
};
template <class F, class A, class B>
struct PointRows {
  F f;
  A a;
  B b;
};

template <Kind kind, Kept kept, class W>
HALFWAY_INLINE auto rows_at(const W& loads, const W& tangent) {
  using R = Rows<std::remove_pointer_t<decltype(tangent.first)>>;
  using U = UpperRows<std::remove_pointer_t<decltype(tangent.first)>>;
  const auto load = [&](int k) HALFWAY_INLINE_LAMBDA { return R{loads.from(3 * k)}; };
  const auto row = [&](int k) HALFWAY_INLINE_LAMBDA { return R{tangent.from(k)}; };
  const auto all = [&](int k) HALFWAY_INLINE_LAMBDA {
    return LoadRows<R, R, R, R>{load(k), row(27 * k), row(27 * k + 9), row(27 * k + 18)};
  };
  using Value = LoadRows<R, NoRows, NoRows, NoRows>;
  if constexpr (kind == Kind::angular && kept == Kept::all) {
    return MomentRows<R, R, R>{load(0), row(0), row(9)};
  } else if constexpr (kind == Kind::angular) {
    return MomentRows<R, NoRows, R>{load(0), {}, row(0)};
  } else if constexpr (kept == Kept::all) {
    return PointRows<LoadRows<R, R, R, R>, LoadRows<R, R, R, R>, LoadRows<R, R, R, R>>{all(0), all(1),
                                                                                       all(2)};
  } else {
    using F = LoadRows<R, U, NoRows, R>;
    const F f{load(0), {tangent.from(0)}, {}, row(6)};
    const Value a{load(1), {}, {}, {}};
    if constexpr (kept == Kept::conservative) {
      using B = LoadRows<R, NoRows, NoRows, U>;
      return PointRows<F, Value, B>{f, a, {load(2), {}, {}, {tangent.from(15)}}};
    } else {
      using B = LoadRows<R, R, NoRows, R>;
      return PointRows<F, Value, B>{f, a, {load(2), row(15), {}, row(24)}};
    }
  }
}

/// A vector of dual numbers: values to one place, derivatives to another. Nothing has a tangent.
template <class W>
struct DualRows {
  W values, derivatives;
  template <class P>
  HALFWAY_INLINE void operator=(const kernel::V3<kernel::Dual<P>>& v) const {
    values.vector(0, value(v)), derivatives.vector(0, derivative(v));
  }
};
template <Kind kind, class W>
HALFWAY_INLINE auto product_rows_at(const W& loads, const W& product) {
  using D = DualRows<W>;
  using L = LoadRows<D, NoRows, NoRows, NoRows>;
  const auto at = [&](int row) HALFWAY_INLINE_LAMBDA { return D{loads.from(row), product.from(row)}; };
  if constexpr (kind == Kind::angular)
    return MomentRows<D, NoRows, NoRows>{at(0), {}, {}};
  else
    return PointRows<L, L, L>{{at(0), {}, {}, {}}, {at(3), {}, {}, {}}, {at(6), {}, {}, {}}};
}

}  // namespace halfway::batch::detail
