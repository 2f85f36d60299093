// Where a pack's results go.
#pragma once

#include "halfway/batch/loops/job.hpp"
#include "halfway/batch/loops/pack.hpp"
#include "halfway/joint/pose.hpp"
#include "halfway/kernels/dual.hpp"
#include "halfway/kernels/loads.hpp"

#include <type_traits>

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

/// Rows of tables that take a load's parts as they come.
template <class Number>
struct VectorRows {
  Number* first;
  long stride;
  template <class P>
  HALFWAY_INLINE void operator=(const kernel::V3<P>& v) const {
    Writer<false, Number>{first, stride}.vector(0, v);
  }
};
template <class Number>
struct MatrixRows {
  Number* first;
  long stride;
  template <class P>
  HALFWAY_INLINE void operator=(const kernel::M3<P>& m) const {
    Writer<false, Number>{first, stride}.matrix(0, m);
  }
};
/// One load's three rows, and the 27 of its three blocks.
template <class Number>
struct LoadRows {
  VectorRows<Number> value;
  MatrixRows<Number> x, wa, wb;

  HALFWAY_INLINE LoadRows(const Columns<Number>& l, const Columns<Number>& t, long at, int load)
      : value{l.first + at + 3 * load * l.stride, l.stride},
        x{t.first + at + 27 * load * t.stride, t.stride},
        wa{t.first + at + (27 * load + 9) * t.stride, t.stride},
        wb{t.first + at + (27 * load + 18) * t.stride, t.stride} {}
};
template <class Number>
struct PointRows {
  LoadRows<Number> f, a, b;
  HALFWAY_INLINE PointRows(const Job<Number>& job, long i)
      : f(job.loads, job.tangent, i * job.step, 0),
        a(job.loads, job.tangent, i * job.step, 1),
        b(job.loads, job.tangent, i * job.step, 2) {}
};

template <class Number>
struct MomentRows {
  VectorRows<Number> m;
  MatrixRows<Number> wa, wb;
  HALFWAY_INLINE MomentRows(const Job<Number>& job, long i)
      : m{job.loads.first + i * job.step, job.loads.stride},
        wa{job.tangent.first + i * job.step, job.tangent.stride},
        wb{job.tangent.first + i * job.step + 9 * job.tangent.stride, job.tangent.stride} {}
};
template <Kind kind, class Number>
using Rows = std::conditional_t<kind == Kind::angular, MomentRows<Number>, PointRows<Number>>;

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
