// How far each formulation is from the truth that a mirror-symmetric body dictates: second-order
// coupling with xi = 1/2, for any elastic law (cases.md C2, C6).
#include "reference/truth/second_order.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

constexpr const char* kReason =
    "mirror symmetry of the body forces xi = 1/2 at second order; reported, not judged";

Finding reported(Finding f, double value, double truth, double uncertainty, const std::string& where) {
  f.value = std::abs(value / truth - 1);
  f.expected = truth;
  f.uncertainty = uncertainty;
  f.unit = "relative";
  f.comparison = Comparison::report;
  f.oracle = Oracle::closed_form;
  f.reason = kReason;
  f.parameter = where;
  return f;
}

/// theta_2 under the moment of C2 at factor 1. The truth's next order is phi^2 of it.
Finding of_moment(const Entry& entry, Finding f) {
  const reference::Scene& c2 = scene("c2_parallelepiped_small");
  const Vec3<double> F = compliances(c2);
  const Vec3<double> m = c2.loads.front().value;
  const double truth = reference::second_order_rotation<double>(F, m, 0.5, 0)[1];
  const double phi = F.cwiseProduct(m).norm();
  const double value = double(rotation_at(c2.name, entry, entry.probe_xi, 1)[1]);
  return reported(f, value, truth, phi * phi, "c2_parallelepiped_small, theta_y at 1 N m");
}

/// theta_2 under the force of C6 at factor 1. The truth's next order is the strain of the body:
/// displacement over its length of 5 m.
Finding of_force(const Entry& entry, Finding f) {
  const reference::Scene& c6 = scene("c6_compression_shear");
  const Eigen::VectorXd F = compliances(c6);
  const Vec3<double> force = c6.loads.front().value;
  const double truth = reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, 0.5)[1];
  const double strain = F.head<3>().cwiseProduct(force).norm() / 5;
  const double value = double(rotation_at(c6.name, entry, entry.probe_xi, 1)[1]);
  return reported(f, value, truth, strain, "c6_compression_shear, theta_y at factor 1");
}

/// The moment at node b of a linear joint without rotation under C6's displacement, against -p x f/2.
Finding of_held_orientation(const Entry& entry, Finding f) {
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
  return reported(f, q[10], truth, b.x.norm() / 5, "moment of node b, orientation held, displacement of C6");
}

}  // namespace

void modelling_error(Checks& checks) {
  add_property(checks, "modelling_error", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Finding f) {
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
