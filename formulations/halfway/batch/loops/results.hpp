// Where a pack's results go.
#pragma once

#include "halfway/batch/loops/job.hpp"
#include "halfway/batch/loops/pack.hpp"
#include "halfway/kernels/dual.hpp"
#include "halfway/kernels/loads.hpp"

namespace halfway::batch::detail {

/// Writes rows of a table at the joints of one pack.
template <bool past_caches, class Number>
struct Writer {
  Number* first;
  long stride;

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
HALFWAY_INLINE Writer<false, Number> writer(const Columns<Number>& c, long i) {
  return {c.first + i, c.stride};
}

template <bool with_tangent, class P, class Number>
HALFWAY_INLINE void put(const kernel::MomentLoads<P>& l, const Job<Number>& job, long i) {
  writer(job.loads, i * job.step).vector(0, l.m);
  if constexpr (with_tangent) {
    const auto out = writer(job.tangent, i * job.step);
    out.matrix(0, l.wa), out.matrix(9, l.wb);
  }
}

/// One load's three blocks, 27 rows.
template <class W, class P>
HALFWAY_INLINE void put_distinct(const W& out, int row, const kernel::Load<P>& l) {
  out.matrix(row, l.x), out.matrix(row + 9, l.wa), out.matrix(row + 18, l.wb);
}
template <bool with_tangent, class P, class Number>
HALFWAY_INLINE void put(const kernel::PointLoads<P>& l, const Job<Number>& job, long i) {
  const auto loads = writer(job.loads, i * job.step);
  loads.vector(0, l.f.value), loads.vector(3, l.a.value), loads.vector(6, l.b.value);
  if constexpr (with_tangent) {
    const auto out = writer(job.tangent, i * job.step);
    put_distinct(out, 0, l.f), put_distinct(out, 27, l.a), put_distinct(out, 54, l.b);
  }
}

template <class P, class Number>
HALFWAY_INLINE void put_product(const kernel::MomentLoads<kernel::Dual<P>>& l, const Job<Number>& job,
                                long i) {
  writer(job.loads, i).vector(0, value(l.m));
  writer(job.tangent, i).vector(0, derivative(l.m));
}
template <class P, class Number>
HALFWAY_INLINE void put_product(const kernel::PointLoads<kernel::Dual<P>>& l, const Job<Number>& job,
                                long i) {
  const auto loads = writer(job.loads, i), product = writer(job.tangent, i);
  loads.vector(0, value(l.f.value)), loads.vector(3, value(l.a.value)), loads.vector(6, value(l.b.value));
  product.vector(0, derivative(l.f.value)), product.vector(3, derivative(l.a.value));
  product.vector(6, derivative(l.b.value));
}

}  // namespace halfway::batch::detail
