// How long does an equilibrium take, by Newton with the analytic tangent and by GSL without one?
//
// C1 is one load step; C3 is the path through the scene's load factors past the critical moment.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "bench/questions/equilibrium.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "reference/solve/gsl_solver.hpp"
#include "reference/solve/path.hpp"

namespace halfway::bench {

Cases equilibrium_cases();

using reference::Real50;

Problem problem(const std::string& name, bool whole_path) {
  const auto scenes = reference::canonical_scenes();
  const auto scene = std::ranges::find(scenes, name, &reference::Scene::name);
  if (scene == scenes.end()) throw std::runtime_error("no canonical scene " + name);
  const reference::AnyLaw<double, 3> law(scene->joint.law);
  return {*scene,
          whole_path ? scene->points : 1,
          scene->loads.at(0).value,
          {law(Vec3<double>::Zero()).stiffness}};
}

Checked compare_end(const Problem& p, const char* formulation, const Pose<double>& b, double limit) {
  reference::Path<Real50> path(p.scene, *reference::find_formulation(formulation), 0.5);
  for (int i = 0; i < p.steps; ++i) path.advance(p.scene.factor_end * (i + 1) / p.steps);
  if (path.state().status != Status::converged)
    return {.message = "no solution at 50 digits to check against"};
  const Mat3<Real50> R = path.node().R;
  const Vec3<Real50> theta = so3::log<Real50>(R);
  const Vec3<Real50> miss = so3::log<Real50>(b.R.cast<Real50>() * R.transpose());
  Checked out{.error = double(Real50(miss.norm() / theta.norm()))};
  if (!(out.error <= limit))
    out.message = fmt::format("relative error {:.2e}, limit {:.2e}", out.error, limit);
  return out;
}

namespace {

template <class F>
using AngularJoint = Joint<Kind::angular, double, F, LinearLaw<double, 3>>;

template <class F>
AngularJoint<F> joint_of(const Problem& p) {
  return {F{}, p.law, p.scene.joint.a, p.scene.joint.b};
}

template <class F>
Pose<double> by_newton(const Problem& p, const AngularJoint<F>& joint) {
  const Pose<double> a;
  NodeLoad<double> load;
  load.moment = p.moment;
  Outcome<double> state;
  for (int i = 0; i < p.steps && state.status == Status::converged; ++i)
    state = follow(joint, a, load, state, p.scene.factor_end * (i + 1) / p.steps);
  return node_b(joint.a, joint.b, a, state.joint);
}

/// Stop of GSL: the sum of the residuals' sizes, relative to the moment.
constexpr double kGslTolerance = 1e-12;

template <class F>
Pose<double> by_gsl(const Problem& p, const AngularJoint<F>& joint) {
  const Pose<double> a;
  Pose<double> b = unstrained(joint.a, joint.b, a);
  for (int i = 0; i < p.steps; ++i) {
    const Vec3<double> moment = p.scene.factor_end * (i + 1) / p.steps * p.moment;
    const auto turned = [&b](const Eigen::VectorXd& w) {
      return Pose<double>{b.x, so3::exp<double>(Vec3<double>(w)) * b.R};
    };
    const auto residual = [&](const Eigen::VectorXd& w) -> Eigen::VectorXd {
      return loads<false>(joint, a, turned(w)).m_b - moment;
    };
    const auto out = reference::gsl_hybrids(residual, Vec3<double>::Zero(), kGslTolerance * moment.norm());
    if (!out.converged) break;
    b = turned(out.x);
  }
  return b;
}

template <class F, class Solver>
Case solver_case(const std::shared_ptr<const Problem>& p, const char* what, Solver solve, double limit) {
  Case c;
  c.formulation = F::name;
  c.kind = "angular";
  c.what = what;
  c.name = p->scene.name + '/' + F::name + '/' + what;
  c.check = [p, solve, limit] { return compare_end(*p, F::name, solve(*p, joint_of<F>(*p)), limit); };
  c.timed = [p, solve](benchmark::State& state) {
    const auto joint = joint_of<F>(*p);
    for (auto _ : state) {
      auto b = solve(*p, joint);
      benchmark::DoNotOptimize(b);
    }
  };
  c.evaluate = [p, solve, joint = joint_of<F>(*p)](int iterations) {
    for (int i = 0; i < iterations; ++i) {
      auto b = solve(*p, joint);
      benchmark::DoNotOptimize(b);
    }
  };
  return c;
}

template <class F>
void add_cases(Cases& cases, const std::shared_ptr<const Problem>& p) {
  // Newton goes on to rounding: a few eps of the moment, times the softest axis (100 times softer than
  // the stiffest). GSL stops at its tolerance on the moment, magnified in the same way.
  cases.push_back(solver_case<F>(p, "equilibrium_newton", by_newton<F>, 1e-12));
  cases.push_back(solver_case<F>(p, "equilibrium_gsl", by_gsl<F>, 100 * kGslTolerance));
}

}  // namespace

Cases equilibrium_cases() {
  Cases cases;
  for (const auto& p : {std::make_shared<const Problem>(problem("c1_skewed_torque", false)),
                        std::make_shared<const Problem>(problem("c3_buckling", true))}) {
    add_cases<AttachedA>(cases, p);
    add_cases<Invariant>(cases, p);
  }
  return cases;
}

}  // namespace halfway::bench
