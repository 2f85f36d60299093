// Any loads: Newton on what the clamp carries until the tip carries its loads.
#include "reference/truth/rod/shooting.hpp"

#include "halfway/rotations/so3.hpp"
#include "reference/numbers/linear_algebra.hpp"
#include "reference/truth/rod/flow.hpp"
#include "reference/truth/rod/load_steps.hpp"

#include <cmath>
#include <optional>

namespace halfway::reference::rod {
namespace {

constexpr double kTipTurn = 0.5;  ///< rad, of the tip in one iteration: beyond, Newton may leave the branch
constexpr double kNear = 1e-9;    ///< Newton squares its errors: after such a step rounding alone is left
constexpr int kIterations = 30;

/// n and m at the clamp: the unknowns.
using Unknowns = Eigen::Matrix<double, 6, 1>;

struct Shot {
  Arrival arrival;
  Unknowns residual;               ///< of force and moment at the tip
  Eigen::Matrix<double, 6, 6> by;  ///< its derivative
};

Changes of_unknowns() {
  Changes out = Changes::Zero(12, 6);
  out.block<3, 3>(kForce, 0).setIdentity();
  out.block<3, 3>(kMoment, 3).setIdentity();
  return out;
}

Shot shot(const Rod& rod, const Loads& loads, const Unknowns& u, int steps) {
  const Vec3<double> n = u.head<3>(), m = u.tail<3>();
  Shot out{flow(rod, {.m = m}, n, of_unknowns(), steps), {}, {}};
  const State& end = out.arrival.end;
  const Changes& changes = out.arrival.changes;
  const Vec3<double> force = end.R * loads.follower_force, moment = end.R * loads.follower_moment;
  out.residual << n - loads.force - force, end.m - loads.moment - moment;
  const auto spin = changes.middleRows<3>(kSpin);
  out.by.topRows<3>() = changes.middleRows<3>(kForce) + skew(force) * spin;
  out.by.bottomRows<3>() = changes.middleRows<3>(kMoment) + skew(moment) * spin;
  return out;
}

/// How far an increment of the unknowns moves the tip: its spin, rad, and its path over the length.
double move_of(const Rod& rod, const Shot& at, const Unknowns& du) {
  const auto change = (at.arrival.changes * du).eval();
  return std::hypot(change.segment<3>(kSpin).norm(), change.segment<3>(kX).norm() / rod.length);
}

/// What Newton arrives at.
struct Shooting {
  Unknowns u = Unknowns::Zero();
  Vec3<double> x{0, 0, 0};
  Mat3<double> R = Mat3<double>::Identity();
};

std::optional<Shooting> newton(const Rod& rod, const Loads& loads, Unknowns u, int finer) {
  bool is_near = false;
  for (int i = 0; i < kIterations; ++i) {
    const Vec3<double> n = u.head<3>(), m = u.tail<3>();
    const Shot at = shot(rod, loads, u, finer * enough_steps(rod, {.m = m}, n));
    if (is_near) return Shooting{u, at.arrival.end.x, at.arrival.end.R};
    const Unknowns du = -lu_solve<double>(at.by, SmallVector<double>(at.residual));
    const double move = move_of(rod, at, du);
    if (!std::isfinite(move)) break;
    is_near = move < kNear;
    u += std::min(1., kTipTurn / move) * du;
  }
  return {};
}

Shooting shoot(const Rod& rod, const Loads& loads) {
  Shooting unloaded;
  unloaded.R = so3::exp<double>(rod.length * rod.curvature0);
  return in_load_steps("shooting", unloaded, [&](double factor, const Shooting& from) {
    return newton(rod, loads * factor, from.u, 1);
  });
}

}  // namespace

Tip solve(const Rod& rod, const Loads& loads) {
  const Shooting coarse = shoot(rod, loads);
  const auto fine = newton(rod, loads, coarse.u, 2);
  if (!fine) throw std::runtime_error("rod: shooting does not converge with half the steps");
  Tip tip{fine->x, fine->R};
  tip.error = apart(tip, {coarse.x, coarse.R}, rod.length);
  return tip;
}

Clamp at_clamp(const Rod& rod, const Loads& loads) {
  const Shooting found = shoot(rod, loads);
  return {found.u.head<3>(), found.u.tail<3>()};
}

}  // namespace halfway::reference::rod
