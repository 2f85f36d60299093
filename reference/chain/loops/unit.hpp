// Sweeps along a chain in one instruction set; included only by the generated units.
#pragma once

#include "reference/chain/loops/elimination.hpp"
#include "reference/chain/loops/stage.hpp"

namespace halfway::reference::chain::detail {

/// What a sweep does with each chunk of joints after it was moved.
enum class Sweep { balance, eliminate, eliminate_any, eliminate_pivoted, reduce };

template <class Isa, Sweep what>
class Along {
  using P = Pack<double, Isa>;
  using R = Row<Isa>;
  static constexpr bool kPivoted = what == Sweep::eliminate_pivoted;
  static constexpr bool kWhole = kPivoted || what == Sweep::eliminate_any;
  static constexpr bool kTangent = kWhole || what == Sweep::eliminate;

 public:
  Along(const Links& links, const Evaluation& how, AtTip& tip) : links_(links), how_(how), tip_(tip) {
    for (auto& row : t_.zero) {
      for (double& x : row) x = 0;
    }
    for (auto& row : t_.u) row[kFirst + kChunk - 1] = 0;  // link 0
    for (int c = 0; c < 4; ++c) {
      t_.q_old[c][kFirst + kChunk - 1] = t_.q[c][kFirst + kChunk - 1] = links.q.first[c * links.q.stride];
    }
    for (auto& row : t_.BA) row[kFirst + kChunk - 1] = 0;
    for (auto& row : t_.BB) row[kFirst + kChunk - 1] = 0;
    for (auto& row : t_.QB) row[kFirst + kChunk - 1] = 0;
    job_ = how.job;
    job_.count = kChunk;
    job_.q_a = {t_.q_a[0], kChunk}, job_.q_b = {t_.q_b[0], kChunk};
    job_.x_a = {t_.zero[0], kChunk}, job_.x_b = {t_.D[0], kChunk};
    job_.loads = {t_.loads[0], kChunk}, job_.tangent = {t_.tangent[0], kChunk};
  }

  void run(double scale) {
    for (long first = 1; first <= links_.count; first += kChunk) {
      const long left = links_.count - first + 1;
      const int count = left < kChunk ? int(left) : kChunk;
      read(first, count);
      move(first, count, scale);
      evaluate();
      take_balance(first, count);
      if constexpr (kTangent)
        eliminate_chunk(first, count);
      else if constexpr (what == Sweep::reduce)
        reduce_chunk(first, count);
    }
    finish();
  }

 private:
  /// The last column of a lagged row comes before the first one.
  template <int rows>
  static void lag(double (&table)[rows][kLagged]) {
    for (auto& row : table) row[kBefore] = row[kLagged - 1];
  }

  /// What is beyond the last link stays with it.
  template <int rows>
  static void fill_up(double (&table)[rows][kLagged], int count) {
    for (auto& row : table) {
      for (int i = count; i < kChunk; ++i) row[kFirst + i] = row[kFirst + count - 1];
    }
  }

  void read(long first, int count) {
    lag(t_.q_old), lag(t_.q), lag(t_.u), lag(t_.QB);
    if constexpr (kTangent) lag(t_.BB), lag(t_.BA);
    for (int c = 0; c < 4; ++c)
      R::load(links_.q.first + c * links_.q.stride + first).store(&t_.q_old[c][kFirst]);
    for (int c = 0; c < 3; ++c) R::load(links_.d.first + c * links_.d.stride + first).store(&t_.d[c][0]);
    R rows[8], columns[8];
    for (int i = 0; i < 8; ++i) rows[i] = R::load(links_.increment + kIncrement * (first + i));
    transpose(rows, columns);
    for (int c = 0; c < 6; ++c) columns[c].store(&t_.u[c][kFirst]);
    if (count == kChunk) return;
    fill_up(t_.q_old, count), fill_up(t_.u, count);
    for (auto& row : t_.d) {
      for (int i = count; i < kChunk; ++i) row[i] = 0;
    }
  }

  void move(long first, int count, double scale) {
    const Stage<P> stage{links_, how_, t_};
    for (int i = 0; i < kChunk; i += P::kLanes) stage.move(i, P(scale));
    for (int c = 0; c < 4; ++c) R::load(&t_.q[c][kFirst]).store(links_.q.first + c * links_.q.stride + first);
    for (int c = 0; c < 3; ++c) R::load(&t_.d[c][0]).store(links_.d.first + c * links_.d.stride + first);
    for (int i = 0; i < kChunk; i += P::kLanes) stage.place(i);
    alignas(64) double steps[3][kChunk];
    for (int i = 0; i < kChunk; i += P::kLanes) put(stage.step(i), &steps[0][i], kChunk);
    for (int c = 0; c < 3; ++c) {
      if (count < kChunk) {
        for (int i = count; i < kChunk; ++i) steps[c][i] = 0;
      }
      add(R::load(steps[c]), position_[c], lost_[c]);
    }
  }
  /// Compensated.
  static HALFWAY_INLINE void add(const R& x, R& sum, R& lost) {
    const R y = x - lost, next = sum + y;
    lost = (next - sum) - y;
    sum = next;
  }

