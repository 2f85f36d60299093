// How far each formulation is from the truth that a mirror-symmetric body dictates: second-order
// coupling with xi = 1/2, for any elastic law (scenes C2, C6).
#include "reference/truth/second_order.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/joints/second_order_theory.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

constexpr const char* kTruth = "mirror symmetry of the body forces xi = 1/2 at second order";

/// The error of a value, held to that of the formulation's own second-order theory; reported where there is
/// none.
Finding held(Draft f, double value, const std::optional<double>& theory, double truth, double uncertainty,
             double limit, const std::string& where) {
  f.measured(std::abs(value / truth - 1), where).in("relative").by(Oracle::closed_form, uncertainty);
  if (!theory) return f.reported(std::string(kTruth) + "; no theory of this formulation: not held");
  return f.equal(std::abs(*theory / truth - 1), limit,
                 std::string(kTruth) + "; held to what second-order theory makes of this formulation");
}

/// What third orders may add, in phi^2 of the second: their coefficients are ratios of compliances, 36 at
/// most.
constexpr double kNextOrder = 36;
/// Of the moment of a force about a node that does not turn, which is exact: a dozen roundings.
constexpr double kRounded = 1e-14;

/// theta_2 under the moment of C2 at factor 1. The truth's next order is phi^2 of it.
Finding of_moment(const Entry& entry, Draft f) {
  const reference::Scene& c2 = scene("c2_parallelepiped_small");
  const Vec3<double> F = compliances(c2);
  const Vec3<double> m = c2.loads.front().value;
  const double truth = reference::second_order_rotation<double>(F, m, 0.5, 0)[1];
  const double phi = F.cwiseProduct(m).norm();
  const double value = double(rotation_at(c2.name, entry, entry.probe_xi, 1)[1]);
  const auto theory = response_to_moment(entry, F, m);
  return held(f, value, theory ? std::optional((*theory)[1]) : std::nullopt, truth, phi * phi,
              kNextOrder * phi * phi, "c2_parallelepiped_small, theta_y at 1 N m");
}

/// theta_2 under the force of C6 at factor 1. The truth's next order is the strain of the body:
/// displacement over its length of 5 m.
Finding of_force(const Entry& entry, Draft f) {
  const reference::Scene& c6 = scene("c6_compression_shear");
  const Eigen::VectorXd F = compliances(c6);
  const Vec3<double> force = c6.loads.front().value;
  const double truth = reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, 0.5)[1];
  const double strain = F.head<3>().cwiseProduct(force).norm() / 5;
  const double value = double(rotation_at(c6.name, entry, entry.probe_xi, 1)[1]);
  std::optional<double> theory;
  if (const auto xi = force_frame(entry))
    theory = reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, *xi)[1];
  return held(f, value, theory, truth, strain, strain, "c6_compression_shear, theta_y at factor 1");
}

/// The moment at node b of a linear joint without rotation under C6's displacement, against -p x f/2.
Finding of_held_orientation(const Entry& entry, Draft f) {
  const reference::Scene& c6 = scene("c6_compression_shear");
  const Eigen::VectorXd F = compliances(c6);
  JointSpec spec = c6.joint;
  spec.kind = Kind::linear;
  spec.xi = entry.probe_xi;
  spec.law = reference::LinearSpec{Eigen::MatrixXd(F.head(3).asDiagonal()), true};
  const Vec3<double> force = c6.loads.front().value;
  Pose<double> b;
  b.x = F.head<3>().cwiseProduct(force);
  const auto q = reference::node_loads<double>(entry, spec, {}, b, false).q;
  const double truth = -b.x.cross(force)[1] / 2;
  std::optional<double> theory;
  if (const auto xi = force_frame(entry)) theory = 2 * *xi * truth;
  return held(f, q[10], theory, truth, b.x.norm() / 5, kRounded,
              "moment of node b, orientation held, displacement of C6");
}

}  // namespace

void modelling_error(Checks& checks) {
  add_property(checks, "modelling_error", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 switch (kind) {
                   case Kind::angular:
                     return of_moment(entry, f);
                   case Kind::linear:
                     return of_held_orientation(entry, f);
                   default:
                     return of_force(entry, f);
                 }
               });
}

}  // namespace halfway::verify
