// The laws of a batch: numbers in tables, shared or one column per joint.
#pragma once

#include "halfway/batch/loops/job.hpp"
#include "halfway/batch/loops/pack.hpp"
#include "halfway/kernels/laws.hpp"

#include <initializer_list>

namespace halfway::batch::detail {

/// The law's numbers of one pack of joints, read where they are used.
template <class P, class Number>
struct Numbers {
  const Number* first;
  long stride;
  HALFWAY_INLINE P operator()(int i) const { return P::load(first + i * stride); }
};

/// Linear: the upper triangle of K by rows. Odd polynomial: k1, k3, k5, of all axes each.
template <class P, class Number>
struct LinearLaw3 {
  static constexpr bool kLinear = true;
  Numbers<P, Number> k;

  HALFWAY_INLINE kernel::S3<P> stiffness(const kernel::V3<P>&) const {
    return {k(0), k(1), k(2), k(3), k(4), k(5)};
  }
  HALFWAY_INLINE kernel::V3<P> stress(const kernel::V3<P>& e) const { return stiffness(e) * e; }
};

template <class P, class Number>
struct LinearLaw6 {
  static constexpr bool kLinear = true;
  Numbers<P, Number> k;

  HALFWAY_INLINE kernel::Stiffness6<P> stiffness(const kernel::Pair<P>&) const {
    return {{k(0), k(1), k(2), k(6), k(7), k(11)},
            {{k(3), k(4), k(5)}, {k(8), k(9), k(10)}, {k(12), k(13), k(14)}},
            {k(15), k(16), k(17), k(18), k(19), k(20)}};
  }
  HALFWAY_INLINE kernel::Pair<P> stress(const kernel::Pair<P>& e) const {
    const kernel::Stiffness6<P> K = stiffness(e);
    return {K.ff * e.f + K.fm * e.m, e.f * K.fm + K.mm * e.m};
  }
};

/// Linear, of joints whose translation and rotation are not coupled: the same table.
template <class P, class Number>
HALFWAY_INLINE kernel::BlockDiagonal6<P> block_diagonal(const Numbers<P, Number>& k) {
  return {{{k(0), k(1), k(2), k(6), k(7), k(11)}}, {{k(15), k(16), k(17), k(18), k(19), k(20)}}};
}

/// Is the coupling of every joint zero?
template <class Number>
bool uncoupled(const Job<Number>& job) {
  const long laws = job.law_step == 0 ? 1 : job.count;
  bool coupled = false;
  for (const int row : {3, 4, 5, 8, 9, 10, 12, 13, 14}) {
    const Number* const k = job.law.first + row * job.law.stride;
    for (long i = 0; i < laws; ++i) coupled |= k[i] != Number(0);
  }
  return !coupled;
}

/// Either law: which, is decided once a pack, the same for all of a batch.
template <class P, class Number>
struct AnyLaw3 {
  static constexpr bool kLinear = false;
  Numbers<P, Number> k;
  bool polynomial;

  HALFWAY_INLINE kernel::Polynomial3<P> odd() const {
    return {{k(0), k(1), k(2)}, {k(3), k(4), k(5)}, {k(6), k(7), k(8)}};
  }
  HALFWAY_INLINE kernel::V3<P> stress(const kernel::V3<P>& e) const {
    return polynomial ? odd().stress(e) : LinearLaw3<P, Number>{k}.stress(e);
  }
  HALFWAY_INLINE kernel::S3<P> stiffness(const kernel::V3<P>& e) const {
    return polynomial ? odd().stiffness(e) : LinearLaw3<P, Number>{k}.stiffness(e);
  }
};

template <class P, class Number>
struct AnyLaw6 {
  static constexpr bool kLinear = false;
  Numbers<P, Number> k;
  bool polynomial;

  HALFWAY_INLINE kernel::Polynomial6<P> odd() const {
    return {{{k(0), k(1), k(2)}, {k(6), k(7), k(8)}, {k(12), k(13), k(14)}},
            {{k(3), k(4), k(5)}, {k(9), k(10), k(11)}, {k(15), k(16), k(17)}}};
  }
  HALFWAY_INLINE kernel::Pair<P> stress(const kernel::Pair<P>& e) const {
    return polynomial ? odd().stress(e) : LinearLaw6<P, Number>{k}.stress(e);
  }
  HALFWAY_INLINE kernel::Stiffness6<P> stiffness(const kernel::Pair<P>& e) const {
    return polynomial ? odd().stiffness(e) : LinearLaw6<P, Number>{k}.stiffness(e);
  }
};

}  // namespace halfway::batch::detail
