// Eight joints from poses to blocks of the tangent: moved, evaluated, their loads carried to the links.
#pragma once

#include "halfway/kernels/core/loads.hpp"
#include "halfway/kernels/motion.hpp"
#include "reference/chain/loops/rod_strains.hpp"
#include "reference/chain/loops/row.hpp"
#include "reference/chain/loops/sweep.hpp"

namespace halfway::reference::chain::detail {

using halfway::batch::Pack;
using kernel::M3, kernel::Quat, kernel::V3;

/// A quantity of eight links and, at kBefore, of the one before them.
inline constexpr int kFirst = 8, kBefore = kFirst - 1, kLagged = 16;

/// Tables of one chunk. Blocks by rows; D and C eight columns a row: D's seventh is the residual's.
struct Tables {
  alignas(64) double q_old[4][kLagged], q[4][kLagged], u[8][kLagged], d[3][kChunk];
  double seen[3][kChunk];  ///< of d, by joints that see a rod's strains
  double q_a[4][kChunk], q_b[4][kChunk], zero[3][kChunk], D[3][kChunk], loads[9][kChunk], tangent[81][kChunk];
  double BA[36][kLagged], BB[36][kLagged], QB[6][kLagged];
  double AA[36][kChunk], AB[36][kChunk], QA[6][kChunk];
};

template <class P>
HALFWAY_INLINE V3<P> vector_of(const double* row, int stride) {
  return {P::load(row), P::load(row + stride), P::load(row + 2 * stride)};
}
template <class P>
HALFWAY_INLINE Quat<P> quat_of(const double* row, int stride) {
  return {P::load(row), vector_of<P>(row + stride, stride)};
}
template <class P>
HALFWAY_INLINE M3<P> matrix_of(const double* row, int stride) {
  return {vector_of<P>(row, stride), vector_of<P>(row + 3 * stride, stride),
          vector_of<P>(row + 6 * stride, stride)};
}
template <class P>
HALFWAY_INLINE void put(const V3<P>& v, double* row, int stride) {
  v.x.store(row), v.y.store(row + stride), v.z.store(row + 2 * stride);
}
template <class P>
HALFWAY_INLINE void put(const Quat<P>& q, double* row, int stride) {
  q.w.store(row), put(q.v, row + stride, stride);
}
/// Rows of a 3 x 3 block, six blocks' columns apart.
template <class P>
HALFWAY_INLINE void put(const M3<P>& m, double* row, int stride) {
  put(m.x, row, stride), put(m.y, row + 6 * stride, stride), put(m.z, row + 12 * stride, stride);
}
template <class P>
HALFWAY_INLINE V3<P> same(const double (&x)[3]) {
  return {P(x[0]), P(x[1]), P(x[2])};
}

/// exp([w]) q, of unit length: three doublings of a series for an eighth of the angle. Where |w| > 6 it is
/// another rotation about the same axis, and as good an iterate.
template <class P>
HALFWAY_INLINE Quat<P> turned(const V3<P>& w, const Quat<P>& q) {
  const P x = P(1. / 256) * dot(w, w);
  P c = P(1.) - x * (P(1. / 2) - x * (P(1. / 24) - x * (P(1. / 720) - x * P(1. / 40320))));
  P s = P(1. / 16) * (P(1.) - x * (P(1. / 6) - x * (P(1. / 120) - x * (P(1. / 5040) - x * P(1. / 362880)))));
  for (int i = 0; i < 3; ++i) s = P(2.) * (c * s), c = P(2.) * (c * c) - P(1.);
  const Quat<P> r = Quat<P>{c, s * w} * q;
  const P n = P(1.) / sqrt(r.w * r.w + dot(r.v, r.v));
  return {n * r.w, n * r.v};
}

/// Of links i - 1 and i, lanes of one pack.
template <class P>
struct Stage {
  const Links& links;
  const Evaluation& how;
  Tables& t;
  const V3<P> arm = same<P>(links.arm);
  const Quat<P> turn{P(links.turn[0]), V3<P>{P(links.turn[1]), P(links.turn[2]), P(links.turn[3])}};

  /// From the old state to the new one; d moves by its linear increment, the frames by their spins.
  HALFWAY_INLINE void move(int i, const P& scale) const {
    with_increment(i, scale,
                   [&](const auto&, const M3<P>&, const V3<P>& d, const V3<P>& dd, const V3<P>&,
                       const V3<P>& w) HALFWAY_INLINE_LAMBDA {
                     const int b = kFirst + i;
                     put(d + dd, &t.d[0][i], kChunk);
                     put(turned(w, quat_of<P>(&t.q_old[0][b], kLagged)), &t.q[0][b], kLagged);
                   });
  }

