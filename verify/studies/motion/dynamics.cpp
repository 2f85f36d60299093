// The integrators themselves, against motions that are known in closed form and against each other.
#include "reference/solve/dynamics/runge_kutta.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/motion/energy.hpp"

#include <fmt/format.h>
#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::verify {
namespace {

namespace d = reference::dynamics;
using d::Order, d::State, d::System;

Finding limited(const std::string& name, double value, double limit, Oracle oracle, const std::string& reason,
                const std::string& where = {}) {
  return at_most("dynamics/" + name, "dynamics", {value, where}, limit, "", oracle, reason);
}

/// Positions (m), orientations (rad) and momenta apart, the largest.
double distance(const State& s, const State& t) {
  double out = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    keep_largest(out, (tapped(s[i].x) - t[i].x).norm());
    keep_largest(out, (tapped(d::orientation(s[i].q)) - d::orientation(t[i].q)).norm());
    keep_largest(out, (tapped(s[i].p) - t[i].p).norm());
    keep_largest(out, (tapped(s[i].L) - t[i].L).norm());
  }
  return out;
}

/// A body without any joint whose spin has a closed form: I1 < I2 < I3, no spin about axis 2 at the start.
struct FreeBody {
  d::Body body{1, {1, 2, 3}, false};
  System system = d::free_system({d::Body{1, {1, 1, 1}, true}, body});
  State start = State(2);
  FreeBody() {
    start[1].q = d::Vec4(0.4, 0.3, -0.5, 0.2).normalized();
    set_motion(body, {0.3, -0.2, 0.1}, d::orientation(start[1].q) * Vec3<double>(1, 0, 1), start[1]);
  }
  /// Spin in body axes after t s, Jacobi's elliptic functions (Landau and Lifshitz, Mechanics, 37).
  Vec3<double> spin(double t) const {
    const Vec3<double>& I = body.inertia;
    const double twice_E = I[0] + I[2], square = I[0] * I[0] + I[2] * I[2];
    const double along = square - twice_E * I[0], across = twice_E * I[2] - square;
    const double tau = t * std::sqrt((I[2] - I[1]) * along / (I[0] * I[1] * I[2]));
    double sn = 0, cn = 0, dn = 0;
    gsl_sf_elljac_e(tau, (I[1] - I[0]) * across / ((I[2] - I[1]) * along), &sn, &cn, &dn);
    return {std::sqrt(across / (I[0] * (I[2] - I[0]))) * cn, std::sqrt(across / (I[1] * (I[2] - I[1]))) * sn,
            std::sqrt(along / (I[2] * (I[2] - I[0]))) * dn};
  }
  double spin_error(const State& s, double t) const {
    return (d::orientation(s[1].q).transpose() * tapped(d::spin(body, s[1])) - spin(t)).norm();
  }
};

std::vector<Finding> free_body() {
  const FreeBody free;
  constexpr double kTime = 30;
  const auto rk = d::runge_kutta(free.system, free.start, kTime, 1e-14).state;
  State split = free.start;
  advance(free.system, Order::four, kTime / 6000, 6000, split);
  const double E0 = energy(free.system, free.start);
  const auto energy_error = [&](const State& s) { return std::abs(energy(free.system, s) / E0 - 1); };
  return {
      limited("free_body/runge_kutta/spin", free.spin_error(rk, kTime), 2e-12, Oracle::closed_form,
              "Jacobi's elliptic functions; tolerance 1e-14 in each of some hundred steps, and the phase of "
              "the motion sums it up over 30 s"),
      limited("free_body/runge_kutta/energy", energy_error(rk), 1e-13, Oracle::closed_form, "as the spin"),
      limited("free_body/splitting/spin", free.spin_error(split, kTime), 3e-10, Oracle::closed_form,
              "Jacobi's elliptic functions; fourth order at h = 0.005 s, see dynamics/order"),
      limited("free_body/splitting/momentum", (split[1].L - free.start[1].L).norm(), 0, Oracle::closed_form,
              "the turns never touch the angular momentum: exact"),
      limited("free_body/splitting/energy", energy_error(split), 1e-10, Oracle::closed_form,
              "fourth order at h = 0.005 s")};
}

/// Isotropic joint to a clamped node, one amplitude: translation u = A cos(w t), or rotation about one axis.
Finding harmonic(bool translation, bool splitting) {
  constexpr double kStiffness = 5, kAmplitude = 0.5, kTime = 20;
  const Entry& entry = *reference::find_formulation("invariant");
  d::Scenario s;
  s.joints.resize(1), s.start.resize(2);
  JointSpec& spec = s.joints.front().spec;
  spec.kind = translation ? Kind::linear_angular : Kind::angular;
  const int n = strain_count(spec.kind);
  spec.law = reference::LinearSpec{kStiffness * Eigen::MatrixXd::Identity(n, n), false};
  s.bodies = {d::Body{1, {1, 1, 1}, true}, d::Body{2, {1.5, 2, 2.5}, false}};
  const double omega = std::sqrt(kStiffness / (translation ? 2 : 2.5));
  if (translation)
    s.start[1].x = {kAmplitude, 0, 0};
  else
    s.start[1].q = {std::cos(kAmplitude / 2), 0, 0, std::sin(kAmplitude / 2)};
  const System system = elastic_system(entry, s.joints, s.bodies);
  State end = s.start;
  if (splitting)
    advance(system, Order::four, kTime / 8000, 8000, end);
  else
    end = d::runge_kutta(system, s.start, kTime, 1e-14).state;
  const auto& q = end[1].q;
  const double value = tapped(translation ? end[1].x[0] : 2 * std::atan2(q[3], q[0]));
  return limited(
      fmt::format("harmonic/{}/{}", translation ? "translation" : "rotation",
                  splitting ? "splitting" : "runge_kutta"),
      std::abs(value - kAmplitude * std::cos(omega * kTime)), splitting ? 2e-10 : 1e-13, Oracle::closed_form,
      splitting ? "A cos(w t); fourth order at h = 0.0025 s" : "A cos(w t); tolerance 1e-14 a step");
}

