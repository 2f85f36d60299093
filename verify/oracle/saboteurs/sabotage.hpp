// What is done to the loads (f_a, m_a, f_b, m_b) of a healthy formulation and to their tangent.
#pragma once

#include "verify/oracle/saboteurs/wrap.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace halfway::verify::sabotage {

/// NaN in value and derivative: a product, since a constant's derivative is zero.
template <class T>
void spoil(T& x) {
  x = x * T(std::numeric_limits<double>::quiet_NaN());
}

template <int first>  // of the loads: 0 forces, 3 moments
struct PartNan {
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    NodeLoads<T> out = call.loads();
    for (int i = 0; i < 3; ++i) spoil(out.q[first + i]), spoil(out.q[first + 6 + i]);
    return out;
  }
};
struct TangentNan {
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    NodeLoads<T> out = call.loads();
    for (T& x : out.tangent.reshaped()) spoil(x);
    return out;
  }
};

template <class T>
NodeLoads<T> scaled(const Call<T>& call, double factor) {
  NodeLoads<T> out = call.loads();
  out.q *= T(factor);
  out.tangent *= T(factor);
  return out;
}

struct NoLoads {
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    return scaled(call, 0);
  }
};
struct LoadsTooLarge {  // as if its stiffness were another; the energy is the healthy one
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    return scaled(call, 1 + 1e-6);
  }
};
struct TangentOff {  // one entry, so that no symmetry hides it
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    NodeLoads<T> out = call.loads();
    out.tangent(9, 10) += T(1e-6) * out.tangent.norm();
    return out;
  }
};

/// Each vector of the loads by G(pose); `by_a` and `by_b` (load) are the derivatives of G load, for a
/// constant load, by the spins of the nodes.
template <class T, class ByA, class ByB>
NodeLoads<T> turned(const Call<T>& call, const Mat3<T>& G, const ByA& by_a, const ByB& by_b) {
  const NodeLoads<T> healthy = call.loads();
  NodeLoads<T> out;
  for (int i = 0; i < 12; i += 3) {
    const Vec3<T> load = healthy.q.template segment<3>(i);
    out.q.template segment<3>(i) = G * load;
    out.tangent.template middleRows<3>(i) = G * healthy.tangent.template middleRows<3>(i);
    out.tangent.template block<3, 3>(i, 3) += by_a(load);
    out.tangent.template block<3, 3>(i, 9) += by_b(load);
  }
  return out;
}

struct TransposedFrame {  // P_a exp(-theta/2) for P_a exp(theta/2), where the frame is half-way: G = P_a
                          // P_b^T
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    const Mat3<T> P_a = call.a.R * call.spec.a.H.template cast<T>();
    const Mat3<T> P_b = call.b.R * call.spec.b.H.template cast<T>();
    const Mat3<T> G = P_a * P_b.transpose();
    return turned(
        call, G, [&](const Vec3<T>& load) -> Mat3<T> { return -skew<T>(G * load); },
        [&](const Vec3<T>& load) -> Mat3<T> { return G * skew(load); });
  }
};
struct TransposedAxes {  // from the axes of node a by R_a^T for R_a: G = R_a^T R_a^T
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    const Mat3<T> back = call.a.R.transpose(), G = back * back;
    return turned(
        call, G, [&](const Vec3<T>& load) -> Mat3<T> { return back * skew<T>(back * load) + G * skew(load); },
        [](const Vec3<T>&) -> Mat3<T> { return Mat3<T>::Zero(); });
  }
};

template <class T>
RelativeMotion<T> motion(const Call<T>& call) {
  const auto end = [](const JointEnd<double>& e) {
    return JointEnd<T>{e.o.template cast<T>(), e.H.template cast<T>()};
  };
  return full_motion(end(call.spec.a), end(call.spec.b), call.a, call.b);
}

/// The half-way frame turns at half the sum of the spins, as Drake's midpoint has it: moments of the force,
/// and the tangent of the moments of an angular joint, by A - 1/2, A the right spin of the frame.
struct HalfRate {
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    NodeLoads<T> out = call.loads();
    const RelativeMotion<T> m = motion(call);
    const Mat3<T> P_a = call.a.R * call.spec.a.H.template cast<T>();
    const Mat3<T> half = Mat3<T>::Identity() / T(2);
    const Mat3<T> excess = P_a * (FrameHalfway::spin(m) - half) * P_a.transpose();
    const Vec3<T> f = out.q.template segment<3>(6), m_b = out.q.template segment<3>(9);
    const Vec3<T> wrong = excess.transpose() * Vec3<T>(P_a * m.p).cross(f);
    out.q.template segment<3>(3) -= wrong;
    out.q.template segment<3>(9) += wrong;
    if (call.spec.kind != Kind::angular) return out;
    const Mat3<T> by_spin = skew(m_b) * excess;
    out.tangent.template block<3, 3>(9, 9) += by_spin;
    out.tangent.template block<3, 3>(9, 3) -= by_spin;
    return out;
  }
};

struct WrongPoint {  // moments about the origin of the axes for moments about the nodes
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    NodeLoads<T> out = call.loads();
    const auto move = [&](int node, const Vec3<T>& x) {
      const int f = 6 * node, m = f + 3;
      const Vec3<T> force = out.q.template segment<3>(f);
      out.q.template segment<3>(m) += x.cross(force);
      out.tangent.template middleRows<3>(m) += skew(x) * out.tangent.template middleRows<3>(f);
      out.tangent.template block<3, 3>(m, f) -= skew(force);
    };
    move(0, call.a.x);
    move(1, call.b.x);
    return out;
  }
};

struct NoReaction {  // node a is forgotten
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    NodeLoads<T> out = call.loads();
    out.q.template head<6>().setZero();
    out.tangent.template topRows<6>().setZero();
    return out;
  }
};

/// Is the relative rotation larger than `angle` (rad)?
template <class T>
bool beyond(const Call<T>& call, double angle) {
  const Mat3<T> P_a = call.a.R * call.spec.a.H.template cast<T>();
  const Mat3<T> P_b = call.b.R * call.spec.b.H.template cast<T>();
  return double(T(P_a.cwiseProduct(P_b).sum())) < 1 + 2 * std::cos(angle);
}

struct Exchanged {  // beyond 1 rad the loads of node a are returned as those of b
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    const NodeLoads<T> healthy = call.loads();
    if (!beyond(call, 1)) return healthy;
    NodeLoads<T> out;
    out.q << healthy.q.template tail<6>(), healthy.q.template head<6>();
    out.tangent << healthy.tangent.template bottomRows<6>(), healthy.tangent.template topRows<6>();
    return out;
  }
};
struct WrongBeyondTwo {  // by 1 %
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    return scaled(call, beyond(call, 2) ? 1.01 : 1);
  }
};

/// Of all scalars together: the same noise in each would agree with itself.
inline int& calls() {
  static int count = 0;
  return count;
}

struct NonDeterministic {  // the same question has another answer, by up to 1e-9
  template <class T>
  static NodeLoads<T> loads(const Call<T>& call) {
    return scaled(call, 1 + 1e-9 * std::sin(++calls()));
  }
};
struct Throws {
  template <class T>
  static NodeLoads<T> loads(const Call<T>&) {
    throw std::runtime_error("a saboteur threw");
  }
};

}  // namespace halfway::verify::sabotage
