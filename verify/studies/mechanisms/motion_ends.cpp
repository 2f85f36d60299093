// Scenes in time: how a motion ends early, in words; units of mass and time; files that are broken in one
// place.
#include "verify/oracle/broken_scene.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/mechanisms/motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace halfway::verify {
namespace {

using reference::Curve;
using reference::MechanismScene;

Curve turned_hard(const char* formulation, const char* moment, const char* integration) {
  return moved(
      scene_of(kTorsion, {{"INTEGRATION", integration}, {"MOMENT", moment}, {"DAMPING", "0"}, {"START", ""}}),
      formulation);
}

/// A quantity of a scene in time: its text, what it is in SI, and where it is read.
struct Quantity {
  const char *word, *text;
  double value;
  std::function<double(const MechanismScene&)> read;
};

constexpr const char* kUnits = R"(title = "units"
[[body]]
name = "b"
mass = MASS
inertia = INERTIA
start = { velocity = [VELOCITY, 0, 0], spin = [0, SPIN, 0] }
[[joint]]
kind = "linear_angular"
damping = [LINEAR, 0, 0, 0, 0, ANGULAR]
[joint.law]
type = "linear"
stiffness = [1, 1, 1, 1, 1, 1]
[[load]]
type = "fixed_force"
value = [0, 0, 1]
times = [0, RAMP]
factors = [0, 1]
[time]
duration = DURATION
)";

std::map<std::string, std::string> words_of_units(std::map<std::string, std::string> words) {
  words.merge(std::map<std::string, std::string>{{"MASS", "1"},
                                                 {"INERTIA", "[1, 1, 1]"},
                                                 {"VELOCITY", "0"},
                                                 {"SPIN", "0"},
                                                 {"LINEAR", "0"},
                                                 {"ANGULAR", "0"},
                                                 {"DURATION", "1"},
                                                 {"RAMP", "0.1"}});
  return words;
}

double mass(const MechanismScene& s) { return s.bodies[1].mass; }
double inertia(const MechanismScene& s) { return s.bodies[1].inertia(1, 1); }
double linear(const MechanismScene& s) { return s.joints.front().damping(0, 0); }
double angular(const MechanismScene& s) { return s.joints.front().damping(5, 5); }
double velocity(const MechanismScene& s) { return s.bodies[1].start.velocity[0]; }
double spin(const MechanismScene& s) { return s.bodies[1].start.spin[1]; }
double duration(const MechanismScene& s) { return s.factor_end; }
double ramp(const MechanismScene& s) { return s.loads.front().times.back(); }

/// Steps of 10 s, one and a half periods.
Curve too_long_steps() {
  MechanismScene scene = scene_of(kUnits, words_of_units({{"DURATION", "2000"}, {"VELOCITY", "1"}}));
  scene.time = reference::SceneTime{reference::Integrator::splitting_4, 0, 10};
  return moved(scene, "potential");
}

Curve too_many_steps() {
  MechanismScene scene = scene_of(kUnits, words_of_units({{"DURATION", "2000"}, {"VELOCITY", "1"}}));
  scene.time->most_steps = 300;
  return moved(scene, "potential");
}

std::vector<Finding> ends() {
  const auto said = [](const std::string& what, const Curve& curve, const std::string& words) {
    const bool is_said = !curve.converged && tapped(curve.outcome).find(words) != std::string::npos;
    return finding("motion_ends/" + what)
        .about("motion")
        .measured(is_said, curve.outcome)
        .in("named")
        .equal(1, 0, "the outcome says: " + words)
        .by(Oracle::closed_form);
  };
  const char* const fine = "tolerance = 1e-9";
  return {
      said("half_turn", turned_hard("invariant", "[0.96, 0, 0.28]", fine),
           "phi of spring reaches pi, where rotation vectors jump"),
      said("half_turn_between_points", turned_hard("attached_a", "[96, 0, 28]", fine),
           "phi of spring reaches pi"),
      said("convexity", turned_hard("rod4", "[0.96, 0.4, 0.28]", fine), "within which its energy is convex"),
      said("long_steps", too_long_steps(), "the step is too long for the fastest motion"),
      said("many_steps", too_many_steps(), "the fastest motion is far faster than the time")};
}

