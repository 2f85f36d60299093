#include "reference/identify/identifiable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference::identify {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// The largest standard deviation at which an unknown is taken as determined, in its own unit.
double limit_of(int place) {
  if (place >= kAngularAxes && place < kLinearStiffness) return 0.35;  // rad
  if (place >= kLinearAxes && place < kCoupling) return 0.35;
  return place >= kXiAngular && place < kCubic ? 0.25 : 0.5;
}

/// Of those that are too uncertain, often each with the others, the highest goes first: coupling, second
/// order.
int readiness(int place) {
  return place >= kXiAngular ? 1 : place >= kCoupling && place < kJointPoint ? 2 : 0;
}

/// Standard deviations of the active unknowns from weighted derivatives, at a variance of 1.
Eigen::VectorXd deviations(const Eigen::MatrixXd& J) {
  const Eigen::VectorXd size = (J.colwise().norm().transpose().array() + 1e-300).matrix();
  const Eigen::MatrixXd scaled = J * size.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd normal =
      scaled.transpose() * scaled + 1e-15 * Eigen::MatrixXd::Identity(J.cols(), J.cols());
  return normal.ldlt()
      .solve(Eigen::MatrixXd::Identity(J.cols(), J.cols()))
      .diagonal()
      .cwiseAbs()
      .cwiseSqrt()
      .cwiseQuotient(size);
}

/// The place in `active` that is to go, or -1: of the highest readiness the furthest beyond its limit.
int worst(const Eigen::VectorXd& deviation, const std::vector<int>& active, double allowed) {
  int out = -1;
  std::pair<int, double> most{-1, 0};
  for (std::size_t i = 0; i < active.size(); ++i) {
    const double beyond = deviation[Eigen::Index(i)] / limit_of(active[i]) / allowed;
    if (beyond <= 1) continue;
    const std::pair rank{readiness(active[i]), beyond};
    if (out < 0 || rank > most) most = rank, out = int(i);
  }
  return out;
}

void leave_out(Freedom& freedom, int at, const Eigen::VectorXd& deviation, std::vector<Dropped>& left_open) {
  left_open.push_back({freedom.active[std::size_t(at)], deviation[at]});
  freedom.active.erase(freedom.active.begin() + at);
}

/// Of all rows: the largest of what `of` gives, of the motion along the joint's axes.
template <class Fn>
double largest(const Data& data, const MakeModel& make, const Fit& fit, Fn&& of) {
  double out = 0;
  const Model model = make(tied(fit.p, fit.freedom));
  const Mat3<double> H = model.spec.a.H;
  for (const Vec6& motion : respond(data, make, tied(fit.p, fit.freedom), {}, false, {}).motions) {
    if (!motion.allFinite()) continue;
    Vec6 own;
    own << H.transpose() * motion.head<3>(), H.transpose() * motion.tail<3>();
    out = std::max(out, std::abs(double(of(own))));
  }
  return out;
}

std::string pair_text(int i) {
  const int j = std::min((i + 1) % 3, (i + 2) % 3), k = std::max((i + 1) % 3, (i + 2) % 3);
  return fmt::format("{}-{}", j + 1, k + 1);
}

/// The two stiffnesses of a pair are the same as far as the data tell.
std::string isotropic(const Vec3<double>& k, const Fit& fit, int stiffness, int i, bool is_angular) {
  const int j = (i + 1) % 3, l = (i + 2) % 3;
  if (!fit.is_active(stiffness + j) || !fit.is_active(stiffness + l)) return "";
  const double apart = std::abs(std::log(k[j] / k[l]));
  const double noise = std::hypot(fit.deviation(stiffness + j), fit.deviation(stiffness + l));
  if (!(apart < 0.01 || apart < 3 * noise)) return "";
  return fmt::format("the stiffnesses {} the two axes are the same within {:.1g} %",
                     is_angular ? "about" : "along", 100 * std::max(apart, 2 * noise));
}

std::string small(const Data& data, const MakeModel& make, const Fit& fit, double deviation) {
  const double turn = kDegrees * largest(data, make, fit, [](const Vec6& z) { return z.tail<3>().norm(); });
  const double factor = std::sqrt(2 * deviation / 0.1);
  return fmt::format(
      "rotations up to {:.3g} deg are too small beside the noise: second order needs about {:.2g} times as "
      "much",
      turn, factor);
}

std::string of_xi(int i, bool is_angular, double deviation, const Data& data, const Frame& frame,
                  const Fit& fit, const MakeModel& make) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const JointValues v = values_of(frame, fit.p);
  const int off = is_angular ? 3 : 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!fit.is_active(kAngularStiffness + axis))
      return fmt::format("the stiffness about axis {} is open", axis + 1);
    if (!is_angular && !fit.is_active(kLinearStiffness + axis) && axis != i)
      return fmt::format("the stiffness along axis {} is open", axis + 1);
  }
  const double both = largest(data, make, fit, [&](const Vec6& z) { return z[off + j] * z[off + k]; });
  const double one = largest(data, make, fit, [&](const Vec6& z) { return z.segment<3>(off).squaredNorm(); });
  if (one == 0) return is_angular ? "nothing turns the joint" : "nothing moves the joint";
  if (both < 1e-7 * one)
    return is_angular ? "no case turns it about both axes at once"
                      : "no case moves it along both axes at once";
  const std::string same = isotropic(is_angular ? v.angular : v.linear, fit,
                                     is_angular ? kAngularStiffness : kLinearStiffness, i, is_angular);
  if (!same.empty()) return same + ": there xi has no effect";
  return small(data, make, fit, deviation);
}

