// A fixed end moment: no force, so m is known from the clamp on and the rod is an initial value problem.
#include "reference/numbers/linear_algebra.hpp"
#include "reference/truth/rod/flow.hpp"
#include "reference/truth/rod/load_steps.hpp"

#include <cmath>
#include <stdexcept>

namespace halfway::reference::rod {
namespace {

Tip arrived(const Rod& rod, const State& start, int steps) {
  const State end = flow(rod, start, Vec3<double>::Zero(), Changes(12, 0), steps).end;
  return {end.x, end.R};
}

State turned_on(const State& from, const Tip& tip) { return {tip.x, tip.R, from.m}; }

void refuse_amounts(const std::vector<double>& amounts) {
  double last = 0;
  for (const double amount : amounts) {
    if (!(amount >= last) || !std::isfinite(amount))
      throw std::invalid_argument("rod: amounts of a moment must ascend from 0 on");
    last = amount;
  }
}

/// Of a symmetric positive definite matrix, as a rotation and the values along its columns.
struct Axes {
  Mat3<double> R;
  Vec3<double> values;
};

Axes principal(const Mat3<double>& K) {
  const double asymmetry = (K - K.transpose()).cwiseAbs().maxCoeff();
  if (!(asymmetry <= 1e-12 * K.norm()) || !(spectrum(K).smallest > 0))
    throw std::invalid_argument("rod: its stiffness must be symmetric and positive definite");
  const SingularValues s = singular_values(K);
  Axes out{s.v, s.values};
  if (out.R.determinant() < 0) out.R.col(0) *= -1;
  return out;
}

}  // namespace

Tip tip_under_moment(const Rod& rod, const Vec3<double>& moment) {
  const State start{.m = moment};
  const int steps = enough_steps(rod, start, Vec3<double>::Zero());
  Tip tip = arrived(rod, start, 2 * steps);
  tip.error = apart(tip, arrived(rod, start, steps), rod.length);
  return tip;
}

std::vector<Tip> tips_under_moment(const Rod& rod, const Vec3<double>& direction,
                                   const std::vector<double>& amounts) {
  if (rod.taper || !rod.curvature0.isZero(0))
    throw std::invalid_argument("rod: one integration gives the load curve of a straight uniform rod only");
  refuse_amounts(amounts);
  // s runs to the amount instead of the length: the piece between two amounts is a rod that starts turned.
  Rod piece = rod;
  State coarse{.m = direction}, fine = coarse;
  double at = 0;
  std::vector<Tip> out;
  for (const double amount : amounts) {
    piece.length = (amount - at) * rod.length;
    at = amount;
    const int steps = enough_steps(piece, fine, Vec3<double>::Zero());
    coarse = turned_on(coarse, arrived(piece, coarse, steps));
    fine = turned_on(fine, arrived(piece, fine, 2 * steps));
    const double scale = amount > 0 ? amount : 1;
    const Tip tip{fine.x / scale, fine.R};
    out.push_back({tip.x, tip.R, apart(tip, {coarse.x / scale, coarse.R}, rod.length)});
  }
  return out;
}

Mat3<double> end_rotation(const Mat3<double>& stiffness, const Vec3<double>& moment) {
  const Axes axes = principal(stiffness);
  const Rod rod{.section = of_stiffness(axes.values)};
  return axes.R * tip_under_moment(rod, axes.R.transpose() * moment).R * axes.R.transpose();
}

}  // namespace halfway::reference::rod