  void evaluate() {
    const Stage<P> stage{links_, how_, t_};
    if constexpr (kTangent) {
      how_.tangent(job_);
      switch (how_.kept) {
        case Kept::all:
          tangent<Kept::all>(stage);
          break;
        case Kept::general:
          tangent<Kept::general>(stage);
          break;
        case Kept::conservative:
          tangent<Kept::conservative>(stage);
      }
      if (kWhole && how_.symmetrised) symmetrise();
      if (!how_.foreign) return;
    }
    how_.loads(job_);
    for (int i = 0; i < kChunk; i += P::kLanes) stage.carry_loads(i);
  }
  template <Kept kept>
  static void tangent(const Stage<P>& stage) {
    for (int i = 0; i < kChunk; i += P::kLanes)
      stage.carry_loads(i), stage.template put_tangent<kept, kWhole>(i);
  }

  void symmetrise() {
    const P half(0.5);
    for (int i = 0; i < kChunk; i += P::kLanes) {
      for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 6; ++c) {
          double *const ab = &t_.AB[6 * r + c][i], *const ba = &t_.BA[6 * c + r][kFirst + i];
          const P mean = half * (P::load(ab) + P::load(ba));
          mean.store(ab), mean.store(ba);
          if (c <= r) continue;
          both(half, &t_.AA[6 * r + c][i], &t_.AA[6 * c + r][i]);
          both(half, &t_.BB[6 * r + c][kFirst + i], &t_.BB[6 * c + r][kFirst + i]);
        }
      }
    }
  }
  static HALFWAY_INLINE void both(const P& half, double* a, double* b) {
    const P mean = half * (P::load(a) + P::load(b));
    mean.store(a), mean.store(b);
  }

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

  /// Of BA.
  double before(int entry, int at) const {
    return kWhole || entry % 6 >= 3 ? t_.BA[entry][at] : -t_.BB[entry][at];
  }

  void finish() {
    const int at = kFirst + int((links_.count - 1) % kChunk);
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (int i = 0; i < 8; ++i) sum += position_[c].at(i) - lost_[c].at(i);
      tip_.x[c] = sum;
    }
    for (int i = 0; i < 8; ++i) tip_.growth += i < 6 ? growth_.at(i) : 0;
    for (int r = 0; r < 6; ++r) {
      tip_.residual[r] = -t_.QB[r][at];
      if constexpr (what == Sweep::balance) {
        larger(t_.QB[r][at] < 0 ? -t_.QB[r][at] : t_.QB[r][at], tip_.largest[r]);
      } else {
        for (int k = 0; k < 6; ++k) {
          const double a = before(6 * r + k, at);
          if constexpr (what == Sweep::reduce) {
            tip_.residual[r] -= links_.kept[6 * r + k] * y_[k];
          } else {
            tip_.residual[r] -= a * last_.row[k].at(6);
            double s = t_.BB[6 * r + k][at];
            for (int l = 0; l < 6; ++l) s -= before(6 * r + l, at) * last_.row[l].at(k);
            tip_.S[6 * r + k] = s;
            if (links_.kept != nullptr) links_.kept[6 * r + k] = a;
          }
        }
      }
    }
  }

  const Links& links_;
  const Evaluation& how_;
  AtTip& tip_;
  Tables t_;
  batch::detail::Job<double> job_;
  Factors<Isa> last_{};
  R growth_{}, sum_[6], position_[3]{}, lost_[3]{};
  double y_[6]{};
};

template <class Isa, Sweep what>
void sweep(const Links& links, const Evaluation& how, double scale, AtTip& tip) {
  tip = {};
  Along<Isa, what> along(links, how, tip);
  along.run(scale);
}

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

template <class Isa>
constexpr Sweeps make_sweeps() {
  return {sweep<Isa, Sweep::eliminate>,         sweep<Isa, Sweep::eliminate_any>,
          sweep<Isa, Sweep::eliminate_pivoted>, sweep<Isa, Sweep::reduce>,
          sweep<Isa, Sweep::balance>,           substitute<Isa>};
}

}  // namespace halfway::reference::chain::detail
