// From blocks of results, [pack][row][lane], to tables: what the caches keep no longer, all 144 entries, or
// compressed tangents; and from these back.
#pragma once

#include "halfway/batch/loops/results.hpp"

#include <initializer_list>

namespace halfway::batch::detail {

/// Rows of one pack as the vectors and matrices that were put there.
template <class P, class Number>
struct Reader {
  const Number* first;
  long stride;

  HALFWAY_INLINE P one(int row) const { return P::load(first + row * stride); }
  HALFWAY_INLINE kernel::V3<P> vector(int row) const { return {one(row), one(row + 1), one(row + 2)}; }
  HALFWAY_INLINE kernel::M3<P> matrix(int row) const {
    return {vector(row), vector(row + 3), vector(row + 6)};
  }
  HALFWAY_INLINE kernel::S3<P> upper(int row) const {
    return {one(row), one(row + 1), one(row + 2), one(row + 3), one(row + 4), one(row + 5)};
  }
  HALFWAY_INLINE kernel::Load<P> load(int value, int row) const {
    return {vector(value), matrix(row), matrix(row + 9), matrix(row + 18)};
  }
};

/// The loads and tangent of one pack of a block.
template <Kind kind, class P, class Number>
HALFWAY_INLINE auto loads_in(const Block<Number>& b, long pack) {
  const Reader<P, Number> in{b.first + pack * (b.load_rows + b.tangent_rows) * P::kLanes, P::kLanes};
  if constexpr (kind == Kind::angular)
    return kernel::MomentLoads<P>{in.vector(0), in.matrix(3), in.matrix(12)};
  else
    return kernel::PointLoads<P>{in.load(0, 9), in.load(3, 36), in.load(6, 63)};
}

/// The same rows, past the caches.
template <class P, class Number>
void stream_rows(const Block<Number>& b) {
  for (long pack = 0; pack < b.packs; ++pack) {
    const int rows = b.load_rows + b.tangent_rows;
    const Reader<P, Number> in{b.first + pack * rows * P::kLanes, P::kLanes};
    for (int row = 0; row < rows; ++row) {
      const Place<Number>& to = row < b.load_rows ? b.loads : b.tangent;
      const int at = row < b.load_rows ? row : row - b.load_rows;
      in.one(row).stream(to.at(pack * P::kLanes) + at * to.stride);
    }
  }
}

/// All 12 x 12 entries.
template <bool past_caches, class P, class Number>
void put_all(const Block<Number>& b) {
  for (long pack = 0; pack < b.packs; ++pack) {
    const auto l = loads_in<Kind::linear, P>(b, pack);
    const long i = pack * P::kLanes;
    const Writer<past_caches, Number> loads{b.loads.at(i), b.loads.stride};
    loads.vector(0, l.f.value), loads.vector(3, l.a.value), loads.vector(6, l.b.value);
    kernel::put_tangent(Writer<past_caches, Number>{b.tangent.at(i), b.tangent.stride}, l);
  }
}

template <Kind kind, Kept kept, class P, class Number>
void compress(const Block<Number>& b) {
  for (long pack = 0; pack < b.packs; ++pack) {
    const long i = pack * P::kLanes;
    auto out = rows_at<kind, kept>(writer(b.loads, i), writer(b.tangent, i));
    kernel::assign<true>(loads_in<kind, P>(b, pack), out);
  }
}

/// A joint alone, with the instructions of Isa.
template <class Isa>
struct OneLane {
  static constexpr int kBytes = 8;
};

/// Calls pack.operator()<P>(i) for the packs of all joints and the last ones alone.
template <class Isa, class Call>
HALFWAY_INLINE void by_packs(long count, const Call& call) {
  long i = 0;
  for (; i + Pack<double, Isa>::kLanes <= count; i += Pack<double, Isa>::kLanes)
    call.template operator()<Pack<double, Isa>>(i);
  for (; i < count; ++i) call.template operator()<Pack<double, OneLane<Isa>>>(i);
}

/// What compress() kept: of an angular joint m and wb; else values, f.x, f.wb, b.x, b.wb.
template <Kind kind, Kept kept, class P>
HALFWAY_INLINE auto kept_at(const Unpacking& u, long i) {
  const Reader<P, double> loads{u.loads.at(i), u.loads.stride}, in{u.tangent.at(i), u.tangent.stride};
  if constexpr (kind == Kind::angular) {
    return kernel::MomentLoads<P>{loads.vector(0), {}, in.matrix(0)};
  } else {
    kernel::PointLoads<P> l;
    l.f.value = loads.vector(0), l.a.value = loads.vector(3), l.b.value = loads.vector(6);
    l.f.x = full(in.upper(0)), l.f.wb = in.matrix(6);
    if constexpr (kept == Kept::conservative) {
      const kernel::S3<P> k = in.upper(15);  // its skew part is -[m_b] / 2
      const kernel::V3<P>& m = l.b.value;
      l.b.x = transposed(l.f.wb);
      l.b.wb = {{k.xx, k.xy, k.xz}, {k.xy - m.z, k.yy, k.yz}, {k.xz + m.y, k.yz - m.x, k.zz}};
    } else {
      l.b.x = in.matrix(15), l.b.wb = in.matrix(24);
    }
    return l;
  }
}
template <class P>
HALFWAY_INLINE kernel::V3<P> difference(const Columns<const double>& a, int row_a,
                                        const Columns<const double>& b, int row_b, long i) {
  return Reader<P, double>{b.first + i, b.stride}.vector(row_b) -
         Reader<P, double>{a.first + i, a.stride}.vector(row_a);
}

template <Kind kind, Kept kept, bool all, class Isa>
void expand(const Unpacking& u) {
  by_packs<Isa>(u.count, [&]<class P>(long i) HALFWAY_INLINE_LAMBDA {
    auto l = kept_at<kind, kept, P>(u, i);
    const auto out = writer(u.out, i);
    if constexpr (kind == Kind::angular) {
      out.matrix(0, minus_skew(-l.wb, l.m)), out.matrix(9, l.wb);
    } else {
      kernel::complete<true, kept == Kept::conservative, true>(difference<P>(u.x_a, 0, u.x_b, 0, i), l);
      if constexpr (all) {
        kernel::put_tangent(out, l);
      } else {
        int row = 0;
        for (const kernel::Load<P>* load : {&l.f, &l.a, &l.b}) {
          out.matrix(row, load->x), out.matrix(row + 9, load->wa), out.matrix(row + 18, load->wb);
          row += 27;
        }
      }
    }
  });
}

/// J v: a turns everything with it; what is left moves b by u and turns it by s.
template <Kind kind, Kept kept, class Isa>
void multiply(const Unpacking& u) {
  by_packs<Isa>(u.count, [&]<class P>(long i) HALFWAY_INLINE_LAMBDA {
    const auto l = kept_at<kind, kept, P>(u, i);
    const Reader<P, double> v{u.direction.first + i, u.direction.stride};
    const auto out = writer(u.out, i);
    if constexpr (kind == Kind::angular) {
      const kernel::V3<P> w = v.vector(0);
      out.vector(0, l.wb * (v.vector(3) - w) + cross(w, l.m));
    } else {
      const kernel::V3<P> D = difference<P>(u.x_a, 0, u.x_b, 0, i), w = v.vector(3);
      const kernel::V3<P> moved = v.vector(6) - v.vector(0), s = v.vector(9) - w, by = moved - cross(w, D);
      const kernel::V3<P> f = l.f.x * by + l.f.wb * s + cross(w, l.f.value);
      const kernel::V3<P> b = l.b.x * by + l.b.wb * s + cross(w, l.b.value);
      out.vector(0, f), out.vector(3, -(b + cross(moved, l.f.value) + cross(D, f))), out.vector(6, b);
    }
  });
}

template <class P, class Number>
constexpr Spreading<Number> make_spreading() {
  return {stream_rows<P, Number>, put_all<false, P, Number>, put_all<true, P, Number>};
}
template <Kind kind, Kept kept, class Isa>
constexpr Compressing make_compressing() {
  return {compress<kind, kept, Pack<double, Isa>, double>, expand<kind, kept, false, Isa>,
          expand<kind, kept, kind != Kind::angular, Isa>, multiply<kind, kept, Isa>};
}
template <class Isa>
constexpr Spreadings make_spreadings() {
  return {make_spreading<Pack<double, Isa>, double>(), make_spreading<Pack<float, Isa>, float>(),
          make_compressing<Kind::angular, Kept::general, Isa>(),
          make_compressing<Kind::linear, Kept::general, Isa>(),
          make_compressing<Kind::linear, Kept::conservative, Isa>()};
}

}  // namespace halfway::batch::detail
