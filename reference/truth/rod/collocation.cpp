// Chebyshev collocation: no marching along s, no shooting. Orientations are quaternions here, so that not
// even the kinematics are those of the flow.
#include "halfway/rotations/so3.hpp"
#include "reference/record/worst.hpp"
#include "reference/truth/rod/chebyshev.hpp"
#include "reference/truth/rod/flow.hpp"
#include "reference/truth/rod/load_steps.hpp"

#include <gsl/gsl_linalg.h>

#include <cmath>
#include <memory>
#include <optional>

namespace halfway::reference::rod {
namespace {

constexpr int kSize = 7;  // q = (w, v), then x, at each point
constexpr int kMostIterations = 30;
constexpr double kLargestChange = 0.25;  ///< of an entry of q, of x over the length, in one iteration
constexpr double kSmallChange = 1e-7;

using Values = Eigen::Matrix<double, kSize, 1>;

struct Points {
  Eigen::VectorXd values;                     ///< kSize at each of the points from the clamp to the tip
  Mat3<double> R = Mat3<double>::Identity();  ///< of the tip

  Values at(long i) const { return values.segment<kSize>(kSize * i); }
};

/// Of a quaternion of any length: the equations keep the length 1, rounding and Newton do not.
Mat3<double> turned(const Values& y) {
  const double w = y[0];
  const Vec3<double> v = y.segment<3>(1);
  const Mat3<double> x = skew(v);
  return Mat3<double>::Identity() + 2 / (w * w + v.squaredNorm()) * (w * x + x * x);
}

Eigen::VectorXd dense_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = A;
  Eigen::VectorXd out = b;
  const auto n = std::size_t(b.size());
  gsl_matrix_view matrix = gsl_matrix_view_array(rows.data(), n, n);
  gsl_vector_view vector = gsl_vector_view_array(out.data(), n);
  const std::unique_ptr<gsl_permutation, decltype(&gsl_permutation_free)> order(gsl_permutation_alloc(n),
                                                                                gsl_permutation_free);
  int sign = 0;
  gsl_linalg_LU_decomp(&matrix.matrix, order.get(), &sign);
  gsl_linalg_LU_svx(&matrix.matrix, order.get(), &vector.vector);
  return out;
}

class Collocation {
 public:
  Collocation(const Rod& rod, int degree) : rod_(rod), rule_(chebyshev_rule(degree)) {}

  /// Of constant curvature: R = exp(s kappa0), x = s Gamma(s kappa0) e_1.
  Points unloaded() const {
    Points out{Eigen::VectorXd(kSize * count()), so3::exp<double>(rod_.length * rod_.curvature0)};
    for (long i = 0; i < count(); ++i) {
      const double s = rule_.points[i] * rod_.length;
      const Eigen::Quaterniond q(
          Eigen::AngleAxisd(s * rod_.curvature0.norm(), rod_.curvature0.stableNormalized()));
      out.values.segment<kSize>(kSize * i) << q.w(), q.vec(),
          s * so3::gamma<double>(s * rod_.curvature0).col(0);
    }
    return out;
  }

  std::optional<Points> newton(const Loads& loads, Points at) const {
    bool is_near = false;
    for (int i = 0; i < kMostIterations; ++i) {
      const Eigen::VectorXd change = increment(loads, at);
      const double move = size_of(change);
      if (!std::isfinite(move)) break;
      at.values += std::min(1., kLargestChange / move) * change;
      if (is_near) {
        at.R = turned(at.at(count() - 1));
        return at;
      }
      is_near = move < kSmallChange;
    }
    return {};
  }

 private:
  long count() const { return rule_.points.size(); }