  /// Before that, of joints that see a rod's strains: these move by linear increments instead; and d, of
  /// them, after.
  void see(int i, const P& scale) const {
    with_increment(i, scale,
                   [&](const auto& r, const M3<P>& R, const V3<P>& d, const V3<P>& dd, const V3<P>& w_a,
                       const V3<P>& w_b) HALFWAY_INLINE_LAMBDA {
                     put(RodStrains<P>(how.rod).moved(r, d, dd, (w_b - w_a) * R), &t.seen[0][i], kChunk);
                   });
  }
  void take_seen(int i) const {
    const int b = kFirst + i;
    const Quat<P> front = quat_of<P>(&t.q[0][b - 1], kLagged) * turn, at = quat_of<P>(&t.q[0][b], kLagged);
    const V3<P> seen = vector_of<P>(&t.seen[0][i], kChunk);
    put(RodStrains<P>(how.rod).displacement(kernel::relative(front, at), seen), &t.d[0][i], kChunk);
  }

  /// What the joints are evaluated at: points at the origin and at D.
  HALFWAY_INLINE void place(int i) const {
    const int b = kFirst + i;
    const Quat<P> front = quat_of<P>(&t.q[0][b - 1], kLagged) * turn, at = quat_of<P>(&t.q[0][b], kLagged);
    const V3<P> D = kernel::relative(front, at).halfway() * vector_of<P>(&t.d[0][i], kChunk);
    put(how.tip_first ? at : front, &t.q_a[0][i], kChunk);
    put(how.tip_first ? front : at, &t.q_b[0][i], kChunk);
    put(how.tip_first ? -D : D, &t.D[0][i], kChunk);
  }
  /// From a link's rear end to the next one's, global axes.
  HALFWAY_INLINE V3<P> step(int i) const {
    const V3<P> D = vector_of<P>(&t.D[0][i], kChunk);
    return arm_of(i) + (how.tip_first ? -D : D);
  }

  /// Loads on both links about their rear ends.
  HALFWAY_INLINE void carry_loads(int i) const {
    const V3<P> f_b = vector_of<P>(&t.loads[0][i], kChunk), m_a = vector_of<P>(&t.loads[3][i], kChunk),
                m_b = vector_of<P>(&t.loads[6][i], kChunk);
    const V3<P> f = how.tip_first ? -f_b : f_b;
    const int b = kFirst + i;
    put(-f, &t.QA[0][i], kChunk);
    put((how.tip_first ? m_b : m_a) - cross(arm_of(i), f), &t.QA[3][i], kChunk);
    put(f, &t.QB[0][b], kLagged), put(how.tip_first ? m_a : m_b, &t.QB[3][b], kLagged);
  }

  /// @tparam whole  BA's first three columns too: they are the opposite of BB's where nothing is symmetrised
  template <Kept kept, bool whole>
  HALFWAY_INLINE void put_tangent(int i) const {
    By f, m_p, m_n;
    if constexpr (kept == Kept::all)
      carried(i, f, m_p, m_n);
    else
      completed<kept>(i, f, m_p, m_n);
    const int b = kFirst + i;
    put4(&t.BB[0][b], kLagged, f.x, f.next, m_n.x, m_n.next);
    put4(&t.AA[0][i], kChunk, f.x, -f.before, -m_p.x, m_p.before);
    put4(&t.AB[0][i], kChunk, -f.x, -f.next, m_p.x, m_p.next);
    if constexpr (whole)
      put4(&t.BA[0][b], kLagged, -f.x, f.before, -m_n.x, m_n.before);
    else
      put(f.before, &t.BA[3][b], kLagged), put(m_n.before, &t.BA[21][b], kLagged);
  }

