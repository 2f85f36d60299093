// Is what the solver calls converged true? Soft hinges in rigid bushings on a lever, every formulation.
#include "reference/solve/solve.hpp"
#include "verify/oracle/mutants/verdicts.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/replay.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/scenes/hinge_mutants.hpp"
#include "verify/studies/scenes/hinge_scenes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Path;
using reference::Real50;

constexpr double kLimit = 1e-9;  // relative, of the rotation

struct Sweep {
  Measurement error;     ///< relative, over kLimit or 100 times the floor of the scene
  Measurement estimate;  ///< true error over the solver's estimate of it
  Measurement iterations;
  int unlike = 0;  ///< scenes whose status is not what their error deserves
};

/// @param exact  the rotation, scene axes
void include(Sweep& sweep, const HingeScene& hinge, const Entry& entry, const Path<double>& path,
             const Vec3<Real50>& exact) {
  constexpr double kRead = 1e-15;  // of |theta|: the outputs are doubles themselves
  const double size(exact.norm());
  const double off(Real50((rotation_of(path).template cast<Real50>() - exact).norm()));
  const double relative = off / size;
  const double limit =
      relative <= kLimit ? kLimit : reference::larger(kLimit, 100 * floor_of(hinge, entry, exact));
  const auto worst = [&](Measurement& of, double value) {
    if (of.include(value, hinge.where))
      of.set_replay(scene_text(hinge.scene, entry, entry.probe_xi, hinge.setting));
  };
  worst(sweep.error, relative / limit);
  worst(sweep.estimate, off / (path.output_error("theta_x") + kRead * size));
  worst(sweep.iterations, path.state().iterations);
  const bool converged = path.state().status == Status::converged;
  const bool inaccurate = path.state().status == Status::inaccurate;
  if (!(converged ? relative <= kLimit : inaccurate)) ++sweep.unlike;
}

/// What is no number stays the worst, and fails: the scenes that follow would only cost time.
bool is_lost(const Sweep& sweep) { return std::isnan(sweep.error.value()); }

Sweep planar_sweep(const Entry& entry) {
  Sweep sweep;
  for (const HingeScene& hinge : planar_hinges()) {
    Path<double> path(hinge.scene, entry, entry.probe_xi);
    path.advance(1);
    Vec3<Real50> exact = Vec3<Real50>::Zero();
    if (const auto root = planar_root(hinge.scene, entry.name)) {
      exact[0] = *root;
    } else {
      Path<Real50> truth(hinge.scene, entry, entry.probe_xi);
      truth.advance(1);
      exact = rotation_of(truth);
    }
    include(sweep, hinge, entry, path, exact);
    if (is_lost(sweep)) break;
  }
  return sweep;
}

Sweep generic_sweep(const Entry& entry) {
  Sweep sweep;
  for (const HingeScene& hinge : generic_hinges(entry.block_diagonal_law_only)) {
    Path<double> path(hinge.scene, entry, entry.probe_xi, hinge.setting);
    Path<Real50> truth(hinge.scene, entry, entry.probe_xi, hinge.setting);
    path.advance(1);
    const bool solved = truth.advance(1).status == Status::converged;
    include(sweep, hinge, entry, path,
            solved ? rotation_of(truth) : Vec3<Real50>::Constant(Real50(std::nan(""))));
    if (is_lost(sweep)) break;
  }
  return sweep;
}

Draft of_hinges(const Entry& entry, const std::string& what) {
  return finding(fmt::format("{}/hinges/{}", entry.name, what))
      .of(std::string(entry.name), to_string(Kind::linear_angular))
      .about("hinges");
}

