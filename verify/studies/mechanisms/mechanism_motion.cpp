// What moves a mechanism, and what it does when nothing does: prescribed motion and its work, stiff pins,
// directions that nothing holds, small motions.
#include "reference/scene/any_scene.hpp"
#include "verify/oracle/probes.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/temporary_scene.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

namespace halfway::verify {
namespace {

using reference::Curve;
using reference::MechanismScene;
using reference::SceneMotion;
namespace mechanism = reference::mechanism;

const Entry& entry_of(const char* name) { return *reference::find_formulation(name); }

/// What a motion exerts is what the energy grows by, per its value: of a generic loop, at 50 digits.
Measurement work_of_motion(const SceneMotion& motion) {
  MechanismScene scene = generic_loop(entry_of("conformal"), true);
  for (auto& load : scene.loads) load.value.setZero();
  scene.motions = {motion};
  const Real50 h("1e-12"), middle(0.6);
  Real50 energy[2], rate(0);
  const mechanism::Model<Real50> model(scene, entry_of("conformal"), 0.5);
  for (const int side : {0, 1}) {
    mechanism::Follower<Real50> path(model);
    if (path.advance(side == 0 ? Real50(middle - h) : Real50(middle + h)).status != Status::converged)
      return {std::nan(""), motion.name};
    energy[side] = mechanism::output(path, "energy");
  }
  mechanism::Follower<Real50> path(model);
  path.advance(middle);
  const auto& exerted = path.reached().state.exerted;
  for (int i = 0; i < exerted.size(); ++i)
    rate += exerted[i] * Real50(motion.axis < 0 ? motion.value[i] : motion.value[motion.axis]);
  const Real50 grows = (tapped(energy[1]) - tapped(energy[0])) / (Real50(2) * h);
  return {double(Real50(abs(grows - rate) / abs(grows))), motion.name};
}

std::vector<Finding> works() {
  std::vector<Finding> out;
  const SceneMotion motions[] = {{"component_of_rotation", 2, true, 1, {0, 0.4, 0}},
                                 {"displacement", 2, false, -1, {0.05, -0.1, 0.02}, {0.3, 0.1, -0.2}},
                                 {"component_of_displacement", 1, false, 2, {0, 0, 0.1}, {0.1, 0, 0.3}}};
  for (const SceneMotion& motion : motions) {
    const Measurement off = work_of_motion(motion);
    out.push_back(
        finding("mechanism_motion/" + motion.name)
            .about("mechanisms")
            .measured(off)
            .in("of the work")
            .at_most(1e-20, "differences over 2e-12 of the motion: its square, some thousands of times")
            .by(Oracle::closed_form));
  }
  return out;
}

/// A four-bar with pins of a stiffness, pulled sideways at its coupler: how far its rocker is from the rigid
/// one's angle.
double give(double stiffness) {
  MechanismScene scene;
  for (const MechanismScene& kept : reference::mechanism_scenes())
    if (kept.name == "four_bar") scene = kept;
  for (auto& joint : scene.joints) {
    auto& law = std::get<reference::LinearSpec>(joint.spec.law);
    law.matrix *= stiffness / law.matrix(0, 0);
  }
  reference::BodyLoad load;
  load.type = reference::LoadType::fixed_force;
  load.value = {100, -300, 0};
  load.body = 2;
  scene.loads = {load};
  scene.outputs = {"rocker.theta_z"};
  const Curve curve = reference::solve_scene(scene, {&entry_of("invariant"), 0.5});
  double rigid = std::nan("");
  for (const auto& r : scene.references)
    if (r.output == "rocker.theta_z" && r.factor == 1) rigid = std::stod(r.value);
  return curve.converged ? tapped(curve.rows.back()[1]) - rigid : std::nan("");
}

std::vector<Finding> stiff_pins() {
  const double soft = give(1e6), firm = give(1e7);
  return {
      finding("mechanism_pins/order")
          .about("mechanisms")
          .measured(soft / firm)
          .in("times as much at a tenth of the stiffness")
          .equal(10, 0.01,
                 "pins give way by load over stiffness, 3e-4 m of 3 m: the square of it is a ten-thousandth")
          .by(Oracle::closed_form)};
}

Curve run_text(const std::string& text, const char* formulation) {
  const TemporaryScene file("mechanism", text);
  const auto scene = reference::read_any_scene(file.path());
  return reference::solve_scene(std::get<MechanismScene>(scene), {&entry_of(formulation), 0.5});
}

constexpr const char* kHinge = R"(title = "hinge"
OUTPUTS
[[body]]
name = "arm"
mass = 2
center = [0, 0, -0.5]
inertia = [0.1, 0.2, 0.3]
[[joint]]
name = "pin"
between = ["ground", "arm"]
kind = "linear_angular"
frame_a = [0.8, 0, 0.6, 0]
frame_b = [0.8, 0, 0.6, 0]
[joint.law]
type = "linear"
stiffness = [1e9, 1e9, 1e9, 1e8, PIN, 1e8]
[[load]]
body = "arm"
type = "fixed_force"
value = [FORCE, 0, 0]
point = [0, 0, -1]
[[load]]
body = "arm"
type = "TYPE"
value = [0, 0, WEIGHT]
point = [0, 0, -1]
held = true
[path]
factor_end = 1
points = 4
)";

constexpr const char* kPlay = R"(title = "play"
[[joint]]
name = "pin"
kind = "angular"
[joint.law]
type = "polynomial"
k1 = [10, 10, 0]
k3 = [0, 0, 5]
[[load]]
type = "fixed_moment"
value = [1, 0, 0.5]
[path]
factor_end = 1
points = 4
)";

