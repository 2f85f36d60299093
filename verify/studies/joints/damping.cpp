// Kelvin-Voigt dampers: objective, passive, and their rates by a road of their own.
#include "halfway/damping.hpp"

#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "halfway/systems/potentials.hpp"
#include "reference/numbers/random.hpp"
#include "reference/solve/dynamics/drift.hpp"
#include "reference/solve/dynamics/runge_kutta.hpp"
#include "verify/oracle/mutants/verdicts.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

namespace d = reference::dynamics;

/// A probe in 50 digits with motions of both nodes; far: joint points and nodes metres apart.
struct Moving {
  JointSpec spec;
  JointEnd<Real50> end_a, end_b;
  Pose<Real50> a, b;
  Twist<Real50> of_a, of_b;
  double scale = 0;  ///< of the strain rates: spin times distance
};

Vec3<Real50> drawn(reference::Generator& g, double size) { return g.vector(size).cast<Real50>(); }

std::vector<Moving> moving(Kind kind, bool rigid) {
  reference::Generator g(93);
  std::vector<Moving> out;
  for (Probe p : probes(*reference::find_formulation("invariant"), kind, 8, 3)) {
    p.spec.a.o *= 10, p.spec.b.o *= 10;
    Moving m{p.spec, {}, {}, exact_pose(p.a, p.spec.a), exact_pose(p.b, p.spec.b), {}, {}};
    m.end_a = {p.spec.a.o.cast<Real50>(), p.spec.a.H.cast<Real50>()};
    m.end_b = {p.spec.b.o.cast<Real50>(), p.spec.b.H.cast<Real50>()};
    m.of_a = {drawn(g, 10), drawn(g, 10)};
    m.of_b = {drawn(g, 10), drawn(g, 10)};
    if (rigid) m.of_b = {m.of_a.v + m.of_a.w.cross(m.b.x - m.a.x), m.of_a.w};
    m.scale = 10 * (1 + double(Real50((m.b.x - m.a.x).norm())) + p.spec.a.o.norm() + p.spec.b.o.norm());
    out.push_back(m);
  }
  return out;
}

template <Kind kind>
auto viscosity(const Moving& m) {  // the probe's stiffness serves: as anisotropic, and positive definite
  constexpr int n = strain_count(kind);
  return Eigen::Matrix<Real50, n, n>(std::get<reference::LinearSpec>(m.spec.law).matrix.cast<Real50>());
}

template <Kind kind, class Rates>
Damping<Real50> damped(const Rates& rates, const Moving& m) {
  return damping<kind>(rates, viscosity<kind>(m), m.end_a, m.end_b, m.a, m.b, m.of_a, m.of_b);
}

/// Largest load under rigid motions, over that which a rate of spin times distance would make.
template <Kind kind, class Rates>
Measurement rigid_loads(const Rates& rates) {
  Measurement out;
  for (const Moving& m : moving(kind, true)) {
    const double arm = 1 + m.scale / 10;  // m; a moment is a force times it
    const double size = double(Real50(viscosity<kind>(m).norm())) * m.scale * arm;
    out.include(double(Real50(damped<kind>(rates, m).q.norm())) / size, "spin up to 10 rad/s");
  }
  return out;
}

/// The strain rate against the dual part of the catalog's own strain along the same motion, relative.
template <Kind kind, class Rates>
Measurement rate_error(const Rates& rates, const Entry& entry, double xi) {
  const auto along = [](const Pose<Real50>& p, const Twist<Real50>& t) {
    const Mat3<Real50> R_rate = skew(t.w) * p.R;
    Pose<Dual50> out;
    for (int i = 0; i < 3; ++i) out.x[i] = {p.x[i], t.v[i]};
    for (int i = 0; i < 9; ++i) out.R(i / 3, i % 3) = {p.R(i / 3, i % 3), R_rate(i / 3, i % 3)};
    return out;
  };
  Measurement out;
  for (Moving& m : moving(kind, false)) {
    m.spec.xi = xi;
    const auto dual = entry.in_dual50.strain(m.spec, along(m.a, m.of_a), along(m.b, m.of_b));
    const auto rate = rates.template rate<kind>(full_motion(m.end_a, m.end_b, m.a, m.b),
                                                relative_twist(m.end_a, m.end_b, m.a, m.b, m.of_a, m.of_b));
    Real50 off(0);
    for (int i = 0; i < strain_count(kind); ++i) off += abs(rate[i] - dual[i].d);
    out.include(double(off / rate.norm()), "random motions");
  }
  return out;
}

/// Power taken out over e'. C e', and its distance from 1.
struct Powers {
  Extent ratio;
  Measurement off;
};
template <Kind kind, class Rates>
Powers powers(const Rates& rates) {
  constexpr int kMotions = 50;  // of each pose: a projected transport is at its worst for few of them
  Powers out;
  reference::Generator g(17);
  for (Moving& m : moving(kind, false)) {
    for (int i = 0; i < kMotions; ++i) {
      m.of_b = {drawn(g, 10), drawn(g, 10)};
      const auto load = damped<kind>(rates, m);
      const Real50 ratio = load.power / load.law_power;
      out.ratio.include(double(ratio));
      out.off.include(double(abs(ratio - Real50(1))), "random motions");
    }
  }
  return out;
}