  /// d(q, x)/ds at a point, by what is there and at the tip.
  Values rate(const Loads& loads, double s, const Values& y, const Values& tip) const {
    const Mat3<double> R = turned(y), R_tip = turned(tip);
    const Vec3<double> n = loads.force + R_tip * loads.follower_force;
    const Vec3<double> arm = tip.tail<3>() - y.tail<3>();
    const Vec3<double> m = loads.moment + R_tip * loads.follower_moment + arm.cross(n);
    const Section section = section_at(rod_, s);
    const Vec3<double> kappa = rod_.curvature0 + section.bending.cwiseProduct(R.transpose() * m);
    Values out;
    out[0] = -y.segment<3>(1).dot(kappa) / 2;
    out.segment<3>(1) = (y[0] * kappa + y.segment<3>(1).cross(kappa)) / 2;
    out.tail<3>() = R * (Vec3<double>::UnitX() + section.stretching.cwiseProduct(R.transpose() * n));
    return out;
  }

  Eigen::Matrix<double, kSize, 2 * kSize> rate_by(const Loads& loads, double s, const Values& y,
                                                  const Values& tip) const;
  Eigen::VectorXd increment(const Loads& loads, const Points& at) const;
  double size_of(const Eigen::VectorXd& change) const;

  const Rod& rod_;
  ChebyshevRule rule_;
};

/// Differences of rate() by what is at the point (columns 0 to 6) and at the tip: good to some ten digits,
/// which makes Newton converge by as many a step and leaves what it converges to alone.
Eigen::Matrix<double, kSize, 2 * kSize> Collocation::rate_by(const Loads& loads, double s, const Values& y,
                                                             const Values& tip) const {
  Eigen::Matrix<double, kSize, 2 * kSize> out;
  for (int k = 0; k < 2 * kSize; ++k) {
    const double h = 1e-6 * (k % kSize < 4 ? 1 : rod_.length);
    const auto moved = [&](double by) {
      Values here = y, there = tip;
      (k < kSize ? here : there)[k % kSize] += by;
      return rate(loads, s, here, there);
    };
    out.col(k) = (moved(h) - moved(-h)) / (2 * h);
  }
  return out;
}

Eigen::VectorXd Collocation::increment(const Loads& loads, const Points& at) const {
  const long n = count();
  Eigen::VectorXd residual = at.at(0).replicate(n, 1) - at.values;
  Eigen::MatrixXd by = Eigen::MatrixXd::Identity(kSize * n, kSize * n);
  for (long j = 0; j < n; ++j) {
    const double s = rule_.points[j] * rod_.length;
    const Values f = rate(loads, s, at.at(j), at.at(n - 1));
    const auto f_by = rate_by(loads, s, at.at(j), at.at(n - 1));
    for (long i = 0; i < n; ++i) {
      const double weight = rod_.length * rule_.integral(i, j);
      residual.segment<kSize>(kSize * i) += weight * f;
      by.block<kSize, kSize>(kSize * i, kSize * j) -= weight * f_by.leftCols<kSize>();
      by.block<kSize, kSize>(kSize * i, kSize * (n - 1)) -= weight * f_by.rightCols<kSize>();
    }
  }
  return dense_solve(by, residual);
}

double Collocation::size_of(const Eigen::VectorXd& change) const {
  double out = 0;
  for (long i = 0; i < count(); ++i) {
    const Values y = change.segment<kSize>(kSize * i);
    keep_largest(out, larger(y.head<4>().norm(), y.tail<3>().norm() / rod_.length));
  }
  return out;
}

Tip at_degree(const Rod& rod, const Loads& loads, int degree) {
  const Collocation collocation(rod, degree);
  const Points end = in_load_steps(
      "collocation", collocation.unloaded(),
      [&](double factor, const Points& from) { return collocation.newton(loads * factor, from); });
  return {end.values.tail<3>(), end.R};
}

}  // namespace

Tip collocate(const Rod& rod, const Loads& loads, int degree) {
  if (degree < 8) throw std::invalid_argument("rod: collocation needs a degree of 8 at least");
  Tip tip = at_degree(rod, loads, degree);
  tip.error = apart(tip, at_degree(rod, loads, degree - 4), rod.length);
  return tip;
}

}  // namespace halfway::reference::rod
