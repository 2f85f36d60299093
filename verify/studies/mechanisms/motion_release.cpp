// Scenes in time that begin at the equilibrium of their loads: rest while these are held, release, a jump on
// the way, and what is said where there is no such equilibrium.
#include "reference/mechanism/solve.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/motion.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Curve;
using reference::MechanismScene;

/// The generic motion without dampers, of loads that are there from the start on.
MechanismScene generic_release(const Entry& entry) {
  MechanismScene out = generic_motion(entry);
  out.time->from_equilibrium = true;
  out.time->tolerance = 1e-10;
  out.factor_end = 0.3, out.points = 6;
  for (auto& joint : out.joints) joint.damping.resize(0, 0);
  for (auto& body : out.bodies) body.start = {};
  for (auto& load : out.loads) load.times.clear(), load.factors.clear();
  return out;
}

/// Entries of positions and orientations.
void include_apart(Measurement& out, const std::vector<Pose<double>>& nodes,
                   const std::vector<Pose<double>>& others) {
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    for (int k = 0; k < 3; ++k) out.include(std::abs(tapped(nodes[i].x[k]) - others[i].x[k]), "position");
    for (int k = 0; k < 9; ++k)
      out.include(std::abs(tapped(nodes[i].R(k / 3, k % 3)) - others[i].R(k / 3, k % 3)), "rotation");
  }
}

Measurement moved_while_held(const Entry& entry) {
  const MechanismScene scene = generic_release(entry);
  const Curve curve = reference::solve_motion(scene, {&entry, entry.probe_xi});
  if (!curve.converged) return {std::nan(""), curve.outcome};
  Measurement out;
  for (const auto& nodes : curve.poses) include_apart(out, nodes, curve.poses.front());
  return out;
}

/// One load is gone at the start, another jumps there, a third stays; one body has a velocity.
MechanismScene let_go(const Entry& entry) {
  MechanismScene out = generic_release(entry);
  out.loads[1].times = {0, 0}, out.loads[1].factors = {0.7, 0};
  out.loads[2].times = {0, 0, 0.3}, out.loads[2].factors = {-0.4, 1, 0.5};
  out.bodies[2].start.velocity = {0.1, -0.2, 0.3}, out.bodies[2].start.spin = {0.5, 0.2, -0.4};
  out.bodies[2].start.is_spin_of_body = true;
  return out;
}

/// From the numbers that the equilibrium's own scene prints, as a person would take them over.
MechanismScene by_printed_poses(const Entry& entry, MechanismScene moving) {
  MechanismScene still = moving;
  still.time.reset();
  still.is_in_time = false;
  still.factor_end = 1, still.points = 4;
  for (auto& load : still.loads) {
    if (!load.factors.empty()) load.value *= load.factors.front();
    load.times.clear(), load.factors.clear();
  }
  still.outputs.clear();
  for (const char* body : {"first", "second"}) {
    for (const char* word : {"theta_x", "theta_y", "theta_z", "u_x", "u_y", "u_z"})
      still.outputs.push_back(fmt::format("{}.{}", body, word));
  }
  const Curve printed = reference::solve_scene(still, {&entry, entry.probe_xi});
  const std::vector<double>& row = printed.rows.back();
  for (std::size_t i = 0; i < 2; ++i) {
    auto& start = moving.bodies[1 + i].start;
    start.theta = {row[1 + 6 * i], row[2 + 6 * i], row[3 + 6 * i]};
    start.u = {row[4 + 6 * i], row[5 + 6 * i], row[6 + 6 * i]};
  }
  moving.time->from_equilibrium = false;
  return moving;
}

Measurement released_apart(const Entry& entry) {
  const MechanismScene scene = let_go(entry);
  const Curve released = reference::solve_motion(scene, {&entry, entry.probe_xi});
  const Curve other = reference::solve_motion(by_printed_poses(entry, scene), {&entry, entry.probe_xi});
  if (!released.converged || !other.converged) return {std::nan(""), released.outcome};
  Measurement out;
  for (std::size_t i = 0; i < released.poses.size(); ++i)
    include_apart(out, released.poses[i], other.poses[i]);
  return out;
}

/// The torsional pendulum wound by a moment M to phi = M/k, spin w0 given, let go at a time.
struct Release {
  const char *what, *times, *factors, *start;
  double time, spin;
};
constexpr Release kReleases[] = {
    {"at_start", "[0, 0]", "[1, 0]", "", 0, 0},
    {"with_spin", "[0, 0]", "[1, 0]", "start = { spin = [1.92, 0, 0.56] }", 0, 2},
    {"later", "[0, 0.55, 0.55]", "[1, 1, 0]", "", 0.55, 0},
    {"never", "[0.7]", "[1]", "", 3, 0},
};