std::string hinge(const std::map<std::string, std::string>& words) {
  std::string out = kHinge;
  for (const auto& [word, by] : words) {
    for (std::size_t at; (at = out.find(word)) != std::string::npos;) out.replace(at, word.size(), by);
  }
  return out;
}

/// A hinge without stiffness about its axis: what is said of a load on it, and where it hangs.
std::vector<Finding> hinges() {
  const auto said = [](const std::string& what, const Curve& curve, const std::string& words) {
    return finding("mechanism_hinge/" + what)
        .about("mechanisms")
        .measured(tapped(curve.outcome).find(words) != std::string::npos, curve.outcome)
        .in("named")
        .equal(1, 0, "the outcome says: " + words)
        .by(Oracle::closed_form);
  };
  const std::string outputs = "outputs = [\"arm.theta_y\"]";
  const auto with = [&](const char* force, const char* weight) {
    return run_text(hinge({{"OUTPUTS", outputs},
                           {"PIN", "0"},
                           {"FORCE", force},
                           {"WEIGHT", weight},
                           {"TYPE", "fixed_force"}}),
                    "invariant");
  };
  const Curve loaded = with("3", "0"), hanging = with("3", "-4"), idle = with("0", "0");
  return {said("loaded", loaded, "without stiffness, rotation about (0, 1, 0) of body arm"),
          said("idle", idle, "converged"),
          said("play", run_text(kPlay, "invariant"),
               "the curve of the rotation about joint axis 3 of pin is flat at rest"),
          finding("mechanism_hinge/hangs")
              .about("mechanisms")
              .measured(hanging.converged ? tapped(hanging.rows.back()[1]) : std::nan(""), hanging.outcome)
              .in("rad")
              .equal(-std::atan(0.75), 1e-11,
                     "eps times 1e9 N/m times 1 m over 5 N m/rad is 4e-8 of an offset that "
                     "does not turn the arm; some roundings of the angle remain")
              .by(Oracle::closed_form)};
}

/// A pendulum's frequency about its pin, with a spring there and a weight.
std::vector<Finding> small_motions() {
  const Curve curve = run_text(hinge({{"OUTPUTS", "outputs = [\"frequency_1\", \"growth\"]"},
                                      {"PIN", "3"},
                                      {"FORCE", "0"},
                                      {"WEIGHT", "-5"},
                                      {"TYPE", "fixed_force"}}),
                               "invariant");
  const double J = 0.2 + 2 * 0.25;  // kg m^2 about the pin
  const double f = std::sqrt((3 + 5 * 1.0) / J) / (2 * std::numbers::pi);
  return {finding("mechanism_modes/pendulum")
              .about("mechanisms")
              .measured(curve.converged ? tapped(curve.rows.back()[1]) : std::nan(""), curve.outcome)
              .in("Hz")
              .equal(f, 1e-6 * f,
                     "pins of 1e9 N/m give way by a few 1e-9 of the arm; eigenvalues 1e9 times apart "
                     "leave 1e-7 of the smallest")
              .by(Oracle::closed_form),
          finding("mechanism_modes/growth")
              .about("mechanisms")
              .measured(curve.converged ? tapped(curve.rows.back()[2] + 1) - 1 : std::nan(""), curve.outcome)
              .in("1/s")
              .equal(0, 0, "a body in a stable rest moves and does not grow")
              .by(Oracle::closed_form)};
}

/// Ziegler's column: two rigid links, springs c at their pins, a follower force along the second.
constexpr const char* kZiegler = R"(title = "Ziegler"
outputs = ["growth", "frequency_1", "frequency_2"]
[[body]]
name = "low"
free = "rotation"
inertia = [1, 2, 1]
[[body]]
name = "high"
free = "all"
mass = 1
center = [0, 0, 1]
inertia = [0.1, 0.01, 0.1]
[[joint]]
name = "foot"
between = ["ground", "low"]
kind = "angular"
[joint.law]
type = "linear"
stiffness = [1e5, 1, 1e5]
[[joint]]
name = "knee"
between = ["low", "high"]
kind = "linear_angular"
offset_a = [0, 0, 1]
[joint.law]
type = "linear"
stiffness = [1e5, 1e5, 1e5, 1e5, 1, 1e5]
[[load]]
body = "high"
type = "follower_force"
value = [0, 0, -1]
point = [0, 0, 1]
[path]
factor_end = 3
points = 300
)";

/// 2 kg at the knee, 1 kg and J = 0.01 kg m^2 at the end, links of 1 m, c = 1: frequencies meet where
/// (7 + 2 J - P (2 + J))^2 = 4 (2 + 3 J); without J at P = 7/2 - sqrt 2.
std::vector<Finding> flutters() {
  const Curve curve = run_text(kZiegler, "invariant");
  double first = std::nan("");
  for (const auto& row : curve.rows) {
    if (!(row[1] > 0)) continue;
    first = row[0];
    break;
  }
  constexpr double J = 0.01;
  const double P = (7 + 2 * J - 2 * std::sqrt(2 + 3 * J)) / (2 + J);
  return {finding("mechanism_modes/ziegler")
              .about("mechanisms")
              .measured(tapped(first), curve.outcome)
              .in("c/l")
              .equal(P, 0.011, "seen at the points of the path, 0.01 apart; stiff springs of 1e5 give way")
              .by(Oracle::closed_form)};
}

}  // namespace

void mechanism_motion(Checks& checks) {
  checks.push_back({"mechanism_motion", "mechanisms", works});
  checks.push_back({"mechanism_pins", "mechanisms", stiff_pins});
  checks.push_back({"mechanism_hinge", "mechanisms", hinges});
  checks.push_back({"mechanism_modes", "mechanisms", small_motions});
  checks.push_back({"mechanism_flutter", "mechanisms", flutters});
}

}  // namespace halfway::verify
