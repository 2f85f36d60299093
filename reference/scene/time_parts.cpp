#include "reference/scene/time_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halfway::reference {
namespace {

constexpr int kMostPoints = 100000;
constexpr double kMostSteps = 4e6;  // of a splitting: minutes
constexpr Dimension kVelocity = dimension::length / dimension::time,
                    kSpin = dimension::angle / dimension::time;

void read_step(const Field& time, MechanismScene& scene) {
  const auto tolerance = time.find("tolerance");
  if (tolerance)
    tolerance->refuse("stands beside a splitting, whose steps are of one size", "step, s, in its place");
  const Field step = time.at("step", "a number > 0, s: the longest step of the splitting");
  scene.time->step = step.positive(dimension::time);
  if (scene.factor_end / scene.time->step > kMostSteps)
    step.refuse(
        fmt::format("makes {:.3g} steps of {:g} s", scene.factor_end / scene.time->step, scene.factor_end),
        fmt::format("{:g} steps at most", kMostSteps));
}

void read_tolerance(const Field& time, MechanismScene& scene) {
  if (const auto step = time.find("step"))
    step->refuse("stands beside runge_kutta, which chooses its steps",
                 "tolerance in its place, or integrator = splitting_2 or splitting_4");
  const auto tolerance = time.find("tolerance");
  if (!tolerance) return;
  scene.time->tolerance = tolerance->number();
  if (!(scene.time->tolerance >= 1e-12 && scene.time->tolerance <= 1e-3))
    tolerance->refuse("is out of range", "a number from 1e-12 to 1e-3");
}

/// One vector of a start, of a body that has such motions.
void read_part(const Field& start, std::string_view key, const SceneBody& body, bool is_rotation,
               Vec3<double>& out) {
  const auto field = start.find(key);
  if (!field) return;
  if (body.moves == (is_rotation ? Kind::linear : Kind::angular))
    field->refuse(fmt::format("is of body {}, which has {} alone", body.name,
                              is_rotation ? "displacements" : "rotations"),
                  is_rotation ? "u, velocity, or free = \"all\" of the body"
                              : "theta, spin, spin_body, or free = \"all\" of the body");
  const bool is_rate = key == "velocity" || key.starts_with("spin");
  const Dimension& of =
      is_rotation ? (is_rate ? kSpin : dimension::angle) : (is_rate ? kVelocity : dimension::length);
  out = field->vector<3>(
      fmt::format("3 numbers, {}, {}", si_unit(of), key == "spin_body" ? "axes of the body" : "global axes"),
      of);
}

/// @param what  as "a motion has no load factor"
void refuse_beside(const Field& file, const char* key, const char* what, const char* allowed) {
  if (const auto field = file.find(key))
    field->refuse(fmt::format("stands beside a table [time]: {}", what), allowed);
}

/// From 0 on, never back, no time more than twice.
bool go_on(const std::vector<double>& times) {
  if (times.empty() || !(times.front() >= 0)) return false;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const bool is_jump_alone = times[i] == times[i - 1] && (i == 1 || times[i - 2] < times[i]);
    if (!(times[i] > times[i - 1] || is_jump_alone)) return false;
  }
  return true;
}

}  // namespace

void read_time(const Field& file, MechanismScene& scene) {
  const auto time = file.find("time");
  if (!time) return;
  time->has_only({"duration", "points", "integrator", "tolerance", "step", "start"});
  refuse_beside(file, "path", "a motion has no load factor", "one of the two; loads have times and factors");
  refuse_beside(file, "motion", "motions are prescribed to equilibria alone",
                "loads with times and factors, or a table [path] without [time]");
  scene.time.emplace();
  scene.is_in_time = true;
  scene.factor_end = time->at("duration", "a number > 0, s").positive(dimension::time);
  scene.points = 200;
  if (const auto points = time->find("points")) scene.points = points->integer(1, kMostPoints);
  if (const auto integrator = time->find("integrator")) {
    const Names names(std::begin(kIntegrators), std::end(kIntegrators));
    scene.time->integrator = Integrator(std::ranges::find(names, integrator->one_of(names)) - names.begin());
  }
  if (const auto start = time->find("start"))
    scene.time->from_equilibrium = start->one_of({"rest", "equilibrium"}) == "equilibrium";
  if (scene.time->integrator == Integrator::runge_kutta)
    read_tolerance(*time, scene);
  else
    read_step(*time, scene);
}

SceneStart read_start(const Field& table, const MechanismScene& scene, const SceneBody& body) {
  if (!scene.time) table.refuse("stands without a table [time]", "start in a scene in time");
  if (!body.moves) table.refuse("is of a body that is clamped", "a body that is not clamped");
  table.has_only({"theta", "u", "velocity", "spin", "spin_body"});
  for (const char* pose : {"theta", "u"}) {
    const auto field = scene.time->from_equilibrium ? table.find(pose) : std::nullopt;
    if (field)
      field->refuse("stands beside [time] start = \"equilibrium\", which says where the bodies begin",
                    "velocity, spin or spin_body; or start = \"rest\"");
  }
  SceneStart out;
  read_part(table, "theta", body, true, out.theta);
  read_part(table, "u", body, false, out.u);
  read_part(table, "velocity", body, false, out.velocity);
  read_part(table, "spin", body, true, out.spin);
  const auto of_body = table.find("spin_body");
  if (!of_body) return out;
  if (table.find("spin")) of_body->refuse("stands beside spin", "one of the two");
  read_part(table, "spin_body", body, true, out.spin);
  out.is_spin_of_body = true;
  return out;
}

void read_times(const Field& load, const MechanismScene& scene, BodyLoad& out) {
  if (!scene.time) return;
  if (const auto held = load.find("held"))
    held->refuse("stands beside a table [time]: a load without times acts in full from the start on",
                 "times and factors, or neither");
  const auto times = load.find("times"), factors = load.find("factors");
  if (!times && !factors) return;
  if (!times) factors->refuse("stands without times", "times, s, beside it");
  const std::string allowed =
      "at least one number, s, from 0 on, each later than the one before, or two the same for a jump";
  out.times = times->numbers(allowed, dimension::time);
  if (!go_on(out.times)) times->refuse("do not go on", allowed);
  const std::string as_many = fmt::format("{} numbers, one for each of times", out.times.size());
  out.factors = load.at("factors", as_many).numbers(as_many, dimension::none);
  if (out.factors.size() != out.times.size())
    factors->refuse(fmt::format("has {} entries", out.factors.size()), as_many, "wrong_shape");
}

bool lacks_mass(const SceneBody& body) {
  if (!body.moves) return false;
  return (*body.moves != Kind::angular && !(body.mass > 0)) ||
         (*body.moves != Kind::linear && !(body.inertia.trace() > 0));
}

void check_time(const Field& file, const MechanismScene& scene) {
  if (!scene.time) return;
  const Field time = *file.find("time");
  for (const SceneBody& body : scene.bodies) {
    if (lacks_mass(body))
      time.refuse(fmt::format("asks for motion, and body {} has no mass", body.name),
                  fmt::format("mass, kg, and inertia, kg m^2, in the table [[body]] of {}", body.name));
  }
  if (scene.time->integrator == Integrator::runge_kutta) return;
  for (const SceneJoint& joint : scene.joints) {
    if (joint.damping.size() > 0)
      time.find("integrator")
          ->refuse(fmt::format("is a splitting, whose loads depend on poses alone, and joint {} has damping",
                               joint.name),
                   "runge_kutta, or no damping");
  }
}

}  // namespace halfway::reference
