// Modes of small motions round equilibria: two roads to them, their symmetry, and six unknowns.
#include "reference/solve/stability/critical.hpp"
#include "verify/oracle/property.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using namespace reference;

/// |J - J^T| / |J| where three semi-tangential moments, square at different angles, balance the joint at a
/// generic pose: nothing for loads that have a potential, because all forces then have one.
Finding symmetry_under_couples(const Entry& entry, Kind kind, Draft f) {
  Measurement worst;
  for (const Probe& probe : probes(entry, kind, 12, 0.8)) {
    const Pose<Real50> a = exact_pose(probe.a, probe.spec.a), b = exact_pose(probe.b, probe.spec.b);
    const auto inside = entry.in_real50.angular(probe.spec, a, b, true);
    std::array<MomentLoad<Real50>, 3> loads;
    Mat3<Real50> columns;
    for (int k = 0; k < 3; ++k) {
      loads[std::size_t(k)] = {MomentType::semi_tangential, k, Real50(0.2 * k)};
      columns.col(k) = applied_moment<Real50>(loads[std::size_t(k)], Real50(1), b.R).m;
    }
    const Vec3<Real50> M = columns.inverse() * inside.m_b;
    Mat3<Real50> J = inside.m_b_wb;
    for (int k = 0; k < 3; ++k) J -= applied_moment<Real50>(loads[std::size_t(k)], M[k], b.R).m_w;
    const Mat3<Real50> skewness = J - J.transpose();
    worst.include(double(largest_entry<Real50>(skewness) / largest_entry<Real50>(J)), "generic pose");
  }
  f.measured(worst);
  if (!entry.has_potential(kind))
    return f.reported("no potential: nothing says that the tangent is symmetric, and flutter is possible");
  return f.at_most(kRounding, kRoundingReason).by(Oracle::closed_form);
}

JointSpec block_spec(const Entry& entry, Kind kind) {
  JointSpec spec;
  spec.kind = kind;
  spec.xi = entry.probe_xi;
  Eigen::VectorXd k(strain_count(kind));
  k.tail<3>() << 5, 3, 2;
  if (kind != Kind::angular) k.head<3>() << 70, 110, 130;
  spec.law = LinearSpec{k.asDiagonal(), false};
  return spec;
}

/// The coefficients of the cubic at 50 digits against the symmetric functions of GSL's eigenvalues.
Finding cubic_and_eigenvalues(const Entry& entry, Kind kind, Draft f) {
  const BodyInertia body{"1:2:2.5", {1, 2, 2.5}, 1};
  const JointSpec spec = block_spec(entry, kind);
  Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    for (const MomentSetting& setting : kMomentSettings) {
      const auto p = loaded_state<double>(entry, spec, axis, setting, 0.75);
      const auto p50 = loaded_state<Real50>(entry, spec, axis, setting, Real50(0.75));
      const auto c = characteristic(p50.J, body, p50.R);
      const auto mu = modes(p.J, mass_matrix(body, p.R, 3));
      const auto sum = mu[0] + mu[1] + mu[2], minors = mu[0] * mu[1] + mu[1] * mu[2] + mu[2] * mu[0];
      const double size = larger(larger(std::abs(mu[0]), std::abs(mu[1])), std::abs(mu[2]));
      const std::string at = std::string(to_string(setting)) + " moment about " + std::to_string(axis + 1);
      worst.include(std::abs(sum - double(c.trace)) / size, at);
      worst.include(std::abs(minors - double(c.minors)) / (size * size), at);
      worst.include(std::abs(mu[0] * mu[1] * mu[2] - double(c.det)) / (size * size * size), at);
    }
  }
  return f.measured(worst)
      .in("relative to powers of the largest eigenvalue")
      .at_most(
          2e-14,
          "GSL's balanced QR and the joint's tangent in double, some tens of eps of the largest eigenvalue")
      .by(Oracle::independent);
}

/// The tangent of the forces alone at the turned pose of no force, by the linear kind.
Mat3<double> force_tangent(const Entry& entry, const Mat3<double>& R) {
  JointSpec spec = block_spec(entry, Kind::linear);
  Pose<double> b;
  b.R = R;
  return entry.in_double.point(spec, Pose<double>{}, b, true).tangent.block<3, 3>(6, 6);
}

/// Largest distance of a mode to the nearest of the other list, relative to the largest.
double distance(const std::vector<std::complex<double>>& some,
                const std::vector<std::complex<double>>& others) {
  double worst = 0, largest = 0;
  for (const auto& mu : some) {
    Extent to_others;
    for (const auto& other : others) to_others.include(std::abs(mu - other));
    keep_largest(worst, to_others.low());
    keep_largest(largest, std::abs(mu));
  }
  return worst / largest;
}

/// Where no force acts, the six modes are those of the linear and those of the angular joint.
Finding six_modes(const Entry& entry, Kind kind, Draft f) {
  if (entry.needs_length)
    return f.left_out(
        "its rod's rotations and displacements are coupled beyond the linear order: no six modes fall apart");
  const BodyInertia body{"1:2:2.5", {1, 2, 2.5}, 4};
  const MomentSetting setting{MomentType::follower, false};
  Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    const auto p = loaded_state<double>(entry, block_spec(entry, Kind::angular), axis, setting, 0.75);
    Pose<double> b;
    b.R = p.R;
    const auto whole = entry.in_double.point(block_spec(entry, kind), Pose<double>{}, b, true);
    Eigen::MatrixXd J = whole.tangent.bottomRightCorner<6, 6>();
    J.bottomRightCorner<3, 3>() -= applied_moment<double>({setting.type, axis, 0}, p.load, p.R).m_w;
    auto expected = modes(p.J, mass_matrix(body, p.R, 3));
    for (const auto& mu : modes(force_tangent(entry, p.R), body.mass * Mat3<double>::Identity()))
      expected.push_back(mu);
    const auto six = modes(J, mass_matrix(body, p.R, 6));
    worst.include(larger(distance(six, expected), distance(expected, six)),
                  "axis " + std::to_string(axis + 1));
  }
  return f.measured(worst)
      .in("relative to the largest eigenvalue")
      .at_most(1e-14, "QR in double, some tens of eps of the largest eigenvalue")
      .by(Oracle::independent);
}

/// Strained but without force: springs between turned bodies must not flutter. Largest imaginary part of the
/// modes of three displacements at a rotation of 0.75 rad.
Finding flutter_without_load(const Entry& entry, Kind kind, Draft f) {
  Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    const Mat3<double> R = so3::exp<double>(0.75 * Vec3<double>::Unit(axis));
    for (const auto& mu : modes(force_tangent(entry, R), Mat3<double>::Identity()))
      worst.include(std::abs(mu.imag()) / 130, "rotation about axis " + std::to_string(axis + 1));
  }
  f.measured(worst).in("imaginary part over the largest stiffness");
  if (!entry.has_potential(kind))
    return f.reported("no potential: above 0, the motion grows by itself without any load");
  return f.at_most(1e-14, "a symmetric tangent has real eigenvalues; tens of eps").by(Oracle::closed_form);
}

}  // namespace

void stability_kind(Checks& checks) {
  add_property(checks, "symmetry_under_couples", {Kind::angular}, symmetry_under_couples);
  add_property(checks, "cubic_and_eigenvalues", {Kind::angular}, cubic_and_eigenvalues);
  add_property(checks, "six_modes", {Kind::linear_angular}, six_modes);
  add_property(checks, "flutter_without_load", {Kind::linear}, flutter_without_load);
}

}  // namespace halfway::verify