/// 1 lb = 0.45359237 kg, 1 in = 25.4 mm, 1 lbf = 4.4482216152605 N, 1 deg = pi/180 rad, in 20 digits by hand.
std::vector<Finding> units() {
  const Quantity quantities[] = {
      {"MASS", "\"250 g\"", 0.25, mass},
      {"MASS", "\"3 lb\"", 1.36077711, mass},
      {"MASS", "\"0.2 t\"", 200, mass},
      {"MASS", "\"1 N s^2/mm\"", 1000, mass},
      {"MASS", "\"1 lbf s^2/in\"", 175.126835246476377952756, mass},
      {"INERTIA", "[\"1 kg m^2\", \"3 kg mm^2\", 1]", 3e-6, inertia},
      {"INERTIA", "{ values = [1, 2, 2], unit = \"lb in^2\" }", 5.852793068584e-4, inertia},
      {"VELOCITY", "\"0.6 km/min\"", 10, velocity},
      {"VELOCITY", "\"2 ft/s\"", 0.6096, velocity},
      {"SPIN", "\"30 rev/min\"", 3.1415926535897932385, spin},
      {"SPIN", "\"90 deg/s\"", 1.5707963267948966192, spin},
      {"LINEAR", "\"1 N s/mm\"", 1000, linear},
      {"LINEAR", "\"2 kg/s\"", 2, linear},
      {"LINEAR", "\"1 lbf s/in\"", 175.126835246476377952756, linear},
      {"ANGULAR", "\"1 N m s/deg\"", 57.295779513082320877, angular},
      {"RAMP", "\"20 ms\"", 0.02, ramp},
      {"DURATION", "\"700 us\"", 7e-4, duration},
      {"DURATION", "\"2 min\"", 120, duration}};
  std::vector<Finding> out;
  for (const Quantity& quantity : quantities) {
    out.push_back(finding(fmt::format("motion_units/{}", quantity.text))
                      .about("motion")
                      .measured(tapped(
                          quantity.read(scene_of(kUnits, words_of_units({{quantity.word, quantity.text}})))))
                      .in("SI")
                      .equal(quantity.value, 0, "the double next to the exact value")
                      .by(Oracle::closed_form));
  }
  return out;
}

constexpr const char* kGoodMotion = R"(title = "good"
outputs = ["b.theta_z", "b.v_x", "pin.a.f_x", "balance"]
formulations = ["invariant"]

[[body]]
name = "b"
mass = 1
inertia = [1, 1, 2]
start = { u = ["1 mm", 0, 0], spin = [0, 0, 1] }

[[joint]]
name = "pin"
between = ["ground", "b"]
kind = "linear_angular"
damping = [1, 2, 3, 4, 5, 6]
[joint.law]
type = "linear"
stiffness = [1, 2, 3, 4, 5, 6]

[[load]]
type = "follower_force"
value = [0, 0, 1]
times = [0, 0.5]
factors = [1, 0]

[time]
duration = 1
points = 4
tolerance = 1e-8

[[reference]]
source = "s"
oracle = "printed"
tolerance = 1e-6
reason = "r"
time = 1
[reference.values]
invariant = { balance = "1" }
)";

constexpr const char* kFromStartToTime =
    "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }\n\n[[joint]]\nname = \"pin\"\nbetween = [\"ground\", "
    "\"b\"]\nkind = \"linear_angular\"\ndamping = [1, 2, 3, 4, 5, 6]\n[joint.law]\ntype = "
    "\"linear\"\nstiffness = [1, 2, 3, 4, 5, 6]\n\n[[load]]\ntype = \"follower_force\"\nvalue = [0, 0, "
    "1]\ntimes = [0, 0.5]\nfactors = [1, 0]\n\n[time]";