std::vector<Finding> closed_form(const char* by, const std::string& integration, double limit,
                                 const char* why) {
  constexpr double kMoment = 0.06;  // N m, about joint axis 3
  const Torsion torsion{0, kMoment, 0};
  const double w = std::sqrt(torsion.k / torsion.J), phi = kMoment / torsion.k;
  std::vector<Finding> out;
  for (const Release& release : kReleases) {
    const Curve curve =
        moved(scene_of(kTorsion, {{"INTEGRATION", "start = \"equilibrium\"\n" + integration},
                                  {"MOMENT", "[0.0576, 0, 0.0168]"},
                                  {"DAMPING", "0"},
                                  {"START", release.start},
                                  {"times = [0, 0.5]", fmt::format("times = {}", release.times)},
                                  {"factors = [0, 1]", fmt::format("factors = {}", release.factors)}}),
              "potential");
    Measurement off;
    for (const auto& row : curve.rows) {
      const double t = row[0] > release.time ? row[0] - release.time : 0;
      const double exact = phi * std::cos(w * t) + release.spin / w * std::sin(w * t);
      off.include(std::abs(tapped(row[1]) - exact), fmt::format("at {:g} s", row[0]));
    }
    out.push_back(finding(fmt::format("motion_release/{}/{}", by, release.what))
                      .about("motion")
                      .measured(curve.converged ? off : Measurement{std::nan(""), curve.outcome})
                      .in("rad")
                      .at_most(limit, why)
                      .by(Oracle::closed_form));
  }
  return out;
}

constexpr const char* kDoor = R"(title = "door"
[[body]]
name = "b"
mass = 2
inertia = [1, 1, 1]
[[joint]]
name = "hinge"
between = ["ground", "b"]
kind = "linear_angular"
[joint.law]
type = "linear"
stiffness = [1000, 1000, 1000, 10, 20, STIFFNESS]
[[load]]
type = "fixed_moment"
value = [0, 0, 12]
times = [0, 0]
factors = [1, 0]
[time]
duration = 1
points = 2
start = "equilibrium"
)";

std::vector<Finding> no_equilibrium() {
  const auto said = [](const char* what, const char* stiffness, const char* formulation,
                       const std::string& words) {
    const Curve curve = moved(scene_of(kDoor, {{"STIFFNESS", stiffness}}), formulation);
    const bool is_said =
        !curve.converged && curve.rows.empty() && tapped(curve.outcome).find(words) != std::string::npos;
    return finding(fmt::format("motion_release/{}", what))
        .about("motion")
        .measured(is_said, curve.outcome)
        .in("named")
        .equal(1, 0, "the outcome says: " + words)
        .by(Oracle::closed_form);
  };
  return {
      said("floats", "0", "potential",
           "does not begin: no equilibrium under the loads of time 0: a load works on a direction without "
           "stiffness, rotation about (0, 0, 1) of body b"),
      // sin(2 phi)/2 carries half of its stiffness at most: 10/12 of the load.
      said("folds", "20", "jointc",
           "no equilibrium under the loads of time 0 at 0.833 of them: the tangent is singular: a fold"),
      // 3 * pi of 12
      said("half_turn", "3", "potential",
           "no equilibrium under the loads of time 0 at 0.785 of them: phi of hinge reaches pi")};
}

}  // namespace

void motion_release(Checks& checks) {
  add_property(checks, "motion_at_rest", {Kind::linear_angular}, [](const Entry& entry, Kind, Draft f) {
    return f.measured(moved_while_held(entry))
        .in("m or rad")
        .at_most(1e-13,
                 "what rounding leaves of the loads moves the bodies by 1e-15 and keeps them moving about "
                 "there, in some twenty steps")
        .by(Oracle::closed_form);
  });
  add_property(checks, "motion_let_go", {Kind::linear_angular}, [](const Entry& entry, Kind, Draft f) {
    return f.measured(released_apart(entry))
        .in("m or rad")
        .at_most(1e-12, "from starts that differ by rounding, and so in the same steps but for rounding")
        .by(Oracle::independent);
  });
  checks.push_back({"motion_release/runge_kutta", "mechanisms", [] {
                      return closed_form("runge_kutta", "tolerance = 1e-12", 1e-11,
                                         "errors of some hundred steps, each of the tolerance at most");
                    }});
  checks.push_back({"motion_release/splitting_4", "mechanisms", [] {
                      return closed_form("splitting_4", "integrator = \"splitting_4\"\nstep = 1e-3", 2e-8,
                                         "of fourth order: (w h)^4 w t of 0.3 rad at most, w h = 0.0077");
                    }});
  checks.push_back({"motion_release", "mechanisms", no_equilibrium});
}

}  // namespace halfway::verify
