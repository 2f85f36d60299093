// The frame xi in which a law sees the joint: its matrix, its share of the relative spin, and the
// rate that a measure parallel to the rotation vector has in it.
#pragma once

#include "halfway/joint/frames.hpp"
#include "halfway/kernels/measures.hpp"
#include "halfway/kernels/spins.hpp"

namespace halfway::kernel {

/// In frame a the rate of e = eta v is that of the half-way frame turned by -phi/2; in frame b by +phi/2.
template <class T>
struct NodeAFrame {
  M3<T> F;
  [[no_unique_address]] NoSpin spin;
  HALFWAY_INLINE Axial<T> rate(const Relative<T>& r, const Measured<T>& m) const {
    return {m.beta * r.w, -m.beta, m.delta, r.g};
  }
};

template <class T>
struct NodeBFrame {
  M3<T> F;
  [[no_unique_address]] FullSpin spin;
  HALFWAY_INLINE M3<T> from_a(const Relative<T>& r) const { return matrix(Quat<T>{r.w, r.v}); }
  HALFWAY_INLINE Axial<T> rate(const Relative<T>& r, const Measured<T>& m) const {
    return {m.beta * r.w, m.beta, m.delta, r.g};
  }
};

template <class T>
struct HalfwayFrame {
  M3<T> F;
  HalfSpin<T> spin;
  HALFWAY_INLINE M3<T> from_a(const Relative<T>& r) const { return matrix(Quat<T>{T(1) + r.w, r.v}, r.iw); }
  HALFWAY_INLINE SymmetricAxial<T> rate(const Relative<T>& r, const Measured<T>& m) const {
    return {m.beta, m.gamma, r.g};
  }
};

template <class T>
struct WeightedFrame {
  M3<T> F;
  M3<T> Q;  ///< this frame in the axes of a
  WeightedSpin<T> spin;
  HALFWAY_INLINE const M3<T>& from_a(const Relative<T>&) const { return Q; }
  T cosine, sine;  ///< cos((xi - 1/2) phi) and sin((xi - 1/2) phi) / sin(phi/2)
  T around;        ///< (1 - cosine) / sin(phi/2)^2
  HALFWAY_INLINE Axial<T> rate(const Relative<T>& r, const Measured<T>& m) const {
    return {m.beta * cosine, m.beta * sine, m.gamma + m.beta * around, r.g};
  }
};

/// `with_tangent` false: the rates of the spin are left out.
template <bool with_tangent, class T>
HALFWAY_INLINE NodeAFrame<T> frame(const FrameA&, const Relative<T>& r, const AngleJet<T>&) {
  return {matrix(r.a), {}};
}
template <bool with_tangent, class T>
HALFWAY_INLINE NodeBFrame<T> frame(const FrameB&, const Relative<T>& r, const AngleJet<T>&) {
  return {matrix(r.b), {}};
}
template <bool with_tangent, class T>
HALFWAY_INLINE HalfwayFrame<T> frame(const FrameHalfway&, const Relative<T>& r, const AngleJet<T>&) {
  return {r.halfway(), {r.iw * r.g, T(0.25) * r.iw}};
}

/// The quaternion (c, sine v) of xi theta: c = cos(xi phi/2), sine = sin(xi phi/2)/sin(phi/2), its
/// derivative by w, and rest = (xi - c sine w)/sin(phi/2)^2 without cancellation.
/// |xi| > 1 by doubling, decided by xi alone.
template <class T>
struct PartialTurn {
  T c, sine, sine_w, rest;
};
template <class T>
HALFWAY_INLINE PartialTurn<T> partial_turn(double xi, const Relative<T>& r, const AngleJet<T>& j) {
  int doublings = 0;
  double part = xi;
  for (; part > 1 || part < -1; part /= 2) ++doublings;
  const T x(part), xx(part * part);
  const T half_h = T(0.5) * j.h;
  const T over = xx * (half_h * half_h);  // of (part phi/2)^2 = over sin(phi/2)^2
  const SineJet<T> s = sine_jet<T>(over * r.s2);
  PartialTurn<T> out;
  out.c = s.c;
  out.sine = x * half_h * s.s;
  out.sine_w = -x * (j.d * s.s + T(2) * over * s.s1);  // d(phi/2)^2/dw = -h
  // w h/2 = 1 - d sin(phi/2)^2 and s c = 1 + y (s2 (s + 1) + 2 s s1).
  out.rest = x * (j.d * s.s * s.c - over * (s.s2 * (s.s + T(1)) + T(2) * s.s * s.s1));
  T c_w = x * out.sine;
  for (; doublings > 0; --doublings) {
    out.rest = T(2) * (out.rest + T(2) * (out.sine * out.sine) * out.sine * out.c * r.w);
    out.sine_w = T(2) * (c_w * out.sine + out.c * out.sine_w);
    c_w = T(4) * out.c * c_w;
    out.sine = T(2) * out.c * out.sine;
    out.c = T(2) * out.c * out.c - T(1);
  }
  return out;
}

template <bool with_tangent, class T>
HALFWAY_INLINE WeightedFrame<T> frame(const FrameWeighted& f, const Relative<T>& r, const AngleJet<T>& j) {
  const PartialTurn<T> turn = partial_turn<T>(f.xi, r, j);
  const T c = turn.c, u = turn.sine, xi(f.xi);
  const T is2 = T(1) / (r.s2 + tiny<T>());
  WeightedFrame<T> out;
  const Quat<T> q{c, u * r.v};
  out.F = matrix(r.a * q);
  out.Q = matrix(q);
  // A = (exp(xi X) - 1)/(exp(X) - 1), X = [theta], on the plane of the rotation and along its axis.
  auto& A = out.spin;
  A.g = r.g;
  A.p = u * (c * r.w + u * r.s2);
  A.q = u * (u * r.w - c);
  A.r = turn.rest - u * u;
  if constexpr (with_tangent) {
    const T u_w = turn.sine_w, c_w = xi * u;
    A.p_w = u_w * (c * r.w + u * r.s2) + u * (c_w * r.w + c + u_w * r.s2 - T(2) * u * r.w);
    A.q_w = u_w * (u * r.w - c) + u * (u_w * r.w + u - c_w);
    A.r_w = (T(2) * r.w * A.r - A.p_w) * is2;
    // psi = (2 xi - 1) phi/2: twice the partial turn less half the whole one.
    const T c2 = T(2) * c * c - T(1), u2 = T(2) * c * u;
    out.cosine = c2 * r.w + u2 * r.s2;
    out.sine = u2 * r.w - c2;
    out.around = (T(1) - out.cosine) * is2;
    const T half(0.5);
    const Measured<T> quaternion{.beta = half, .gamma = -half * r.iw, .delta = T(0)};
    A.vector_rate = out.rate(r, quaternion);
  }
  return out;
}

}  // namespace halfway::kernel