Finding passive(const std::string& name, const Powers& p, bool conjugate) {
  if (conjugate) {
    return at_most(name, "damping", p.off, kRounding, "of the law's power", Oracle::closed_form,
                   "virtual power: loads . motion = e' . C e' >= 0; 50 digits");
  }
  return finding(name)
      .about("damping")
      .measured(p.ratio.low(),
                fmt::format("{:.3g} ... {:.3g} over random motions", p.ratio.low(), p.ratio.high()))
      .in("power over e' . C e', the smallest")
      .reported("the moment is turned with the frame and not by the rate of the strain: not held");
}

template <Kind kind, class F>
std::vector<Finding> of_kind(const F& formulation, double xi) {
  const StrainRate rates(formulation);
  const std::string name = fmt::format("damping/{}/{}/", F::name, to_string(kind));
  const Entry& entry = *reference::find_formulation(F::name);
  return {at_most(name + "rigid_motion", "damping", rigid_loads<kind>(rates), kRounding, "relative",
                  Oracle::closed_form, "two bodies that move as one strain nothing; 50 digits"),
          at_most(name + "strain_rate", "damping", rate_error<kind>(rates, entry, xi), kRounding, "relative",
                  Oracle::independent, "dual part of the strain along the motion; 50 digits"),
          passive(name + "power", powers<kind>(rates), F::has_potential(kind))};
}

template <class F>
void add(Checks& checks, const F& formulation, double xi = 0.5) {
  checks.push_back({fmt::format("damping/{}", F::name), "stability", [formulation, xi] {
                      auto out = of_kind<Kind::angular>(formulation, xi);
                      for (auto& f : of_kind<Kind::linear>(formulation, xi)) out.push_back(f);
                      for (auto& f : of_kind<Kind::linear_angular>(formulation, xi)) out.push_back(f);
                      return out;
                    }});
}

/// Exudyn's rate of the relative position, R^T (v_b - v_a): the spin of the frame is forgotten.
std::vector<Finding> forgotten_spin() {
  const StrainRate rates{Invariant{}};
  Measurement wrong, healthy;
  for (const Moving& m : moving(Kind::linear, true)) {
    const auto motion = full_motion(m.end_a, m.end_b, m.a, m.b);
    auto twist = relative_twist(m.end_a, m.end_b, m.a, m.b, m.of_a, m.of_b);
    const auto rate = [&] {
      return double(Real50(rates.rate<Kind::linear>(motion, twist).norm())) / m.scale;
    };
    healthy.include(rate(), "rigid motions");
    const Mat3<Real50> to_a = (m.a.R * m.end_a.H).transpose();
    twist.p += to_a * m.of_a.w.cross(Vec3<Real50>(to_a.transpose() * motion.p));
    wrong.include(rate(), "rigid motions");
  }
  return verdicts("damping/forgotten_spin", "rate over spin times distance", wrong, healthy, kRounding);
}

/// Two free bodies with a damper: what the energy loses is what the damper took, and momenta stay.
std::vector<Finding> decay() {
  const Entry& entry = *reference::find_formulation("conformal");
  const d::Scenario scenario = d::free_scenario(entry);
  const reference::JointSpec& spec = scenario.joints.front().spec;
  d::System system = d::elastic_system(entry, scenario.joints, scenario.bodies);
  const Eigen::Matrix<double, 6, 6> C = 0.05 * std::get<reference::LinearSpec>(spec.law).matrix;
  const auto damper = [&](const d::State& s) {
    const auto twist = [&](std::size_t i) -> Twist<double> {
      return {velocity(scenario.bodies[i], s[i]), spin(scenario.bodies[i], s[i])};
    };
    return damping<Kind::linear_angular>(StrainRate{Conformal{}}, C, spec.a, spec.b, d::node_pose(s[0]),
                                         d::node_pose(s[1]), twist(0), twist(1));
  };
  system.loads = [elastic = system.loads, damper](const d::State& s, d::Loads& sum) {
    elastic(s, sum);
    sum += damper(s).q;
  };
  system.dissipation = [damper](const d::State& s) { return damper(s).law_power; };
  const double before = energy(system, scenario.start);
  const auto end = d::runge_kutta(system, scenario.start, 20, 1e-12);
  const double lost = before - energy(system, end.state);
  const auto P0 = d::momenta(scenario.start), P1 = d::momenta(end.state);
  const std::string where = fmt::format("20 s; {:.3g} of the energy lost; {}", lost / before,
                                        end.failure.empty() ? "integrated to the end" : end.failure);
  return {
      at_most("damping/decay/energy", "damping", {std::abs(lost - end.dissipated) / before, where}, 1e-11,
              "of the energy", Oracle::independent,
              "energy lost against the integral of e' . C e'; ten times the tolerance of a step"),
      at_most("damping/decay/remains", "damping", {1 - lost / before, where}, 0.9, "of the energy",
              Oracle::independent, "a damper that takes a tenth of the critical damping is felt within 20 s"),
      at_most("damping/decay/angular_momentum", "damping", {(P1.angular - P0.angular).norm(), where}, 1e-11,
              "kg m^2/s", Oracle::closed_form, "moments balance; ten times the tolerance of a step")};
}

}  // namespace

void damping(Checks& checks) {
  add(checks, Invariant{});
  add(checks, Potential{});
  add(checks, Conformal{});
  add(checks, Helicoidal{});
  add(checks, AttachedB{});
  add(checks, Intrinsic{0.3}, 0.3);
  checks.push_back({"damping/forgotten_spin", "stability", forgotten_spin});
  checks.push_back({"damping/decay", "stability", decay});
}

}  // namespace halfway::verify
