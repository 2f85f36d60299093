#include "reference/mechanism/motion/solve_motion.hpp"

#include "reference/mechanism/motion/beginning.hpp"
#include "reference/mechanism/motion/runs.hpp"
#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

using mechanism::Beginning;
using mechanism::Moment;
using mechanism::Moving;
using mechanism::MovingScene;
using mechanism::Run;

/// The largest distance, m, or turn, rad, between two ways to move the bodies.
double apart(const Moving& one, const Moving& other) {
  double out = 0;
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    keep_largest(out, (one.nodes[i].x - other.nodes[i].x).norm());
    keep_largest(out, so3::log<double>(one.nodes[i].R.transpose() * other.nodes[i].R).norm());
  }
  return out;
}

std::string does_not_begin(const std::string& cause) { return "does not begin: " + cause; }

class Motion {
 public:
  Motion(const MechanismScene& scene, const Choice& choice, const Beginning& begin)
      : scene_(scene),
        moving_(scene, choice, begin.nodes),
        run_(moving_, false),
        finer_(moving_, true),
        error_at_start_(begin.error) {
    at_start_ = run_.moment().energies.total();
  }

  Curve solved(Curve curve, const Told& told) {
    for (int i = 0; i <= scene_.points && cause_.empty(); ++i) {
      for (Run* run : {&run_, &finer_})
        if (cause_.empty()) cause_ = run->advance(i);
      const Moment moment = run_.moment();
      if (cause_.empty()) cause_ = beyond(moment.now);
      if (cause_.empty()) add_row(curve, moment, i);
      if (told) told(i, scene_.points);
    }
    curve.converged = cause_.empty();
    curve.cause = cause_;
    curve.iterations = int(run_.evaluations());
    curve.residual = balance_ / (largest_energy_ > 0 ? largest_energy_ : 1);
    curve.outcome = cause_.empty() ? "reached"
                    : curve.rows.empty()
                        ? does_not_begin(cause_)
                        : fmt::format("stopped at {:.6g} s: {}", curve.rows.back()[0], cause_);
    return curve;
  }

 private:
  void add_row(Curve& curve, const Moment& moment, int point) {
    std::vector<double> row{scene_.factor_end * point / scene_.points};
    for (const std::string& name : scene_.outputs)
      row.push_back(mechanism::motion_output(moving_, moment, at_start_, name));
    curve.rows.push_back(std::move(row));
    curve.errors.push_back(error_at_start_ + error_of(moment));
    curve.poses.push_back(moment.now.nodes);
    auto& reactions = curve.reactions.emplace_back();
    for (std::size_t j = 0; j < scene_.joints.size(); ++j)
      reactions.push_back(-moving_.joint_loads(j, moment.now));
    const auto& e = moment.energies;
    curve.energies.push_back({e.kinetic, e.strain, e.dissipated, e.work});
    keep_largest(balance_, std::abs(e.total() - at_start_));
    for (const double energy : {e.kinetic, e.strain, e.dissipated, e.work})
      keep_largest(largest_energy_, std::abs(energy));
  }

  /// The finer motion's own error is that much smaller.
  double error_of(const Moment& moment) const {
    const double off = apart(moment.now, finer_.moment().now);
    switch (scene_.time->integrator) {
      case Integrator::splitting_2:
        return off * 4 / 3;
      case Integrator::splitting_4:
        return off * 16 / 15;
      default:
        return off;
    }
  }

  /// Is one of the joints turned beyond half a turn, or what its energy is convex for? Between two points a
  /// rotation vector that jumped points back.
  std::string beyond(const Moving& now) {
    constexpr double kNearHalfTurn = 1e-3;
    std::vector<Vec3<double>> turns;
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) {
      const Vec3<double> theta = moving_.relative_rotation(j, now);
      const double phi = theta.norm(), radius = convex_radius(moving_.entry(), moving_.spec(j));
      if (phi > radius) return beyond_convexity(moving_.entry(), phi, radius);
      const bool has_jumped = !turns_.empty() && phi > std::numbers::pi / 2 &&
                              turns_[j].norm() > std::numbers::pi / 2 && theta.dot(turns_[j]) < 0;
      if (scene_.joints[j].spec.kind != Kind::linear &&
          (has_jumped || phi > std::numbers::pi - kNearHalfTurn))
        return fmt::format("phi of {} reaches pi, where rotation vectors jump", scene_.joints[j].name);
      turns.push_back(theta);
    }
    turns_ = turns;
    return "";
  }

  const MechanismScene& scene_;
  MovingScene moving_;
  Run run_, finer_;
  std::vector<Vec3<double>> turns_{};  ///< of the joints at the point before
  std::string cause_{};
  double error_at_start_, at_start_ = 0, balance_ = 0, largest_energy_ = 0;
};

}  // namespace

Curve solve_motion(const MechanismScene& scene, const Choice& choice, const Told& told) {
  Curve curve = empty_curve(scene, choice);
  const Beginning begin = mechanism::beginning(scene, choice);
  if (begin.cause.empty()) return Motion(scene, choice, begin).solved(std::move(curve), told);
  curve.cause = begin.cause;
  curve.outcome = does_not_begin(begin.cause);
  return curve;
}

}  // namespace halfway::reference
