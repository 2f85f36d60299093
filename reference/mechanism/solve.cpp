#include "reference/mechanism/solve.hpp"

#include "reference/numbers/zeros.hpp"
#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/scene/joint/free_strains.hpp"
#include "reference/solve/stop_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace halfway::reference {
namespace {

using mechanism::Follower;
using mechanism::Model;
using mechanism::Modes;

bool is_of_modes(const std::string& name) {
  return name == "growth" || name.starts_with("frequency_") || name.starts_with("eigenvalue_");
}
bool needs_masses(const std::string& name) { return is_of_modes(name) && !name.starts_with("eigenvalue_"); }

double of_modes(const Modes& modes, const std::string& name) {
  if (name == "growth") return modes.growth;
  const std::size_t i = std::size_t(std::stoi(name.substr(name.find('_') + 1)) - 1);
  return name.starts_with("frequency_") ? modes.frequencies.at(i) : modes.eigenvalues.at(i);
}

/// What goes on after "a load works on a direction without stiffness" where a curve is flat at rest alone.
std::string play_of(const MechanismScene& scene) {
  for (const SceneJoint& joint : scene.joints) {
    const Eigen::MatrixXd free = free_strains(rest_stiffness(joint.spec.law, joint.spec.kind));
    for (const auto& column : free.colwise()) {
      const Eigen::VectorXd strain = column;
      if (is_slack(joint.spec.law, strain))
        return fmt::format(
            "; the curve of the {} of {} is flat at rest and stiff beyond: no path of a mechanism "
            "leads there",
            strain_name(strain, joint.spec.kind), joint.name);
    }
  }
  return "";
}

/// The path of one formulation, point by point.
class Walk {
 public:
  Walk(const MechanismScene& scene, const Entry& entry, double xi)
      : scene_(scene), model_(scene, entry, xi), path_(model_) {}

  Follower<double>& path() { return path_; }

  void add_row(Curve& curve) {
    const bool asks = std::ranges::any_of(scene_.outputs, is_of_modes);
    const Modes modes =
        asks ? mechanism::modes(path_, std::ranges::any_of(scene_.outputs, needs_masses)) : Modes{};
    std::vector<double> row{path_.reached().factor};
    for (const std::string& name : scene_.outputs)
      row.push_back(is_of_modes(name) ? of_modes(modes, name) : mechanism::output(path_, name));
    curve.rows.push_back(std::move(row));
    curve.errors.push_back(mechanism::motion_error(path_));
    auto& poses = curve.poses.emplace_back();
    for (std::size_t i = 0; i < model_.bodies().size(); ++i)
      poses.push_back(mechanism::node_of(model_, path_.reached().state.at, i));
    auto& reactions = curve.reactions.emplace_back();
    for (std::size_t j = 0; j < model_.joints().size(); ++j) {
      const auto of = [&](bool at_a) {
        return mechanism::reaction(model_, path_.reached().state.at, j, at_a);
      };
      reactions.emplace_back() << of(true), of(false);
    }
    if (modes.growth > 0 && grows_.empty())
      grows_ = fmt::format("; {} at load factor {:.6g}", modes.flutters ? "flutter" : "divergence",
                           path_.reached().factor);
  }

  /// Is one of the joints turned beyond what its energy is convex for?
  std::string beyond() const {
    for (const auto& joint : model_.joints()) {
      const double radius = convex_radius(model_.entry(), joint.spec);
      const double phi = so3::log<double>(model_.seen(joint, path_.reached().state.at).pose.R).norm();
      if (phi > radius) return beyond_convexity(model_.entry(), phi, radius);
    }
    return "";
  }

  /// Why the path ended early; "" where it did not.
  std::string cause() const {
    const auto& reached = path_.reached();
    if (!path_.floats().empty()) return path_.floats() + play_of(scene_);
    if (path_.held_reached() < 1) return stop_cause();
    if (path_.is_held_by_nothing())
      return "once displaced, a load works on a direction without stiffness" + play_of(scene_);
    if (reached.status == Status::inaccurate)
      return fmt::format("accurate to {:.1e} rad or m only, beyond double precision",
                         mechanism::motion_error(path_));
    return reached.status == Status::converged ? "" : stop_cause();
  }

