// Eight joints after eight, moved and evaluated, in one instruction set.
#pragma once

#include "reference/chain/loops/stage.hpp"

namespace halfway::reference::chain::detail {

/// @tparam with_tangent  blocks of the tangent as well; whole: all columns of BA (Stage::put_tangent)
template <class Isa, bool with_tangent, bool whole>
class Chunk {
  using P = Pack<double, Isa>;
  using R = Row<Isa>;

 public:
  Chunk(const Links& links, const Evaluation& how) : links_(links), how_(how) {
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

  /// The next joints: `count` of them, from `first` on.
  void advance(long first, int count, double scale) {
    read(first, count);
    if (how_.rod.length == 0)
      move<false>(first, count, scale);
    else
      move_rod(first, count, scale);
    evaluate();
  }

  /// From the first link's rear end to the last one's.
  double position(int c) const {
    double sum = 0;
    for (int i = 0; i < 8; ++i) sum += position_[c].at(i) - lost_[c].at(i);
    return sum;
  }
  /// Of BA.
  double before(int entry, int at) const {
    return whole || entry % 6 >= 3 ? t_.BA[entry][at] : -t_.BB[entry][at];
  }
  const Tables& tables() const { return t_; }

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
    if constexpr (with_tangent) lag(t_.BB), lag(t_.BA);
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

  /// Out of line: chains of other joints are to keep their registers.
  [[gnu::noinline]] void move_rod(long first, int count, double scale) { move<true>(first, count, scale); }

  /// @tparam is_rod  joints see a rod's strains
  template <bool is_rod>
  void move(long first, int count, double scale) {
    const Stage<P> stage{links_, how_, t_};
    for (int i = 0; is_rod && i < kChunk; i += P::kLanes) stage.see(i, P(scale));
    for (int i = 0; i < kChunk; i += P::kLanes) stage.move(i, P(scale));
    for (int i = 0; is_rod && i < kChunk; i += P::kLanes) stage.take_seen(i);
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
    if constexpr (with_tangent) {
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
      if (whole && how_.symmetrised) symmetrise();
      if (!how_.foreign) return;
    }
    how_.loads(job_);
    for (int i = 0; i < kChunk; i += P::kLanes) stage.carry_loads(i);
  }
  template <Kept kept>
  static void tangent(const Stage<P>& stage) {
    for (int i = 0; i < kChunk; i += P::kLanes)
      stage.carry_loads(i), stage.template put_tangent<kept, whole>(i);
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

  const Links& links_;
  const Evaluation& how_;
  Tables t_;
  batch::detail::Job<double> job_;
  R position_[3]{}, lost_[3]{};
};

}  // namespace halfway::reference::chain::detail
