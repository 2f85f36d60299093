// Back along the chain: increments of all links from the last one's.
#pragma once

#include "reference/chain/loops/row.hpp"
#include "reference/chain/loops/sweep.hpp"

namespace halfway::reference::chain::detail {

/// Sums of six rows, each in its column; columns 6 and 7 hold anything.
template <class Isa>
HALFWAY_INLINE Row<Isa> sums(const Row<Isa> (&p)[6]) {
  if constexpr (Row<Isa>::kParts == 1) {
    using V = typename Row<Isa>::Part::V;
    const auto halves = [](const V& a, const V& b) HALFWAY_INLINE_LAMBDA -> V {
      return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
             __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    };
    const auto quarters = [](const V& a, const V& b) HALFWAY_INLINE_LAMBDA -> V {
      return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13) +
             __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    };
    const auto row = [&](int r) HALFWAY_INLINE_LAMBDA { return p[r].part[0].v; };
    const V a = quarters(halves(row(0), row(1)), halves(row(2), row(3))), b = halves(row(4), row(5));
    const V c = quarters(b, b);
    return {typename Row<Isa>::Part(V(__builtin_shufflevector(a, c, 0, 1, 2, 3, 8, 9, 10, 11) +
                                      __builtin_shufflevector(a, c, 4, 5, 6, 7, 12, 13, 14, 15)))};
  } else {
    Row<Isa> out = Row<Isa>::all(0.);
    for (int r = 0; r < 6; ++r) {
      double sum = 0;
      for (int c = 0; c < 7; ++c) sum += p[r].at(c);
      out.set(r, sum);
    }
    return out;
  }
}

/// u_j = y - X u_(j+1), towards the root.
template <class Isa>
void substitute(const Links& links, const double (&last)[6], double (&largest)[6]) {
  using R = Row<Isa>;
  R u{}, seventh{};
  seventh.set(6, 1);
  for (int c = 0; c < 6; ++c) u.set(c, last[c]);
  R most = u.size();
  u.store(links.increment + kIncrement * links.count);
  for (long j = links.count - 1; j >= 1; --j) {
    const R v = (-u).with_seventh(seventh);
    const double* const from = links.factors + kFactors * j;
    R products[6];
    for (int r = 0; r < 6; ++r) products[r] = v * R::load(from + 7 * r);
    u = sums<Isa>(products);
    u.store(links.increment + kIncrement * j);
    most = most.larger(u.size());
  }
  // A NaN goes on to the first link, whatever `most` remembers.
  for (int c = 0; c < 6; ++c) largest[c] = u.at(c) == u.at(c) ? most.at(c) : u.at(c);
}

}  // namespace halfway::reference::chain::detail
