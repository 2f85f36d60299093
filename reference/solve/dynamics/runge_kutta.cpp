#include "reference/solve/dynamics/runge_kutta.hpp"

#include "reference/record/worst.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>

namespace halfway::reference::dynamics {
namespace {

constexpr std::size_t kPerBody = 13;  // x, q, p, L

struct Problem {
  const System& system;
  long evaluations = 0;
  State state = State(system.bodies.size());  ///< at which the rates are asked for
  Loads loads{};
};

void unpack(const double* y, State& state) {
  for (BodyState& s : state) {
    s = {Eigen::Map<const Vec3<double>>(y), Eigen::Map<const Vec4>(y + 3),
         Eigen::Map<const Vec3<double>>(y + 7), Eigen::Map<const Vec3<double>>(y + 10)};
    y += kPerBody;
  }
}

void pack(const BodyState& s, double* y) {
  Eigen::Map<Vec3<double>>{y} = s.x;
  Eigen::Map<Vec4>{y + 3} = s.q;
  Eigen::Map<Vec3<double>>{y + 7} = s.p;
  Eigen::Map<Vec3<double>>{y + 10} = s.L;
}

/// (0, w) q / 2 for a spin w in global axes: keeps the norm of q exactly, but for the integrator's error.
Vec4 quaternion_rate(const Vec3<double>& w, const Vec4& q) {
  const Vec3<double> v = q.tail<3>();
  Vec4 out;
  out << -w.dot(v) / 2, (q[0] * w + w.cross(v)) / 2;
  return out;
}

int rates(double, const double y[], double dydt[], void* parameter) {
  auto& problem = *static_cast<Problem*>(parameter);
  State& state = problem.state;
  unpack(y, state);
  problem.system.loads(state, problem.loads);
  ++problem.evaluations;
  if (!problem.loads.allFinite()) return GSL_EBADFUNC;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = problem.system.bodies[i];
    BodyState rate{velocity(body, state[i]), quaternion_rate(spin(body, state[i]), state[i].q)};
    if (!body.clamped) {
      rate.p = -problem.loads.segment<3>(6 * long(i));
      rate.L = -problem.loads.segment<3>(6 * long(i) + 3);
    }
    pack(rate, dydt + i * kPerBody);
  }
  dydt[kPerBody * state.size()] = problem.system.dissipation ? problem.system.dissipation(state) : 0;
  return GSL_SUCCESS;
}

/// Puts the quaternions back to unit length. @return how far they were off
double normalise(std::size_t bodies, double* y) {
  double largest = 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    Eigen::Map<Vec4> q{y + i * kPerBody + 3};
    const double norm = q.norm();
    keep_largest(largest, std::abs(norm - 1));
    q /= norm;
  }
  return largest;
}

struct Free {
  void operator()(gsl_odeiv2_step* p) const { gsl_odeiv2_step_free(p); }
  void operator()(gsl_odeiv2_control* p) const { gsl_odeiv2_control_free(p); }
  void operator()(gsl_odeiv2_evolve* p) const { gsl_odeiv2_evolve_free(p); }
};

}  // namespace

RungeKuttaResult runge_kutta(const System& system, const State& start, double duration, double tolerance) {
  constexpr long kMostSteps = 4'000'000;  // an hour's worth: a run that needs more has a named end
  Problem problem{system};
  const std::size_t bodies = start.size(), count = kPerBody * bodies + 1;
  gsl_odeiv2_system equations{rates, nullptr, count, &problem};
  const std::unique_ptr<gsl_odeiv2_step, Free> step(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, count));
  const std::unique_ptr<gsl_odeiv2_control, Free> control(gsl_odeiv2_control_y_new(tolerance, tolerance));
  const std::unique_ptr<gsl_odeiv2_evolve, Free> evolve(gsl_odeiv2_evolve_alloc(count));
  std::vector<double> y(count);
  for (std::size_t i = 0; i < bodies; ++i) pack(start[i], &y[i * kPerBody]);
  RungeKuttaResult out;
  double t = 0, h = duration / 100;
  for (long n = 0; t < duration; ++n) {
    const int status = n < kMostSteps ? gsl_odeiv2_evolve_apply(evolve.get(), control.get(), step.get(),
                                                                &equations, &t, duration, &h, y.data())
                                      : GSL_EMAXITER;
    if (status != GSL_SUCCESS) {
      out.failure = gsl_strerror(status);
      break;
    }
    keep_largest(out.norm_drift, normalise(bodies, y.data()));
  }
  out.state.resize(bodies);
  unpack(y.data(), out.state);
  out.dissipated = y.back();
  out.evaluations = problem.evaluations;
  return out;
}

}  // namespace halfway::reference::dynamics
