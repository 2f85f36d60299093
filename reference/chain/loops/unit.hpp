// Sweeps along a chain in one instruction set; included only by the generated units.
#pragma once

#include "reference/chain/loops/chunk.hpp"
#include "reference/chain/loops/elimination.hpp"
#include "reference/chain/loops/substitute.hpp"

namespace halfway::reference::chain::detail {

/// What a sweep does with each chunk of joints.
enum class Sweep { balance, eliminate, eliminate_any, eliminate_pivoted, reduce };

template <class Isa, Sweep what>
class Along {
  using R = Row<Isa>;
  static constexpr bool kPivoted = what == Sweep::eliminate_pivoted;
  static constexpr bool kWhole = kPivoted || what == Sweep::eliminate_any;
  static constexpr bool kTangent = kWhole || what == Sweep::eliminate;

 public:
  Along(const Links& links, const Evaluation& how, AtTip& tip)
      : links_(links), tip_(tip), chunk_(links, how) {}

  void run(double scale) {
    for (long first = 1; first <= links_.count; first += kChunk) {
      const long left = links_.count - first + 1;
      const int count = left < kChunk ? int(left) : kChunk;
      chunk_.advance(first, count, scale);
      take_balance(first, count);
      if constexpr (kTangent)
        eliminate_chunk(first, count);
      else if constexpr (what == Sweep::reduce)
        reduce_chunk(first, count);
    }
    finish();
  }

 private:
  /// What is not in balance on the links before the joints, and how large the loads are.
  void take_balance(long first, int count) {
    for (int c = 0; c < 6; ++c) {
      const R load = R::load(&t_.QA[c][0]), sum = R::load(&t_.QB[c][kBefore]) + load;
      sum_[c] = -sum;
      if constexpr (what == Sweep::balance) {
        alignas(64) double sizes[kChunk];
        sum.size().store(sizes);
        for (int i = first == 1; i < count; ++i) larger(sizes[i], tip_.imbalance[c]);
        load.size().store(sizes);
        for (int i = 0; i < count; ++i) larger(sizes[i], tip_.largest[c]);
      }
    }
  }
  /// A NaN stays.
  static void larger(double x, double& most) {
    if (!(x <= most)) most = x;
  }

  void eliminate_chunk(long first, int count) {
    alignas(64) R D[6][8], C[6][8];
    blocks(D, C);
    Factors<Isa> last = last_;
    R growth[2]{growth_, R{}};
    for (int i = first == 1; i < count; ++i) {
      R S[6], X[6];
      for (int r = 0; r < 6; ++r) S[r] = D[r][i], X[r] = C[r][i];
      subtract<Isa>(&t_.BA[0][kBefore + i], kWhole ? nullptr : &t_.BB[0][kBefore + i], kLagged, last, S);
      for (int r = 0; r < 6; ++r) X[r] = X[r].with_seventh(S[r]);
      if (!kWhole || links_.kept == nullptr) {
        solve<kPivoted>(S, X);
      } else {
        R inverse[6];
        for (int r = 0; r < 6; ++r) inverse[r] = unit(r);
        solve<kPivoted>(S, X, inverse);
        keep(first + i - 1, inverse, &t_.BA[0][kBefore + i]);
      }
      double* const to = links_.factors + kFactors * (first + i - 1);
      for (int r = 0; r < 6; ++r) {
        growth[r % 2] = growth[r % 2] + X[r] * X[r];
        last.row[r] = X[r];
        last.row[r].store(to + 7 * r);
      }
      to[kFactors] = 0;  // the eighth column of the last row is read, and counts for nothing
    }
    last_ = last;
    growth_ = growth[0] + growth[1];
  }

