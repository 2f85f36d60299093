// From blocks of results, [pack][row][lane], to tables: what the caches keep no longer, and all 144 entries.
#pragma once

#include "halfway/batch/loops/results.hpp"

namespace halfway::batch::detail {

/// Rows of a block as the matrices that were put there.
template <class P, class Number>
struct Reader {
  const Number* first;

  HALFWAY_INLINE P one(int row) const { return P::load(first + row * P::kLanes); }
  HALFWAY_INLINE kernel::V3<P> vector(int row) const { return {one(row), one(row + 1), one(row + 2)}; }
  HALFWAY_INLINE kernel::M3<P> matrix(int row) const {
    return {vector(row), vector(row + 3), vector(row + 6)};
  }
  /// The value, and the 27 rows of put_distinct().
  HALFWAY_INLINE kernel::Load<P> load(int value, int row) const {
    return {vector(value), matrix(row), matrix(row + 9), matrix(row + 18)};
  }
};

/// The same rows, past the caches.
template <class P, class Number>
void stream_rows(const Block<Number>& b) {
  for (long pack = 0; pack < b.packs; ++pack) {
    const Number* const from = b.first + pack * (b.load_rows + b.tangent_rows) * P::kLanes;
    for (int row = 0; row < b.load_rows; ++row)
      P::load(from + row * P::kLanes).stream(b.loads.first + row * b.loads.stride + pack * P::kLanes);
    for (int row = 0; row < b.tangent_rows; ++row) {
      P::load(from + (b.load_rows + row) * P::kLanes)
          .stream(b.tangent.first + row * b.tangent.stride + pack * P::kLanes);
    }
  }
}

/// All 12 x 12 entries.
template <bool past_caches, class P, class Number>
void put_all(const Block<Number>& b) {
  for (long pack = 0; pack < b.packs; ++pack) {
    const Reader<P, Number> in{b.first + pack * (b.load_rows + b.tangent_rows) * P::kLanes};
    const kernel::PointLoads<P> l{in.load(0, 9), in.load(3, 36), in.load(6, 63)};
    const Writer<past_caches, Number> loads{b.loads.first + pack * P::kLanes, b.loads.stride},
        tangent{b.tangent.first + pack * P::kLanes, b.tangent.stride};
    loads.vector(0, l.f.value), loads.vector(3, l.a.value), loads.vector(6, l.b.value);
    kernel::put_tangent(tangent, l);
  }
}

template <class Isa, class Number>
constexpr Spreading<Number> make_spreading() {
  using P = Pack<Number, Isa>;
  return {stream_rows<P, Number>, put_all<false, P, Number>, put_all<true, P, Number>};
}

}  // namespace halfway::batch::detail