 private:
  /// Of a joint in the old state, take(r, half-way frame, d and its increment in that frame, spins of both
  /// links).
  template <class Take>
  HALFWAY_INLINE void with_increment(int i, const P& scale, const Take& take) const {
    const auto spin = [&](int at)
                          HALFWAY_INLINE_LAMBDA { return scale * vector_of<P>(&t.u[3][at], kLagged); };
    const auto shift = [&](int at)
                           HALFWAY_INLINE_LAMBDA { return scale * vector_of<P>(&t.u[0][at], kLagged); };
    const int b = kFirst + i, a = b - 1;
    const Quat<P> before = quat_of<P>(&t.q_old[0][a], kLagged), at = quat_of<P>(&t.q_old[0][b], kLagged);
    const V3<P> w_a = spin(a), w_b = spin(b), d = vector_of<P>(&t.d[0][i], kChunk);
    const auto r = kernel::relative(before * turn, at);
    const M3<P> R = r.halfway();
    const V3<P> w = P(0.5) * (w_a + w_b + r.iw * cross(w_b - w_a, r.g));
    const V3<P> moved = shift(b) - shift(a) - cross(w_a, matrix(before) * arm) - cross(w, R * d);
    take(r, R, d, moved * R, w_a, w_b);
  }
  /// Of one load, by the next link's rear end (by the link's before the opposite, about the joint), and by
  /// the spins of the link before and the next one.
  struct By {
    M3<P> x, before, next;
  };
  HALFWAY_INLINE void carried(int i, By& f, By& m_p, By& m_n) const {
    const V3<P> r = arm_of(i), F = vector_of<P>(&t.QB[0][kFirst + i], kLagged);
    f = derivatives(i, 0), m_n = derivatives(i, how.tip_first ? 1 : 2);
    m_p = derivatives(i, how.tip_first ? 2 : 1);
    m_p.x = m_p.x - skew_times(r, f.x);
    m_p.next = m_p.next - skew_times(r, f.next);
    m_p.before = m_p.before - skew_times(r, f.before) + plus_diagonal(-outer(r, F), dot(r, F));
  }
  /// From the derivatives by the next link: a turn of all about a link's rear end turns the loads, and they
  /// balance.
  template <Kept kept>
  HALFWAY_INLINE void completed(int i, By& f, By& m_p, By& m_n) const {
    const double* const row = t.tangent[0] + i;
    const V3<P> m = vector_of<P>(&t.QB[3][kFirst + i], kLagged);
    kernel::PointLoads<P> l;
    l.f.value = vector_of<P>(&t.QB[0][kFirst + i], kLagged), l.b.value = m;
    l.f.x = full(upper_of(row)), l.f.wb = matrix_of<P>(row + 6 * kChunk, kChunk);
    if constexpr (kept == Kept::conservative) {
      const kernel::S3<P> k = upper_of(row + 15 * kChunk);  // its skew part is -[m] / 2
      l.b.x = transposed(l.f.wb);
      l.b.wb = {{k.xx, k.xy, k.xz}, {k.xy - m.z, k.yy, k.yz}, {k.xz + m.y, k.yz - m.x, k.zz}};
    } else {
      l.b.x = matrix_of<P>(row + 15 * kChunk, kChunk), l.b.wb = matrix_of<P>(row + 24 * kChunk, kChunk);
    }
    kernel::complete<true, kept == Kept::conservative, true>(step(i), l);
    f = {l.f.x, l.f.wa, l.f.wb}, m_p = {l.a.x, l.a.wa, l.a.wb}, m_n = {l.b.x, l.b.wa, l.b.wb};
  }
  HALFWAY_INLINE kernel::S3<P> upper_of(const double* row) const {
    const V3<P> x = vector_of<P>(row, kChunk), y = vector_of<P>(row + 3 * kChunk, kChunk);
    return {x.x, x.y, x.z, y.x, y.y, y.z};
  }
  HALFWAY_INLINE V3<P> arm_of(int i) const {
    return matrix(quat_of<P>(&t.q[0][kFirst + i - 1], kLagged)) * arm;
  }
  HALFWAY_INLINE By derivatives(int i, int load) const {
    const double* const row = &t.tangent[27 * load][i];
    By by{matrix_of<P>(row, kChunk), matrix_of<P>(row + 9 * kChunk, kChunk),
          matrix_of<P>(row + 18 * kChunk, kChunk)};
    if (how.tip_first) {  // the opposite force by the opposite position; moments by the opposite position
      const M3<P> before = by.next;
      by.next = load == 0 ? -by.before : by.before, by.before = load == 0 ? -before : before;
      if (load != 0) by.x = -by.x;
    }
    by.before = by.before + times_skew(by.x, arm_of(i));
    return by;
  }
  static HALFWAY_INLINE void put4(double* row, int stride, const M3<P>& xx, const M3<P>& xw, const M3<P>& wx,
                                  const M3<P>& ww) {
    put(xx, row, stride), put(xw, row + 3 * stride, stride);
    put(wx, row + 18 * stride, stride), put(ww, row + 21 * stride, stride);
  }
};

}  // namespace halfway::reference::chain::detail
