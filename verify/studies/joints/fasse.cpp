// The geometric spring against numbers computed outside this project, and against the joints that it must
// equal.
#include "verify/oracle/property.hpp"

namespace halfway::verify {
namespace {

using Loads50 = Eigen::Matrix<Real50, 12, 1>;

Draft of_fasse(const char* what, Kind kind) {
  return finding(std::string("fasse/") + what).of("fasse", to_string(kind)).about("geometric_spring");
}

JointSpec spring_spec(Kind kind, const Eigen::VectorXd& stiffness) {
  JointSpec spec;
  spec.kind = kind;
  spec.law = reference::LinearSpec{stiffness.asDiagonal(), false};
  return spec;
}

/// Node b's orientation is exp of the double's own digits, to 50 of them.
Loads50 spring_loads(const char* formulation, const JointSpec& spec, const Vec3<double>& d,
                     const Vec3<double>& theta) {
  const Pose<Real50> a, b{d.cast<Real50>(), so3::exp<Real50>(theta.cast<Real50>())};
  return reference::node_loads<Real50>(*reference::find_formulation(formulation), spec, a, b, false).q;
}

/// Computed from the definition outside this project, to nine decimals: one pose, K_f = 1, 10, 100 and
/// K_m = 2, 3, 7.
std::vector<Finding> known_numbers() {
  const Vec3<double> d(0.1, -0.2, 0.3), theta(0.5, -0.3, 0.7);
  const Vec3<double> force(-1.276833022, -10.573448288, 29.540405972);
  const Vec3<double> moment(0.475553435, -1.596694800, 4.179793293);
  constexpr double kHalfDigit = 5e-10;
  const auto off = [](const Vec3<Real50>& found, const Vec3<double>& known) {
    return double(largest_entry<Real50>((found - known.cast<Real50>()).eval()));
  };
  const Loads50 linear =
      spring_loads("fasse", spring_spec(Kind::linear, Eigen::Vector3d(1, 10, 100)), d, theta);
  const Loads50 angular = spring_loads("fasse", spring_spec(Kind::angular, Eigen::Vector3d(2, 3, 7)),
                                       Vec3<double>::Zero(), theta);
  const auto held = [](const char* what, Kind kind, double value, const char* unit) {
    return of_fasse(what, kind)
        .measured(value)
        .in(unit)
        .at_most(kHalfDigit, "half of the last digit that was given")
        .by(Oracle::independent);
  };
  return {held("known_force", Kind::linear, off(linear.segment<3>(6), force), "N"),
          held("known_moment", Kind::angular, off(angular.segment<3>(9), moment), "N m")};
}

/// The rotation alone is `quaternion`, by vectors and series of the angle.
std::vector<Finding> as_quaternion() {
  const Entry& entry = *reference::find_formulation("fasse");
  const Entry& other = *reference::find_formulation("quaternion");
  Measurement worst;
  for (const Probe& probe : probes(entry, Kind::angular, 12, 3.1)) {
    const auto a = exact_pose(probe.a, probe.spec.a), b = exact_pose(probe.b, probe.spec.b);
    const auto found = reference::node_loads<Real50>(entry, probe.spec, a, b, true);
    const auto known = reference::node_loads<Real50>(other, probe.spec, a, b, true);
    const double tangent = double(Real50((found.tangent - known.tangent).norm() / known.tangent.norm()));
    worst.include(larger(loads_apart(known.q, found.q), tangent), "random poses");
  }
  return {of_fasse("as_quaternion", Kind::angular)
              .measured(worst)
              .in("relative")
              .at_most(kRounding, kRoundingReason)
              .by(Oracle::independent)};
}

}  // namespace

void fasse(Checks& checks) {
  checks.push_back({"fasse/known_numbers", "", known_numbers});
  checks.push_back({"fasse/as_quaternion", "", as_quaternion});
}

}  // namespace halfway::verify
