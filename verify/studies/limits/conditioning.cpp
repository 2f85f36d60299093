#include "verify/studies/limits/conditioning.hpp"

#include "reference/face/instantiations.hpp"
#include "reference/numbers/random.hpp"
#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "verify/once.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

constexpr double kRatio = 100;  ///< of the law: stiffnesses 1 to 100 N m/rad
constexpr int kSamples = 4;     ///< poses a decade, of which the worst counts

JointSpec angular_joint(const Entry& entry) {
  JointSpec spec;
  spec.kind = Kind::angular;
  spec.xi = entry.probe_xi;
  spec.law = LinearSpec{spread_stiffness(kRatio, true), false};
  return spec;
}

template <class T>
QuaternionPose<T> pose(const Eigen::Matrix<double, 4, 1>& q) {
  return {Vec3<T>::Zero(), q.cast<T>()};
}

/// |m - exact| / (|K| phi): a moment about the softest axis has fewer digits by the law alone.
template <class T>
double miss(const Vec3<T>& m, const Vec3<Real50>& exact, double phi) {
  const Vec3<Real50> value = m.template cast<double>().template cast<Real50>();
  return double(Real50((value - exact).norm() / Real50(kRatio * phi)));
}

/// The moment at 50 digits of a pair that is exact in T.
template <class T>
struct Exact {
  QuaternionPose<T> a, b;
  Vec3<Real50> moment;
  double phi;

  Exact(const Entry& entry, const JointSpec& spec, const NodePair& pair)
      : a(pose<T>(pair.a)), b(pose<T>(pair.b)) {
    const auto exact_of = [](const QuaternionPose<T>& p) {
      return exact_pose(QuaternionPose<double>{p.x.template cast<double>(), p.q.template cast<double>()});
    };
    const Pose<Real50> at_a = exact_of(a), at_b = exact_of(b);
    moment = entry.in_real50.angular(spec, at_a, at_b, false).m_b;
    phi = double(so3::log<Real50>(at_a.R.transpose() * at_b.R).norm());
  }
};

template <class T, class Loads>
void add_decades(ErrorRows& rows, const Entry& entry, const std::string& what, const Loads& loads,
                 int first) {
  const JointSpec spec = angular_joint(entry);
  Generator g(2026);
  const auto add = [&](double phi) {
    Measurement worst;
    double at = 0;
    for (int i = 0; i < kSamples; ++i) {
      const Exact<T> exact(entry, spec, turned_pair(g, phi, false));
      if (exact.phi == 0) continue;  // both poses rounded to one: there is nothing to be relative to
      const double error = miss<T>(loads(spec, exact), exact.moment, exact.phi);
      if (worst.is_empty() || !(error <= worst.value())) at = exact.phi;
      worst.include(error, {});
    }
    if (!worst.is_empty()) rows.push_back({what, std::string(entry.name), at, worst.value()});
  };
  const double most = convex_radius(entry, spec);  // beyond, what solves refuses
  for (int decade = first; decade <= 0; ++decade)
    if (const double phi = std::pow(10., decade); phi <= most) add(phi);
  for (const double phi : {2., 3.})
    if (phi <= most) add(phi);
}

/// Nothing where the formulation has no such kernel.
template <class T>
void add_kernel(ErrorRows& rows, const Entry& entry, const std::string& what,
                const KernelEvaluators<T>& kernel, int first) {
  if (kernel.angular == nullptr) return;
  const auto loads = [&](const JointSpec& spec, const Exact<T>& e) -> Vec3<T> {
    return kernel.angular(spec, e.a, e.b, false).m_b;
  };
  add_decades<T>(rows, entry, what, loads, first);
}

}  // namespace

Mat3<double> spread_stiffness(double ratio, bool rotated) {
  const Vec3<double> k(1, std::sqrt(ratio), ratio);
  if (!rotated) return k.asDiagonal();
  const Mat3<double> Q = so3::exp<double>(Vec3<double>(0.7, -0.4, 0.9));
  const Mat3<double> K = Q * k.asDiagonal() * Q.transpose();
  return (K + K.transpose()) / 2;
}

ErrorRows errors_over_phi(const Entry& entry) {
  ErrorRows rows;
  const auto matrices = [&](const JointSpec& spec, const Exact<double>& e) -> Vec3<double> {
    return entry.in_double.angular(spec, matrix_pose(e.a), matrix_pose(e.b), false).m_b;
  };
  add_decades<double>(rows, entry, "phi/double", matrices, -16);
  add_kernel<double>(rows, entry, "phi/kernel", entry.kernel.in_double, -16);
  add_kernel<double>(rows, entry, "phi/compensated", entry.kernel.compensated, -16);
  add_kernel<float>(rows, entry, "phi/float", entry.kernel.in_float, -8);
  return rows;
}

const ErrorRows& errors(const Entry& entry, ErrorRows (*measure)(const Entry&)) {
  static verify::Once<ErrorRows, ErrorRows (*)(const Entry&)> known;
  return known(entry, measure, [&] { return measure(entry); });
}

}  // namespace halfway::reference
