#include "reference/solve/dynamics/splitting.hpp"

#include <cmath>

namespace halfway::reference::dynamics {
namespace {

/// @param q  room for the loads
void kick(const System& system, double h, State& state, Loads& q) {
  system.loads(state, q);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (system.bodies[i].clamped) continue;
    state[i].p -= h * q.segment<3>(6 * long(i));
    state[i].L -= h * q.segment<3>(6 * long(i) + 3);
  }
}

/// Turns the body about its principal axis k for the time h: the spin about it stays what it is. `Pi` is the
/// angular momentum in body axes, of which the global one does not change.
void turn(const Body& body, int k, double h, Vec4& q, Vec3<double>& Pi) {
  const double half = h * Pi[k] / body.inertia[k] / 2;
  const double c = std::cos(half), s = std::sin(half);
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  q = Vec4{q} * c + s * [&] {  // q (0, unit k)
    Vec4 out;
    out[0] = -q[1 + k];
    out[1 + k] = q[0];
    out[1 + i] = q[1 + j];
    out[1 + j] = -q[1 + i];
    return out;
  }();
  const double cosine = c * c - s * s, sine = 2 * c * s, Pi_i = Pi[i];
  Pi[i] = cosine * Pi_i + sine * Pi[j];
  Pi[j] = cosine * Pi[j] - sine * Pi_i;
}

void drift(const Body& body, double h, BodyState& s) {
  if (body.clamped) return;
  s.x += h * s.p / body.mass;
  Vec3<double> Pi = orientation(s.q).transpose() * s.L;
  turn(body, 0, h / 2, s.q, Pi);
  turn(body, 1, h / 2, s.q, Pi);
  turn(body, 2, h, s.q, Pi);
  turn(body, 1, h / 2, s.q, Pi);
  turn(body, 0, h / 2, s.q, Pi);
  s.q.normalize();  // takes away rounding only: each turn is by a unit quaternion
}

/// Drift between two half kicks; the last half kick of one step and the first of the next are one.
void drift_kick(const System& system, double drift_time, double kick_time, State& state, Loads& q) {
  for (std::size_t i = 0; i < state.size(); ++i) drift(system.bodies[i], drift_time, state[i]);
  kick(system, kick_time, state, q);
}

}  // namespace

void advance(const System& system, Order order, double h, long steps, State& state) {
  if (steps <= 0) return;
  // Yoshida: three symmetric steps of w1, w0, w1 cancel the third-order error of one.
  const double w1 = 1 / (2 - std::cbrt(2.0)), w0 = 1 - 2 * w1;
  const double first = order == Order::two ? h / 2 : w1 * h / 2;
  Loads q;
  kick(system, first, state, q);
  for (long n = 1; n <= steps; ++n) {
    const double last = n == steps ? first : 2 * first;
    if (order == Order::two) {
      drift_kick(system, h, last, state, q);
    } else {
      drift_kick(system, w1 * h, (w1 + w0) * h / 2, state, q);
      drift_kick(system, w0 * h, (w1 + w0) * h / 2, state, q);
      drift_kick(system, w1 * h, last, state, q);
    }
  }
}

}  // namespace halfway::reference::dynamics