constexpr Broken kBrokenMotions[] = {
    {"time_key", "time.step_size = ", "points = 4", "step_size = 1 #!"},
    {"time_duration_missing", "time.duration = nothing", "[time]\nduration = 1", "[time] #!"},
    {"time_duration_zero", "time.duration = ", "duration = 1", "duration = 0 #!"},
    {"time_duration_length", "time.duration = ", "duration = 1", "duration = \"1 mm\" #!"},
    {"time_points_zero", "time.points = ", "points = 4", "points = 0 #!"},
    {"time_integrator_unknown", "time.integrator = ", "points = 4", "integrator = \"newmark\" #!"},
    {"time_tolerance_small", "time.tolerance = ", "tolerance = 1e-8", "tolerance = 1e-15 #!"},
    {"time_tolerance_text", "time.tolerance = ", "tolerance = 1e-8", "tolerance = \"fine\" #!"},
    {"time_start_unknown", "time.start = ", "points = 4", "start = \"static\" #!"},
    {"time_step_of_runge_kutta", "time.step = ", "tolerance = 1e-8", "step = 0.01 #!"},
    {"time_splitting_without_step", "time.step = nothing",
     "[time]\nduration = 1\npoints = 4\ntolerance = 1e-8",
     "[time] #!\nduration = 1\nintegrator = \"splitting_2\""},
    {"time_splitting_tolerance", "time.tolerance = ", "tolerance = 1e-8",
     "integrator = \"splitting_2\"\nstep = 0.1\ntolerance = 1e-8 #!"},
    {"time_splitting_many", "time.step = ", "tolerance = 1e-8",
     "integrator = \"splitting_2\"\nstep = 1e-9 #!"},
    {"time_splitting_damped", "time.integrator = ", "tolerance = 1e-8",
     "step = 0.1\nintegrator = \"splitting_2\" #!"},
    {"time_and_path", "path = ", "[time]", "[path] #!\nfactor_end = 1\n[time]"},
    {"time_and_motion", "motion = ", "[time]",
     "[[motion]] #!\nbody = \"b\"\ntype = \"rotation\"\nvalue = [0, 0, 1]\n[time]"},
    {"time_without_mass", "time = ",
     "mass = 1\ninertia = [1, 1, 2]\nstart = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }\n\n[[joint]]\nname = "
     "\"pin\"\nbetween = [\"ground\", \"b\"]\nkind = \"linear_angular\"\ndamping = [1, 2, 3, 4, 5, "
     "6]\n[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, 3, 4, 5, 6]\n\n[[load]]\ntype = "
     "\"follower_force\"\nvalue = [0, 0, 1]\ntimes = [0, 0.5]\nfactors = [1, 0]\n\n[time]",
     "mass = 1\n\n[[joint]]\nname = \"pin\"\nbetween = [\"ground\", \"b\"]\nkind = "
     "\"linear_angular\"\ndamping = [1, 2, 3, 4, 5, 6]\n[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, "
     "3, 4, 5, 6]\n\n[[load]]\ntype = \"follower_force\"\nvalue = [0, 0, 1]\ntimes = [0, 0.5]\nfactors = [1, "
     "0]\n\n[time] #!"},
    {"mass_of_force", "body[1].mass = ", "mass = 1", "mass = \"1 N\" #!"},
    {"inertia_of_mass", "body[1].inertia[2] = ", "inertia = [1, 1, 2]", "inertia = [1, \"1 kg\", 2] #!"},
    {"start_key", "body[1].start.x = ", "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }",
     "start = { x = [\"1 mm\", 0, 0] } #!"},
    {"start_short", "body[1].start.u = ", "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }",
     "start = { u = [0, 0] } #!"},
    {"start_angle", "body[1].start.theta[1] = ", "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }",
     "start = { theta = [\"1 mm\", 0, 0] } #!"},
    {"start_two_spins", "body[1].start.spin_body = ", "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }",
     "start = { spin_body = [0, 0, 1], spin = [0, 0, 1] } #!"},
    {"start_where_equilibrium_is", "body[1].start.u = ", kFromStartToTime,
     "start = { u = [\"1 mm\", 0, 0] } #!\n\n[[joint]]\nname = \"pin\"\nbetween = [\"ground\", "
     "\"b\"]\nkind = \"linear_angular\"\n[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, 3, 4, 5, "
     "6]\n\n[time]\nstart = \"equilibrium\""},
    {"start_of_turning_body", "body[1].start.u = ", "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }",
     "free = \"rotation\"\nstart = { u = [\"1 mm\", 0, 0] } #!"},
    {"start_of_moving_body", "body[1].start.spin = ", "start = { u = [\"1 mm\", 0, 0], spin = [0, 0, 1] }",
     "free = \"displacement\"\nstart = { spin = [0, 0, 1] } #!"},
    {"start_of_clamped_body", "body[2].start = ", "[[joint]]",
     "[[body]]\nname = \"wall\"\nclamped = true\nstart = { } #!\n\n[[joint]]"},
    {"damping_negative", "joint[1].damping = ", "damping = [1, 2, 3, 4, 5, 6]",
     "damping = [1, 2, 3, 4, -5, 6] #!"},
    {"damping_short", "joint[1].damping = ", "damping = [1, 2, 3, 4, 5, 6]", "damping = [1, 2, 3] #!"},
    {"damping_of_stiffness", "joint[1].damping[1] = ", "damping = [1, 2, 3, 4, 5, 6]",
     "damping = [\"1 N/m\", 2, 3, 4, 5, 6] #!"},
    {"damping_asymmetric", "joint[1].damping = ", "damping = [1, 2, 3, 4, 5, 6]",
     "damping = [[1, 1, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, "
     "0, 1, 0], "
     "[0, 0, 0, 0, 0, 1]] #!"},
    {"load_held_in_time", "load[1].held = ", "times = [0, 0.5]", "held = true #!\ntimes = [0, 0.5]"},
    {"load_factors_without_times", "load[1].factors = ", "times = [0, 0.5]\nfactors = [1, 0]",
     "factors = [1, 0] #!"},
    {"load_times_without_factors", "load[1].factors = nothing",
     "[[load]]\ntype = \"follower_force\"\nvalue = [0, 0, 1]\ntimes = [0, 0.5]\nfactors = [1, 0]",
     "[[load]] #!\ntype = \"follower_force\"\nvalue = [0, 0, 1]\ntimes = [0, 0.5]"},
    {"load_times_back", "load[1].times = ", "times = [0, 0.5]", "times = [0.5, 0.4] #!"},
    {"load_times_thrice", "load[1].times = ", "times = [0, 0.5]\nfactors = [1, 0]",
     "times = [0.5, 0.5, 0.5] #!\nfactors = [1, 0, 1]"},
    {"load_times_negative", "load[1].times = ", "times = [0, 0.5]", "times = [-1, 0.5] #!"},
    {"load_factors_one", "load[1].factors = ", "factors = [1, 0]", "factors = [1] #!"},
    {"output_of_modes", "outputs[4] = ", "\"balance\"]", "\"frequency_1\"] #!"},
    {"reference_by_factor", "reference[1].factor = ", "time = 1", "factor = 1 #!"},
    {"reference_beyond", "reference[1].time = ", "time = 1", "time = 2 #!"},
    {"damping_at_rest", "joint[1].damping = ",
     "damping = [1, 2, 3, 4, 5, 6]\n[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, 3, 4, 5, "
     "6]\n\n[[load]]\ntype = \"follower_force\"\nvalue = [0, 0, 1]\ntimes = [0, 0.5]\nfactors = [1, "
     "0]\n\n[time]\nduration = 1\npoints = 4\ntolerance = 1e-8",
     "damping = [1, 2, 3, 4, 5, 6] #!\n[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, 3, 4, 5, "
     "6]\n\n[path]\nfactor_end = 1"},
};

}  // namespace

void motion_ends(Checks& checks) {
  checks.push_back({"motion_ends", "mechanisms", ends});
  checks.push_back({"motion_units", "mechanisms", units});
  checks.push_back({"motion/accepts/good", "mechanisms",
                    [] { return std::vector{accepted("motion_good", kGoodMotion)}; }});
  for (const Broken& broken : kBrokenMotions) {
    checks.push_back({fmt::format("motion/refuses/{}", broken.what), "mechanisms",
                      [&broken] { return std::vector{broken_refused(kGoodMotion, broken)}; }});
  }
}

}  // namespace halfway::verify