std::vector<Finding> harmonics() {
  return {harmonic(true, false), harmonic(true, true), harmonic(false, false), harmonic(false, true)};
}

/// A scenario and how the order of the integrator shows.
struct Asked {
  Motion motion;
  double time;     ///< s
  long two, four;  ///< steps of either order; then twice as many
};

/// Order in the step, against Runge-Kutta at a tolerance whose own error is smaller.
std::vector<Finding> order(const Asked& asked) {
  const Entry& entry = *reference::find_formulation("conformal");
  const auto s = motion_scenario(entry, asked.motion);
  const System system = elastic_system(entry, s.joints, s.bodies);
  const State exact = d::runge_kutta(system, s.start, asked.time, 1e-14).state;
  std::vector<Finding> out;
  for (Order order : {Order::two, Order::four}) {
    const auto error = [&](long steps) {
      State state = s.start;
      advance(system, order, asked.time / double(steps), steps, state);
      return distance(state, exact);
    };
    const long steps = order == Order::two ? asked.two : asked.four;
    const double coarse = error(steps), fine = error(2 * steps);
    out.push_back(
        finding(fmt::format("dynamics/order/{}/{}", s.name, order == Order::two ? "two" : "four"))
            .about("dynamics")
            .measured(std::log2(coarse / fine), fmt::format("{} and {} steps, errors {:.3g} and {:.3g}",
                                                            steps, 2 * steps, coarse, fine))
            .equal(order == Order::two ? 2 : 4, 0.05, "the next power of the step, against the leading one")
            .by(Oracle::closed_form));
  }
  return out;
}

/// The tolerance of a step against what is left of it at the end.
std::vector<Finding> tolerances(Motion motion) {
  const Entry& entry = *reference::find_formulation("conformal");
  const auto s = motion_scenario(entry, motion);
  const System system = elastic_system(entry, s.joints, s.bodies);
  constexpr double kTime = 30;
  const State exact = d::runge_kutta(system, s.start, kTime, 1e-14).state;
  std::vector<Finding> out;
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const auto run = d::runge_kutta(system, s.start, kTime, tolerance);
    out.push_back(
        limited(fmt::format("tolerance/{}/{:.0e}", s.name, tolerance), distance(run.state, exact),
                50 * tolerance, Oracle::independent,
                "against 1e-14: the errors of some hundred steps, and how far 30 s carry neighbours apart",
                fmt::format("{} evaluations; norm of a quaternion off by {:.2g} in a step", run.evaluations,
                            run.norm_drift)));
  }
  return out;
}

/// There and back again: symmetric in time whether or not the loads have a potential.
std::vector<Finding> reversal() {
  std::vector<Finding> out;
  for (const Entry& entry : reference::formulations()) {
    const auto s = d::free_scenario(entry);
    const System system = elastic_system(entry, s.joints, s.bodies);
    State state = s.start;
    advance(system, Order::four, 0.02, 500, state);
    advance(system, Order::four, -0.02, 500, state);
    out.push_back(finding(fmt::format("dynamics/reversal/{}", entry.name))
                      .of(std::string(entry.name))
                      .about("dynamics")
                      .measured(distance(state, s.start))
                      .at_most(1e-12, "rounding of 3000 kicks, carried apart by the motion meanwhile")
                      .by(Oracle::closed_form));
  }
  return out;
}

}  // namespace

void dynamics(Checks& checks) {
  checks.push_back({"dynamics/free_body", "stability", free_body});
  checks.push_back({"dynamics/harmonic", "stability", harmonics});
  static constexpr Asked kAsked[] = {
      {Motion::clamped, 6, 1600, 800}, {Motion::free, 6, 1600, 800}, {Motion::chain, 0.25, 1600, 800}};
  for (const Asked& asked : kAsked) {
    const std::string name = motion_scenario(reference::formulations().front(), asked.motion).name;
    checks.push_back({"dynamics/order/" + name, "stability", [&asked] { return order(asked); }});
    if (asked.motion == Motion::chain) continue;
    checks.push_back(
        {"dynamics/tolerance/" + name, "stability", [&asked] { return tolerances(asked.motion); }});
  }
  checks.push_back({"dynamics/reversal", "stability", reversal});
}

}  // namespace halfway::verify
