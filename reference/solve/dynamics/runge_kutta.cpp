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
  Loads loads{}, drive{};
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

int rates(double t, const double y[], double dydt[], void* parameter) {
  auto& problem = *static_cast<Problem*>(parameter);
  State& state = problem.state;
  unpack(y, state);
  const System& system = problem.system;
  system.loads(state, problem.loads);
  if (system.drive) system.drive(t, state, problem.drive);
  ++problem.evaluations;
  if (!problem.loads.allFinite()) return GSL_EBADFUNC;
  double work = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Body& body = system.bodies[i];
    const Vec3<double> v = velocity(body, state[i]), w = spin(body, state[i]);
    BodyState rate{v, quaternion_rate(w, state[i].q)};
    const long at = 6 * long(i);
    if (!body.clamped) {
      rate.p = -problem.loads.segment<3>(at);
      rate.L = -problem.loads.segment<3>(at + 3);
    }
    if (!body.clamped && system.drive) {
      rate.p += problem.drive.segment<3>(at);
      rate.L += problem.drive.segment<3>(at + 3);
      work += problem.drive.segment<3>(at).dot(v) + problem.drive.segment<3>(at + 3).dot(w);
    }
    pack(rate, dydt + i * kPerBody);
  }
  dydt[kPerBody * state.size()] = system.dissipation ? system.dissipation(state) : 0;
  dydt[kPerBody * state.size() + 1] = work;
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

/// What absolute tolerances are multiplied with.
std::vector<double> scales_of(const System& system, bool per_mass) {
  std::vector<double> out(kPerBody * system.bodies.size() + 2, 1);
  for (std::size_t i = 0; per_mass && i < system.bodies.size(); ++i) {
    const BodyState of{Vec3<double>::Ones(), Vec4::Ones(), Vec3<double>::Constant(system.bodies[i].mass),
                       Vec3<double>::Constant(largest_entry<double>(system.bodies[i].inertia))};
    pack(of, &out[i * kPerBody]);
  }
  return out;
}

}  // namespace

struct RungeKutta::Parts {
  Problem problem;
  std::size_t bodies = problem.system.bodies.size(), count = kPerBody * bodies + 2;
  gsl_odeiv2_system equations{rates, nullptr, count, &problem};
  std::unique_ptr<gsl_odeiv2_step, Free> step{gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, count)};
  std::unique_ptr<gsl_odeiv2_control, Free> control;
  std::unique_ptr<gsl_odeiv2_evolve, Free> evolve{gsl_odeiv2_evolve_alloc(count)};
  std::vector<double> y = std::vector<double>(count);
  double t = 0, h = 0, norm_drift = 0;
  long steps = 0, most_steps;

  Parts(const System& system, const State& start, const Options& options)
      : problem{system}, most_steps(options.most_steps) {
    const std::vector<double> scales = scales_of(system, options.per_mass);
    control.reset(gsl_odeiv2_control_scaled_new(options.tolerance, options.tolerance, 1, 0, scales.data(),
                                                scales.size()));
    for (std::size_t i = 0; i < bodies; ++i) pack(start[i], &y[i * kPerBody]);
  }
};

RungeKutta::RungeKutta(const System& system, const State& start, const Options& options)
    : parts_(std::make_unique<Parts>(system, start, options)) {}
RungeKutta::~RungeKutta() = default;

std::string RungeKutta::advance(double time) {
  Parts& p = *parts_;
  if (p.h == 0) p.h = time / 100;
  while (p.t < time) {
    const int status = p.steps++ < p.most_steps
                           ? gsl_odeiv2_evolve_apply(p.evolve.get(), p.control.get(), p.step.get(),
                                                     &p.equations, &p.t, time, &p.h, p.y.data())
                           : GSL_EMAXITER;
    if (status != GSL_SUCCESS) return gsl_strerror(status);
    keep_largest(p.norm_drift, normalise(p.bodies, p.y.data()));
  }
  return "";
}

void RungeKutta::restart() { gsl_odeiv2_evolve_reset(parts_->evolve.get()); }

State RungeKutta::state() const {
  State out(parts_->bodies);
  unpack(parts_->y.data(), out);
  return out;
}
double RungeKutta::dissipated() const { return parts_->y[parts_->count - 2]; }
Driven RungeKutta::driven() const { return {parts_->t, parts_->y.back()}; }
double RungeKutta::norm_drift() const { return parts_->norm_drift; }
long RungeKutta::evaluations() const { return parts_->problem.evaluations; }

RungeKuttaResult runge_kutta(const System& system, const State& start, double duration, double tolerance) {
  RungeKutta motion(system, start, {.tolerance = tolerance});
  const std::string failure = motion.advance(duration);
  return {motion.state(), motion.dissipated(), motion.norm_drift(), motion.evaluations(), failure};
}

}  // namespace halfway::reference::dynamics
