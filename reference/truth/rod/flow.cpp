#include "reference/truth/rod/flow.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace halfway::reference::rod {
namespace {

constexpr int kStateSize = 15;
using Vector3 = Eigen::Map<Vec3<double>>;
using Constant3 = Eigen::Map<const Vec3<double>>;

struct Problem {
  const Rod& rod;
  const Vec3<double>& n;
  long columns;
  double inertia;
};

/// What the changes need of the state that they are about.
struct Along {
  const Problem& problem;
  Vec3<double> tangent, m;           ///< x', m
  Mat3<double> bending, stretching;  ///< R C R^T
};

void change_rates(const Along& at, const double* y, double* rate) {
  const Vec3<double>& n = at.problem.n;
  for (long i = 0; i < at.problem.columns; ++i, y += 12, rate += 12) {
    const Constant3 dx(y + kX), w(y + kSpin), dm(y + kMoment), dn(y + kForce);
    Vector3 dx_rate(rate + kX);
    dx_rate = w.cross(at.tangent) + at.stretching * (dn + n.cross(w));
    Vector3(rate + kSpin) = at.bending * (dm + at.m.cross(w));
    Vector3(rate + kMoment) = dn.cross(at.tangent) + n.cross(dx_rate);
    Vector3(rate + kForce) = -at.problem.inertia * dx;
  }
}

int rates(double s, const double y[], double dyds[], void* parameter) {
  const auto& problem = *static_cast<const Problem*>(parameter);
  const Eigen::Map<const Mat3<double>> R(y + 3);
  const Constant3 m(y + 12);
  const Section section = section_at(problem.rod, s);
  const Vec3<double> kappa = problem.rod.curvature0 + section.bending.cwiseProduct(R.transpose() * m);
  const Vec3<double> stretch = section.stretching.cwiseProduct(R.transpose() * problem.n);
  const Vec3<double> tangent = R * (Vec3<double>::UnitX() + stretch);
  Vector3{dyds} = tangent;
  Eigen::Map<Mat3<double>>{dyds + 3} = R * skew<double>(kappa);
  Vector3{dyds + 12} = problem.n.cross(tangent);
  if (problem.columns > 0) {
    const Along at{problem, tangent, m, R * section.bending.asDiagonal() * R.transpose(),
                   R * section.stretching.asDiagonal() * R.transpose()};
    change_rates(at, y + kStateSize, dyds + kStateSize);
  }
  return GSL_SUCCESS;
}

void integrate(Problem& problem, double length, int steps, std::vector<double>& y) {
  const std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step(
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, y.size()), gsl_odeiv2_step_free);
  const gsl_odeiv2_system system{rates, nullptr, y.size(), &problem};
  std::vector<double> error(y.size());
  const double h = length / steps;
  for (int i = 0; i < steps; ++i)
    gsl_odeiv2_step_apply(step.get(), i * h, h, y.data(), error.data(), nullptr, nullptr, &system);
}

}  // namespace

Section section_at(const Rod& rod, double s) { return rod.taper ? rod.taper(s) : rod.section; }

Arrival flow(const Rod& rod, const State& start, const Vec3<double>& n, const Changes& changes, int steps,
             double inertia) {
  std::vector<double> y(std::size_t(kStateSize + changes.size()));
  Vector3{y.data()} = start.x;
  Eigen::Map<Mat3<double>>{y.data() + 3} = start.R;
  Vector3{y.data() + 12} = start.m;
  Eigen::Map<Eigen::Matrix<double, 12, Eigen::Dynamic>> carried(y.data() + kStateSize, 12, changes.cols());
  carried = changes;
  Problem problem{rod, n, changes.cols(), inertia};
  integrate(problem, rod.length, steps, y);
  return {{Constant3(y.data()), Eigen::Map<const Mat3<double>>(y.data() + 3), Constant3(y.data() + 12)},
          carried};
}

int enough_steps(const Rod& rod, const State& start, const Vec3<double>& n) {
  double bending = 0;
  constexpr int kSamples = 16;
  for (int i = 0; i <= kSamples; ++i)
    bending = std::max(bending, section_at(rod, rod.length * i / kSamples).bending.maxCoeff());
  // Kirchhoff's analogy: a pendulum with the spin kappa under the weight n is never faster than this.
  const double rate = rod.curvature0.norm() + bending * start.m.norm() + 2 * std::sqrt(bending * n.norm());
  return 8 + int(std::ceil(5 * rate * rod.length));
}

}  // namespace halfway::reference::rod
