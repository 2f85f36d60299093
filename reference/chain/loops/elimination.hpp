// One step of the block elimination along the chain, in rows of a 6 x 6 block.
#pragma once

#include "reference/chain/loops/row.hpp"

namespace halfway::reference::chain::detail {

/// u_j = y - X u_(j+1): y in the seventh column.
template <class Isa>
struct Factors {
  Row<Isa> row[6];
};

/// D - A [X | y], D's seventh column the residual's.
/// @param A  entry e at A[e * stride]; opposite: nullptr, or of the first three columns the opposite
template <class Isa>
HALFWAY_INLINE void subtract(const double* A, const double* opposite, int stride, const Factors<Isa>& f,
                             Row<Isa> (&D)[6]) {
  using R = Row<Isa>;
  for (int r = 0; r < 6; ++r) {
    const auto times = [&](const double* from, int k)
                           HALFWAY_INLINE_LAMBDA { return R::all(from[(6 * r + k) * stride]) * f.row[k]; };
    const R last = times(A, 3) + times(A, 4) + times(A, 5);
    if (opposite == nullptr)
      D[r] = D[r] - times(A, 0) - times(A, 1) - times(A, 2) - last;
    else
      D[r] = D[r] + times(opposite, 0) + times(opposite, 1) + times(opposite, 2) - last;
  }
}

/// The row of the largest entry in a column, from the diagonal on, changes places with the diagonal's.
template <int k, class Isa, class... Rows>
HALFWAY_INLINE void bring_pivot(Row<Isa> (&S)[6], Rows&... others) {
  int best = k;
  for (int i = k + 1; i < 6; ++i) {
    if (S[i].size().at(k) > S[best].size().at(k)) best = i;
  }
  const auto swap = [best](auto& rows) {
    const auto kept = rows[k];
    rows[k] = rows[best], rows[best] = kept;
  };
  swap(S), (swap(others), ...);
}

template <int k, class Isa, class... Rows>
HALFWAY_INLINE void eliminate_column(Row<Isa> (&S)[6], Rows&... others) {
  using R = Row<Isa>;
  bring_pivot<k>(S, others...);
  const R inverse = R::all(1.) / S[k].template splat<k>();
  S[k] = S[k] * inverse;
  ((others[k] = others[k] * inverse), ...);
  for (int i = 0; i < 6; ++i) {
    if (i == k) continue;
    const R factor = S[i].template splat<k>();
    S[i] = S[i] - factor * S[k];
    ((others[i] = others[i] - factor * others[k]), ...);
  }
}

/// Two columns at a time, by the inverse of their 2 x 2 block: half as many divisions wait for one another.
/// The last two leave S alone, of which nothing is read any more.
template <int k, class Isa, class... Rows>
HALFWAY_INLINE void eliminate_pair(Row<Isa> (&S)[6], Rows&... others) {
  using R = Row<Isa>;
  const R a = S[k].template splat<k>(), b = S[k].template splat<k + 1>();
  const R c = S[k + 1].template splat<k>(), d = S[k + 1].template splat<k + 1>();
  const R inverse = R::all(1.) / (a * d - b * c);
  const auto divide = [&](auto& rows) HALFWAY_INLINE_LAMBDA {
    const R first = d * rows[k] - b * rows[k + 1], second = a * rows[k + 1] - c * rows[k];
    rows[k] = first * inverse, rows[k + 1] = second * inverse;
  };
  if constexpr (k < 4) divide(S);
  (divide(others), ...);
  for (int i = 0; i < 6; ++i) {
    if (i == k || i == k + 1) continue;
    const R first = S[i].template splat<k>(), second = S[i].template splat<k + 1>();
    const auto subtract_from = [&](auto& rows) HALFWAY_INLINE_LAMBDA {
      rows[i] = rows[i] - first * rows[k] - second * rows[k + 1];
    };
    if constexpr (k < 4) subtract_from(S);
    (subtract_from(others), ...);
  }
}

/// S^-1 times the rows beside it (Gauss and Jordan); S is spoilt.
template <bool pivoted, class Isa, class... Rows>
HALFWAY_INLINE void solve(Row<Isa> (&S)[6], Rows&... others) {
  if constexpr (!pivoted) {
    eliminate_pair<0>(S, others...), eliminate_pair<2>(S, others...), eliminate_pair<4>(S, others...);
  } else {
    eliminate_column<0>(S, others...), eliminate_column<1>(S, others...), eliminate_column<2>(S, others...);
    eliminate_column<3>(S, others...), eliminate_column<4>(S, others...), eliminate_column<5>(S, others...);
  }
}

}  // namespace halfway::reference::chain::detail