  std::string described() const {
    const std::string why = cause();
    if (why.empty()) return "converged" + grows_;
    if (!path_.floats().empty() || (path_.held_reached() >= 1 && path_.is_held_by_nothing()))
      return "no equilibrium: " + why;
    if (path_.held_reached() < 1)
      return fmt::format("stopped at {:.6g} of what is held, before load factor 0: {}", path_.held_reached(),
                         why);
    return fmt::format("stopped at load factor {:.6g}: {}", path_.reached().factor, why);
  }

 private:
  std::string stop_cause() const {
    constexpr double kNearHalfTurn = 1e-3, kSoft = 1e-4;
    for (std::size_t i = 0; i < model_.joints().size(); ++i) {
      const auto R = model_.seen(model_.joints()[i], path_.reached().state.at).pose.R;
      if (so3::log<double>(R).norm() > std::numbers::pi - kNearHalfTurn)
        return fmt::format("phi of {} reaches pi, where rotation vectors jump", scene_.joints[i].name);
    }
    const auto now = mechanism::modes(path_, false).eigenvalues;
    if (path_.reached().status == Status::singular_tangent ||
        (!now.empty() && std::abs(now.front()) <= kSoft * now.back()))
      return "the tangent is singular: a fold, a branching, or a motion that nothing resists";
    return to_string(StopCause::unknown);
  }

  const MechanismScene& scene_;
  Model<double> model_;
  Follower<double> path_;
  std::string grows_;
};

bool goes_on(const Follower<double>& path) {
  return path.floats().empty() && path.held_reached() >= 1 && is_equilibrium(path.reached().status);
}

/// Of the tangent at the start; 0 where it is singular there.
int first_sign(const Follower<double>& path) {
  const auto equations = path.equations();
  const auto free =
      mechanism::free_directions(path.model(), equations.tangent(), equations.held_directions());
  return free.hold.cols() > 0 ? 0 : equations.sign();
}

/// By halves, down to a bit.
double singular_between(const Follower<double>& path, int sign, double low, double high) {
  return last_where([&](double factor) { return path.sign_at(factor) == sign; }, low, high, 52);
}

}  // namespace

std::vector<Choice> choices(const MechanismScene& scene) {
  return choices(scene, [&](const Entry& entry) { return mechanism_objection(entry, scene).empty(); });
}

std::optional<double> critical_factor(const MechanismScene& scene, const Choice& choice) {
  Walk walk(scene, *choice.entry, choice.xi);
  Follower<double>& path = walk.path();
  if (!goes_on(path)) return std::nullopt;
  int sign = first_sign(path);
  for (int i = 1; i <= scene.points; ++i) {
    const Follower<double> before = path;
    path.advance(scene.factor_end * i / scene.points);
    if (!goes_on(path) || !walk.beyond().empty()) return std::nullopt;
    const int now = path.reached().sign;
    if (sign != 0 && now != sign)
      return singular_between(before, sign, before.reached().factor, path.reached().factor);
    sign = now;
  }
  return std::nullopt;
}

Curve solve_scene(const MechanismScene& scene, const Choice& choice, const Told& told) {
  Curve curve = empty_curve(scene, choice);
  Walk walk(scene, *choice.entry, choice.xi);
  Follower<double>& path = walk.path();
  if (path.floats().empty()) walk.add_row(curve);
  for (int i = 1; i <= scene.points && goes_on(path); ++i) {
    path.advance(scene.factor_end * i / scene.points);
    if (const std::string why = walk.beyond(); !why.empty()) {
      curve.cause = why;
      curve.outcome = fmt::format("stopped before load factor {:.6g}: {}", path.reached().factor, why);
      return curve;
    }
    if (path.reached().factor != curve.rows.back().front()) walk.add_row(curve);
    if (told) told(i, scene.points);
  }
  const bool arrived = goes_on(path) && !path.is_held_by_nothing();
  curve.converged = arrived && path.reached().status == Status::converged;
  curve.is_inaccurate = arrived && path.reached().status == Status::inaccurate;
  curve.cause = walk.cause();
  curve.outcome = walk.described();
  curve.iterations = path.reached().iterations;
  curve.residual = path.reached().residual;
  if (!scene.asks_critical || !path.floats().empty()) return curve;
  if (const auto critical = critical_factor(scene, choice))
    curve.outcome += fmt::format("; singular tangent at load factor {:.12g}", *critical);
  else
    curve.outcome += fmt::format("; no singular tangent up to {:g}", path.reached().factor);
  return curve;
}

}  // namespace halfway::reference