bool is_loaded(const Data& data, int first) {
  for (const LoadCase& one : data.cases) {
    for (const Vec6& l : one.loads) {
      if (!l.segment<3>(first).isZero(0)) return true;
    }
  }
  return false;
}

bool is_seen(const Data& data, int first) {
  for (const LoadCase& one : data.cases) {
    for (int i = first; i < first + 3; ++i) {
      if (one.is_measured(i)) return true;
    }
  }
  return false;
}

}  // namespace

std::string why_none(const Data& data, int first) {
  const bool turns = first == 3;
  if (!is_loaded(data, first)) return turns ? "no case has a moment" : "no case has a force";
  if (!is_seen(data, first)) return turns ? "no rotation was measured" : "no displacement was measured";
  return "";
}

std::string name_of(int place) {
  const auto axis = [&](int first) { return place - first + 1; };
  if (place < kAngularAxes) return fmt::format("stiffness about axis {}", axis(kAngularStiffness));
  if (place < kLinearStiffness)
    return fmt::format("direction of the axes of rotation, about axis {}", axis(kAngularAxes));
  if (place < kLinearAxes) return fmt::format("stiffness along axis {}", axis(kLinearStiffness));
  if (place < kCoupling)
    return fmt::format("direction of the axes of translation, about axis {}", axis(kLinearAxes));
  if (place < kJointPoint) {
    constexpr std::array<const char*, 6> kEntries = {"11", "22", "33", "23", "13", "12"};
    return fmt::format("coupling S_{}", kEntries[std::size_t(place - kCoupling)]);
  }
  if (place < kXiAngular) return fmt::format("joint point along {}", "xyz"[place - kJointPoint]);
  if (place < kXiLinear) return fmt::format("xi of moments {}", pair_text(place - kXiAngular));
  if (place < kCubic) return fmt::format("xi of forces {}", pair_text(place - kXiLinear));
  if (place == kCubic) return "cubic term";
  if (place < kLinearCube) return fmt::format("k3 about axis {}", axis(kAngularCube));
  return fmt::format("k3 along axis {}", axis(kLinearCube));
}

std::vector<Dropped> open_at_small_motion(const Data& data, const MakeModel& make, const Unknowns& start,
                                          Freedom freedom) {
  constexpr double kSmall = 1e-8;  // second order is that much smaller
  constexpr double kNone = 1e2;    // of a noise of a thousandth: beyond it is rounding
  Data small = data;
  for (LoadCase& one : small.cases) {
    for (Vec6& load : one.loads) load *= kSmall;
    for (Vec6& motion : one.motions) motion *= kSmall;
  }
  for (double& sigma : small.sigma) sigma *= kSmall;
  std::vector<Dropped> out;
  while (!freedom.active.empty()) {
    const Eigen::VectorXd deviation =
        deviations(weighted_jacobian(small, make, start, freedom, first_sigma(small)));
    const int at = worst(deviation, freedom.active, kNone);
    if (at < 0) break;
    leave_out(freedom, at, deviation, out);
  }
  return out;
}

Fit fit_identifiable(const Data& data, const MakeModel& make, const Unknowns& start, Freedom freedom,
                     const std::array<double, kChannels>& sigma, std::vector<Dropped>& left_open) {
  constexpr double kHopeless =
      1e6;  // what noise of a thousandth of the data leaves this uncertain no noise would tell
  while (!freedom.active.empty()) {
    const Eigen::VectorXd deviation =
        deviations(weighted_jacobian(data, make, start, freedom, first_sigma(data)));
    const int at = worst(deviation, freedom.active, kHopeless);
    if (at < 0) break;
    leave_out(freedom, at, deviation, left_open);
  }
  for (;;) {
    Fit out = fit(data, make, start, freedom, sigma);
    if (out.degrees <= 0) return out;
    const Eigen::VectorXd deviation = out.covariance.diagonal().cwiseSqrt();
    const int at = worst(deviation, freedom.active, 1);
    if (at < 0) return out;
    leave_out(freedom, at, deviation, left_open);
  }
}

std::string reason_of(const Dropped& one, const Data& data, const Frame& frame, const Fit& fit,
                      const MakeModel& make) {
  const int place = one.place;
  const JointValues v = values_of(frame, fit.p);
  const bool is_linear = (place >= kLinearStiffness && place < kCoupling) ||
                         (place >= kXiLinear && place < kCubic) || place >= kLinearCube;
  if (place >= kXiAngular && place < kXiLinear)
    return of_xi(place - kXiAngular, true, one.deviation, data, frame, fit, make);
  if (place >= kXiLinear && place < kCubic)
    return of_xi(place - kXiLinear, false, one.deviation, data, frame, fit, make);
  if (place >= kCoupling && place < kXiAngular) {
    const std::string forces = why_none(data, 0), other = why_none(data, 3);
    return !forces.empty()  ? forces
           : !other.empty() ? other
                            : "no case couples forces with rotations, or moments with displacements, there";
  }
  const std::string block = why_none(data, is_linear ? 0 : 3);
  if (!block.empty()) return block;
  if (place < kAngularAxes || (place >= kLinearStiffness && place < kLinearAxes))
    return place < kAngularAxes ? "no case turns the joint about it" : "no case moves the joint along it";
  if (place >= kAngularAxes && place < kLinearStiffness) {
    const std::string same = isotropic(v.angular, fit, kAngularStiffness, place - kAngularAxes, true);
    return !same.empty() ? same : "no case tells the axes across it apart";
  }
  if (place >= kLinearAxes && place < kCoupling) {
    const std::string same = isotropic(v.linear, fit, kLinearStiffness, place - kLinearAxes, false);
    return !same.empty() ? same : "no case tells the axes across it apart";
  }
  return small(data, make, fit, one.deviation);
}

}  // namespace halfway::reference::identify