  /// Rows of the links before the joints: [D | residual] and [C | 0].
  void blocks(R (&D)[6][8], R (&C)[6][8]) const {
    for (int r = 0; r < 6; ++r) {
      R rows[8]{};
      for (int c = 0; c < 6; ++c)
        rows[c] = R::load(&t_.BB[6 * r + c][kBefore]) + R::load(&t_.AA[6 * r + c][0]);
      rows[6] = sum_[r];
      transpose(rows, D[r]);
      R right[8]{};
      for (int c = 0; c < 6; ++c) right[c] = R::load(&t_.AB[6 * r + c][0]);
      transpose(right, C[r]);
    }
  }

  static R unit(int r) {
    R out{};
    out.set(r, 1);
    return out;
  }

  void keep(long link, const R (&inverse)[6], const double* A) {
    double* const to = links_.kept + kKept * link;
    for (int r = 0; r < 6; ++r) {
      for (int c = 0; c < 6; ++c) {
        double sum = 0;
        for (int k = 0; k < 6; ++k) sum += inverse[r].at(k) * A[(6 * k + c) * kLagged];
        to[12 * r + c] = inverse[r].at(c), to[12 * r + 6 + c] = sum;
      }
    }
  }

  /// y_j = S^-1 (residual - A y_(j-1)) with what was kept.
  void reduce_chunk(long first, int count) {
    for (int i = first == 1; i < count; ++i) {
      const long link = first + i - 1;
      const double* const kept = links_.kept + kKept * link;
      double y[6];
      for (int r = 0; r < 6; ++r) {
        y[r] = 0;
        for (int c = 0; c < 6; ++c) y[r] += kept[12 * r + c] * sum_[c].at(i) - kept[12 * r + 6 + c] * y_[c];
      }
      for (int r = 0; r < 6; ++r) links_.factors[kFactors * link + 7 * r + 6] = y_[r] = y[r];
    }
  }

  void finish() {
    for (int c = 0; c < 3; ++c) tip_.x[c] = chunk_.position(c);
    for (int i = 0; i < 6; ++i) tip_.growth += growth_.at(i);
    const int at = kFirst + int((links_.count - 1) % kChunk);
    for (int r = 0; r < 6; ++r) {
      tip_.residual[r] = -t_.QB[r][at];
      if constexpr (what == Sweep::balance)
        larger(t_.QB[r][at] < 0 ? -t_.QB[r][at] : t_.QB[r][at], tip_.largest[r]);
      if constexpr (kTangent) finish_row(r, at);
      for (int k = 0; what == Sweep::reduce && k < 6; ++k) tip_.residual[r] -= links_.kept[6 * r + k] * y_[k];
    }
  }
  /// What the others leave of the last link's row; its A is kept at link 0, which has none.
  void finish_row(int r, int at) {
    for (int k = 0; k < 6; ++k) {
      const double a = chunk_.before(6 * r + k, at);
      tip_.residual[r] -= a * last_.row[k].at(6);
      double s = t_.BB[6 * r + k][at];
      for (int l = 0; l < 6; ++l) s -= chunk_.before(6 * r + l, at) * last_.row[l].at(k);
      tip_.S[6 * r + k] = s;
      if (links_.kept != nullptr) links_.kept[6 * r + k] = a;
    }
  }

  const Links& links_;
  AtTip& tip_;
  Chunk<Isa, kTangent, kWhole> chunk_;
  const Tables& t_ = chunk_.tables();
  Factors<Isa> last_{};
  R growth_{}, sum_[6];
  double y_[6]{};
};

template <class Isa, Sweep what>
void sweep(const Links& links, const Evaluation& how, double scale, AtTip& tip) {
  tip = {};
  Along<Isa, what> along(links, how, tip);
  along.run(scale);
}

template <class Isa>
constexpr Sweeps make_sweeps() {
  return {sweep<Isa, Sweep::eliminate>,         sweep<Isa, Sweep::eliminate_any>,
          sweep<Isa, Sweep::eliminate_pivoted>, sweep<Isa, Sweep::reduce>,
          sweep<Isa, Sweep::balance>,           substitute<Isa>};
}

}  // namespace halfway::reference::chain::detail
