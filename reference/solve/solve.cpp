#include "reference/solve/solve.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/stop_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

/// Why the path ended early, in words; "" where it did not.
std::string cause_of(const Path<double>& path) {
  const Outcome<double>& state = path.state();
  if (state.status == Status::converged) return "";
  if (path.held_reached() < 1) return "no smaller step converges";
  if (state.status != Status::inaccurate) return to_string(stop_cause(path.problem(), state));
  const bool turns = path.problem().kind() != Kind::linear;
  return fmt::format("accurate to {:.1e} {} only, beyond double precision",
                     turns ? state.error.tail<3>().norm() : state.error.head<3>().norm(),
                     turns ? "rad" : "m");
}

std::string where_of(const Path<double>& path) {
  if (path.held_reached() < 1)
    return fmt::format("stopped at {:.6g} of what is held, before load factor 0", path.held_reached());
  return fmt::format("stopped at load factor {:.6g}", path.state().factor);
}

void describe(const Path<double>& path, Curve& curve) {
  curve.converged = path.state().status == Status::converged;
  curve.is_inaccurate = path.state().status == Status::inaccurate;
  curve.cause = cause_of(path);
  curve.outcome = "converged";
  if (curve.converged) return;
  const bool may_follow = !curve.is_inaccurate && path.held_reached() >= 1;
  curve.outcome = fmt::format("{}: {}{}", where_of(path), curve.cause,
                              may_follow ? "; --arc follows the path further" : "");
}

template <class Value>
std::vector<double> row_of(const Scene& scene, double factor, const Value& value) {
  std::vector<double> row{factor};
  for (const std::string& output : scene.outputs) row.push_back(value(output));
  return row;
}

void add_state(const Scene& scene, const Path<double>& path, Curve& curve) {
  curve.rows.push_back(
      row_of(scene, path.state().factor, [&](const std::string& output) { return path.output(output); }));
  double error = 0;
  for (const std::string& output : scene.outputs) keep_largest(error, path.output_error(output));
  curve.errors.push_back(error);
  curve.poses.push_back({path.node()});
}

void follow_path(const Scene& scene, const Entry& entry, const Told& told, Curve& curve) {
  Path<double> path(scene, entry, curve.xi);
  const double radius = convex_radius(entry, scene.joint);
  add_state(scene, path, curve);
  for (int i = 1; i <= scene.points && is_equilibrium(path.state().status); ++i) {
    path.advance(scene.factor_end * i / scene.points);
    if (const double phi = so3::log(path.state().joint.R).norm(); phi > radius) {
      curve.cause = beyond_convexity(phi, radius);
      curve.outcome = fmt::format("stopped before load factor {:.6g}: {}", path.state().factor,
                                  beyond_convexity(entry, phi, radius));
      return;
    }
    // Where it stops short of the factor asked for is a point of the path as well.
    if (path.state().factor != curve.rows.back().front()) add_state(scene, path, curve);
    if (told) told(i, scene.points);
  }
  describe(path, curve);
  curve.iterations = path.state().iterations;
  curve.residual = path.state().residual;
}

/// Where the linear analysis puts the node; its rotation vector as one of finite length.
Pose<double> linear_pose(const Path<double>& path, double factor) {
  const auto three = [&](const char* x, const char* y, const char* z) {
    return Vec3<double>(path.linear_output(x, factor), path.linear_output(y, factor),
                        path.linear_output(z, factor));
  };
  const Pose<double> rest = path.node();
  return {rest.x + three("u_x", "u_y", "u_z"),
          so3::exp<double>(three("theta_x", "theta_y", "theta_z")) * rest.R};
}

/// A straight line: two points. Any formulation gives it.
void linear_path(const Scene& scene, Curve& curve) {
  const Path<double> path(scene, formulations().front(), curve.xi);
  for (double factor : {0.0, scene.factor_end}) {
    curve.rows.push_back(
        row_of(scene, factor, [&](const std::string& output) { return path.linear_output(output, factor); }));
    curve.poses.push_back({linear_pose(path, factor)});
  }
  curve.converged = std::ranges::all_of(curve.rows.back(), [](double x) { return std::isfinite(x); });
  curve.outcome = curve.converged ? "converged" : "no stiffness at rest where the load works";
  if (!curve.converged) curve.rows.pop_back(), curve.poses.pop_back();
}

bool asks_for(const SceneHead& scene, std::string_view name) {
  return scene.formulations.empty() ||
         std::ranges::find(scene.formulations, name) != scene.formulations.end();
}

}  // namespace

Pose<double> rest_pose(const Scene& scene) { return unstrained<double>(scene.joint.a, scene.joint.b, {}); }

Curve empty_curve(const SceneHead& scene, const Choice& choice) {
  Curve curve;
  curve.scene = scene.name;
  curve.formulation = choice.entry ? choice.entry->name : kLinearized;
  curve.xi = choice.xi;
  curve.columns = {scene.is_in_time ? "time" : "factor"};
  curve.columns.insert(curve.columns.end(), scene.outputs.begin(), scene.outputs.end());
  return curve;
}

std::optional<Buckling> critical_state(const Scene& scene, const Choice& choice) {
  if (scene.critical_axis == 0 || !choice.entry) return std::nullopt;
  JointSpec spec = scene.joint;
  spec.xi = choice.xi;
  const auto found = first_buckling(*choice.entry, spec, scene.critical_axis - 1);
  if (found && double(found->angle) > convex_radius(*choice.entry, spec)) return std::nullopt;
  return found;
}

Curve solve_scene(const Scene& scene, const Choice& choice, const Told& told) {
  Curve curve = empty_curve(scene, choice);
  if (choice.entry) {
    follow_path(scene, *choice.entry, told, curve);
  } else {
    linear_path(scene, curve);
  }
  return curve;
}

std::vector<Choice> choices(const SceneHead& scene, const std::function<bool(const Entry&)>& accepts) {
  std::vector<Choice> out;
  for (const Entry& entry : formulations()) {
    if (!asks_for(scene, entry.name) || !accepts(entry)) continue;
    if (!entry.needs_xi) {
      out.push_back({&entry, entry.probe_xi});
    } else {
      for (double xi : scene.xis) out.push_back({&entry, xi});
    }
  }
  return out;
}

std::vector<Choice> choices(const Scene& scene) {
  auto out = choices(scene, [&](const Entry& entry) {
    return accepts_law(entry, scene.joint) && (!entry.needs_length || scene.has_length);
  });
  if (asks_for(scene, kLinearized)) out.push_back({nullptr, 0.5});
  return out;
}

}  // namespace halfway::reference