std::vector<Finding> swept(const Entry& entry, const std::string& which, const Sweep& sweep, Oracle oracle,
                           int iterations) {
  return {
      of_hinges(entry, which + "/error")
          .measured(sweep.error)
          .in("of what is allowed")
          .at_most(1, "1e-9 of the rotation, or 100 times what the last bits of the input leave open")
          .by(oracle),
      of_hinges(entry, which + "/estimate")
          .measured(sweep.estimate)
          .in("of the estimated error")
          .at_most(1, "the solver's bound: eight roundings of each load, through J^-1")
          .by(oracle),
      of_hinges(entry, which + "/iterations")
          .measured(sweep.iterations)
          .in("Newton corrections")
          .at_most(iterations, "quadratic from a prediction: a few a load step, none turns beyond 0.35 rad")
          .by(Oracle::closed_form),
      of_hinges(entry, which + "/status")
          .measured(sweep.unlike)
          .in("scenes")
          .at_most(0, "converged says a relative error of 1e-9 at most; what is less is called inaccurate")
          .by(oracle)};
}

/// A soft axis that is none of the node's: each load of it is a difference of two of the stiff axes. In a
/// plane of them the third load is zero but for what the others' rounding leaves there, turned by the joint.
HingeScene rotated(double ratio, bool in_plane) {
  HingeScene hinge;
  hinge.where = fmt::format("ratio {:.0e}{}", ratio, in_plane ? ", soft axis in a plane" : "");
  const Vec3<double> soft = in_plane ? Vec3<double>(0.6, 0.8, 0) : so3::exp<double>({0.7, -0.4, 0.9}).col(2);
  const Mat3<double> along = soft * soft.transpose();
  hinge.scene.joint.law = reference::LinearSpec{ratio * (Mat3<double>::Identity() - along) + along, false};
  hinge.scene.outputs = {"theta_x"};
  const Vec3<double> moment = in_plane ? Vec3<double>(0.02, 0, 0) : Vec3<double>(0.05, 0.2, 0.1);
  hinge.scene.loads = {{reference::LoadType::fixed_moment, moment}};
  if (in_plane) return hinge;  // frames would turn the zero away
  hinge.scene.joint.a.H = so3::exp<double>({0.3, -0.8, 0.5});
  hinge.scene.joint.b.H = so3::exp<double>({-0.6, 0.2, 1.1});
  hinge.setting.frame_turn = {0.4, 0.2, -0.7};
  return hinge;
}

/// An answer is known to eps times the ratio, and has to say so.
Sweep rotated_sweep(const Entry& entry) {
  Sweep sweep;
  for (const double ratio : {1e4, 1e6, 1e8, 1e10}) {
    for (const bool in_plane : {false, true}) {
      const HingeScene hinge = rotated(ratio, in_plane);
      Path<double> path(hinge.scene, entry, entry.probe_xi, hinge.setting);
      Path<Real50> truth(hinge.scene, entry, entry.probe_xi, hinge.setting);
      path.advance(1);
      truth.advance(1);
      include(sweep, hinge, entry, path, rotation_of(truth));
    }
  }
  return sweep;
}

/// A law whose soft direction the rounding of its own entries drowns: full, with a ratio of 1e16.
Finding beyond_double(const Entry& entry) {
  reference::Scene scene = planar_hinges().front().scene;
  const Mat3<double> Q = so3::exp<double>({0.7, -0.4, 0.9});
  Mat3<double> K = Q * Vec3<double>(1e16, 1e16, 10).asDiagonal() * Q.transpose();
  K = (K + K.transpose()) / 2;
  scene.joint = {};
  scene.joint.law = reference::LinearSpec{K + 10 * Mat3<double>::Identity(), false};
  scene.loads = {{reference::LoadType::fixed_moment, {0.3, 0.2, 0.5}}};
  scene.outputs = {"theta_x", "theta_y", "theta_z"};
  const reference::Curve curve = reference::solve_scene(scene, {&entry, entry.probe_xi});
  return of_hinges(entry, "beyond_double")
      .measured(curve.converged, curve.outcome)
      .in("called converged")
      .equal(0, 0,
             "eps of 1e16 N m/rad is a fifth of the soft stiffness: no digit of the answer is in the input")
      .by(Oracle::closed_form);
}

struct Printed {
  const char* formulation;
  double turn, stiff, scale;
};

