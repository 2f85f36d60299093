#pragma once

// What every adapter shares: JSON lines in, JSON lines out, and the law of a request as the springs that most
// programs have, one for each axis. An adapter brings a function from a joint to its loads.

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace halfway::programs {

using Vec = std::array<double, 3>;
using Quat = std::array<double, 4>;  ///< w, x, y, z

struct Body {
  Vec x{};                       ///< centre of mass and node origin, m, global axes
  Quat q{1, 0, 0, 0};            ///< body axes to global axes
  Vec o{};                       ///< joint point, m, body axes
  Quat h{1, 0, 0, 0};            ///< joint frame to body axes
  double mass = 1, inertia = 1;  ///< kg, kg m2 about every axis
};

struct Joint {
  Vec k_trans{}, k_rot{};  ///< N/m, N m/rad, along the axes of the joint frames
  Body a, b;
};

/// Global axes, moments about the bodies' origins.
struct Loads {
  Vec f_a{}, m_a{}, f_b{}, m_b{};
};

enum class Springs { isotropic, diagonal };

struct Case {
  std::string id, name, version;
  std::vector<std::string> kinds;
  Springs trans, rot;
  int digits;
  bool frames;  ///< joint points away from the bodies' origins, turned joint frames
  std::function<Loads(const Joint&)> loads;
};

inline const std::vector<std::string> kAllKinds = {"angular", "linear", "linear_angular"};

/// What a program cannot do; the request itself is a good one.
struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline Quat product(const Quat& p, const Quat& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

inline Quat inverse(const Quat& q) { return {q[0], -q[1], -q[2], -q[3]}; }

inline Vec plus(const Vec& u, const Vec& v) { return {u[0] + v[0], u[1] + v[1], u[2] + v[2]}; }

inline Vec times(double s, const Vec& v) { return {s * v[0], s * v[1], s * v[2]}; }

inline Vec rotated(const Quat& q, const Vec& v) {
  const Quat turned = product(product(q, {0, v[0], v[1], v[2]}), inverse(q));
  return {turned[1], turned[2], turned[3]};
}

inline Quat joint_frame(const Body& body) { return product(body.q, body.h); }

inline Vec joint_point(const Body& body) { return plus(body.x, rotated(body.q, body.o)); }

/// Body b where its joint frame lies on that of a and no spring is strained: programs that take their joints
/// from a first pose are given this one.
inline Body at_rest(const Joint& joint) {
  Body b = joint.b;
  b.q = product(joint_frame(joint.a), inverse(b.h));
  b.x = plus(joint_point(joint.a), times(-1, rotated(b.q, b.o)));
  return b;
}

/// Loads at s = 0 of a program that has only small numbers (a time step, an impedance): the polynomial
/// through those at the given s.
template <class LoadsAt>
Loads at_zero(const std::vector<double>& s, LoadsAt loads_at) {
  Loads sum;
  for (double own : s) {
    double weight = 1;
    for (double other : s) weight *= other == own ? 1 : other / (other - own);
    const Loads loads = loads_at(own);
    sum.f_a = plus(sum.f_a, times(weight, loads.f_a));
    sum.m_a = plus(sum.m_a, times(weight, loads.m_a));
    sum.f_b = plus(sum.f_b, times(weight, loads.f_b));
    sum.m_b = plus(sum.m_b, times(weight, loads.m_b));
  }
  return sum;
}

/// A program's main: reads requests, one a line, and answers each at once. Its only argument is the case.
int run(int argc, char** argv, const std::vector<Case>& cases);

}  // namespace halfway::programs
