#include "reference/solve/dynamics/splitting.hpp"

#include <cmath>

namespace halfway::reference::dynamics {
namespace {

/// Room for loads, and how far the motion is.
struct Kicks {
  Driven& driven;
  Loads inside{}, outside{};
};

/// Work of the drive while all loads change the momenta at fixed poses: they are linear there, so that the
/// velocities half-way make it exact.
double work_of(const Body& body, const BodyState& before, const BodyState& after, double h, const Loads& load,
               long at) {
  const BodyState middle{before.x, before.q, (before.p + after.p) / 2, (before.L + after.L) / 2};
  return h *
         (load.segment<3>(at).dot(velocity(body, middle)) + load.segment<3>(at + 3).dot(spin(body, middle)));
}

void kick(const System& system, double h, State& state, Kicks& kicks) {
  system.loads(state, kicks.inside);
  if (system.drive) system.drive(kicks.driven.time, state, kicks.outside);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (system.bodies[i].clamped) continue;
    const long at = 6 * long(i);
    const BodyState before = state[i];
    state[i].p -= h * kicks.inside.segment<3>(at);
    state[i].L -= h * kicks.inside.segment<3>(at + 3);
    if (!system.drive) continue;
    state[i].p += h * kicks.outside.segment<3>(at);
    state[i].L += h * kicks.outside.segment<3>(at + 3);
    kicks.driven.work += work_of(system.bodies[i], before, state[i], h, kicks.outside, at);
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
void drift_kick(const System& system, double drift_time, double kick_time, State& state, Kicks& kicks) {
  for (std::size_t i = 0; i < state.size(); ++i) drift(system.bodies[i], drift_time, state[i]);
  kicks.driven.time += drift_time;
  kick(system, kick_time, state, kicks);
}

}  // namespace

void advance(const System& system, Order order, double h, long steps, State& state, Driven& driven) {
  if (steps <= 0) return;
  // Yoshida: three symmetric steps of w1, w0, w1 cancel the third-order error of one.
  const double w1 = 1 / (2 - std::cbrt(2.0)), w0 = 1 - 2 * w1;
  const double first = order == Order::two ? h / 2 : w1 * h / 2;
  Kicks kicks{driven};
  kick(system, first, state, kicks);
  for (long n = 1; n <= steps; ++n) {
    const double last = n == steps ? first : 2 * first;
    if (order == Order::two) {
      drift_kick(system, h, last, state, kicks);
    } else {
      drift_kick(system, w1 * h, (w1 + w0) * h / 2, state, kicks);
      drift_kick(system, w0 * h, (w1 + w0) * h / 2, state, kicks);
      drift_kick(system, w1 * h, last, state, kicks);
    }
  }
}

}  // namespace halfway::reference::dynamics