/// The root of the scalar equation for the two scenes that people brought, to fourteen digits.
std::vector<Finding> as_brought() {
  constexpr Printed kPrinted[] = {
      {"attached_a", 0.00498998272615, 1e11, 0.1}, {"invariant", 0.00498998272615, 1e11, 0.1},
      {"conformal", 0.00498997239284, 1e11, 0.1},  {"jointc", 0.00499006539675, 1e11, 0.1},
      {"attached_a", 0.04898471217198, 1e9, 1},    {"invariant", 0.04898471217198, 1e9, 1}};
  std::vector<Finding> out;
  for (const Printed& p : kPrinted) {
    reference::Scene scene = planar_hinges().front().scene;
    const Eigen::MatrixXd K =
        (Eigen::VectorXd(6) << p.stiff, p.stiff, p.stiff, 10, p.stiff, p.stiff).finished().asDiagonal();
    scene.joint.law = reference::LinearSpec{K, false};
    scene.joint.b.o = {0, -0.1, 0};
    scene.loads[0].value = Vec3<double>(0, 2, 3) * p.scale;
    scene.loads[1].value = {0.2 * p.scale, 0, 0};
    scene.points = p.scale == 1 ? 20 : 1;
    const Entry& entry = *reference::find_formulation(p.formulation);
    const reference::Curve curve = reference::solve_scene(scene, {&entry, entry.probe_xi});
    const bool is_quick = curve.converged && curve.iterations <= 30;
    out.push_back(of_hinges(entry, fmt::format("brought_{}", p.scale == 1 ? 2 : 1))
                      .measured(is_quick ? curve.rows.back()[1] : std::nan(""),
                                fmt::format("{} in {} iterations, error {:.1e}", curve.outcome,
                                            curve.iterations, curve.errors.back()))
                      .in("rad")
                      .equal(p.turn, 6e-15, "the root is given to 14 decimals; 30 iterations for 20 points")
                      .by(Oracle::closed_form));
  }
  return out;
}

std::vector<Finding> all_of(const Entry& entry) {
  const bool closed = planar_root(planar_hinges().front().scene, entry.name).has_value();
  auto out =
      swept(entry, "planar", planar_sweep(entry), closed ? Oracle::closed_form : Oracle::fifty_digits, 30);
  for (Finding& f : swept(entry, "generic", generic_sweep(entry), Oracle::fifty_digits, 60))
    out.push_back(std::move(f));
  // In the narrow valley load steps are halved to a 32nd and doubled again: some fifteen, of eight at most.
  for (Finding& f : swept(entry, "rotated", rotated_sweep(entry), Oracle::fifty_digits, 120))
    out.push_back(std::move(f));
  out.push_back(beyond_double(entry));
  return out;
}

/// Error of a planar hinge by a solver, over what is allowed.
Measurement error_of(double (*solver)(const reference::Scene&)) {
  Measurement worst;
  for (const HingeScene& hinge : planar_hinges()) {
    const Real50 root = *planar_root(hinge.scene, "attached_a");
    worst.include(double(Real50(abs(Real50(solver(hinge.scene)) - root) / root)) / kLimit, hinge.where);
  }
  return worst;
}

void add_solver_mutant(Checks& checks, const char* name, double (*mutant)(const reference::Scene&)) {
  add_mutant(checks, name, "hinges", 1, [mutant] {
    return std::pair{error_of(mutant), error_of(&hinge_by_solver)};
  });
}

}  // namespace

void hinges(Checks& checks) {
  for (const Entry& entry : reference::formulations())
    checks.push_back({fmt::format("{}/hinges", entry.name), "scenes", [&entry] { return all_of(entry); }});
  checks.push_back({"hinges/brought", "scenes", as_brought});
  add_solver_mutant(checks, "solver/stiffest_entry", &hinge_by_stiffest_entry);
  add_solver_mutant(checks, "solver/small_step", &hinge_by_small_step);
  add_solver_mutant(checks, "solver/positions", &hinge_by_positions);
}

}  // namespace halfway::verify
