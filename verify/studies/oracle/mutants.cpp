// Wrong twins that a named measurement must see: a suite that lets one live would prove nothing.
#include "verify/oracle/mutants/forms.hpp"
#include "verify/oracle/mutants/functions.hpp"
#include "verify/oracle/mutants/verdicts.hpp"
#include "verify/oracle/twins.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

namespace m = wrong;

/// A joint measured on generic probes of `kind` in frame xi.
template <class Mutant, class Right>
void add_joint(Checks& checks, const char* name, const char* measure, Kind kind, double xi,
               Measurement (*of_probes)(const JointUnderTest&, const std::vector<Probe>&)) {
  add_mutant(checks, name, measure, kRounding, [=] {
    const Entry* entry = reference::find_formulation("invariant");
    std::vector<Probe> set = entry ? probes(*entry, kind, 4, 1.2) : std::vector<Probe>{};
    for (Probe& probe : set) probe.spec.xi = xi;
    return std::pair{of_probes(twin<Mutant>(), set), of_probes(twin<Right>(), set)};
  });
}

template <class Parts>
void add_projected(Checks& checks, const char* name, const char* measure, Kind kind, double xi,
                   Measurement (*of_probes)(const JointUnderTest&, const std::vector<Probe>&)) {
  add_joint<m::Projected<Parts>, m::Projected<m::Healthy>>(checks, name, measure, kind, xi, of_probes);
}

/// A function of a rotation in double, in eps; 4 is the contract of so3.hpp.
template <class Mutant, class Right>
void add_function(Checks& checks, const char* name, const char* measure) {
  add_mutant(checks, name, measure, 4, [] {
    return std::pair{function_error<double, Mutant>(Scale::largest_entry),
                     function_error<double, Right>(Scale::largest_entry)};
  });
}

/// The fingerprint of a twin in frame xi: distance of (alpha, beta) and of the linear part from the right
/// ones.
template <class Form>
Measurement fingerprint_defect(double xi) {
  const Fingerprint f = fingerprint(twin<Form>(), xi);
  return {larger(larger(std::abs(f.alpha - xi), std::abs(f.beta)), f.linear_defect),
          fmt::format("alpha = {:.6g}, beta = {:.6g}, linear part off by {:.3g}", f.alpha, f.beta,
                      f.linear_defect)};
}

template <class Parts>
void add_fingerprint(Checks& checks, const char* name, double xi) {
  add_mutant(checks, name, "second_order_fingerprint", 1e-12, [=] {
    return std::pair{fingerprint_defect<m::Projected<Parts>>(xi),
                     fingerprint_defect<m::Projected<m::Healthy>>(xi)};
  });
}

/// |R(e) - R| for Euler angles read in one sequence and recomposed in body 3-1-2 order.
template <int I, int J, int K>
Measurement euler_312_recomposed() {
  return worst_rotation(table_rotations(), [](const Rotation& r) {
    const Vec3<Real50> theta = r.phi * r.n / Real50(3);  // |angle| < pi/2: no gimbal lock
    RelativeMotion<Real50> motion;
    motion.R = so3::exp(theta);
    const Vec3<Real50> e = EulerMeasure<I, J, K>::strain(motion);
    const auto turn = [&](int axis) { return so3::exp<Real50>(e[axis] * Vec3<Real50>::Unit(axis)); };
    return double(largest(Mat3<Real50>(turn(2) * turn(0) * turn(1) - motion.R)));
  });
}

}  // namespace

void mutants(Checks& checks) {
  const Kind angular = Kind::angular, linear = Kind::linear, both = Kind::linear_angular;
  add_projected<m::TransposedFrame>(checks, "transposed_frame", "node_order", both, 0.5, node_swap);
  add_projected<m::ProjectedWithNodeA>(checks, "projected_with_node_a", "node_order", both, 0.5, node_swap);
  add_projected<m::SpinNotTransposed>(checks, "spin_not_transposed", "moment_balance", both, 0.5,
                                      moment_balance);
  add_projected<m::XiForOneMinusXiInMoment>(checks, "xi_for_one_minus_xi_in_moment", "moment_balance", both,
                                            0.3, moment_balance);
  add_projected<m::OffsetWithoutArm>(checks, "offset_without_arm", "moment_balance", both, 0.5,
                                     moment_balance);
  add_projected<m::NoArmMoment>(checks, "no_arm_moment", "moment_balance", both, 0.5, moment_balance);
  add_projected<m::PrintedEq29>(checks, "eq_29_as_printed", "energy_gradient", linear, 0.3, energy_gradient);
  add_projected<m::HalfRate>(checks, "half_rate_of_halfway_frame", "energy_gradient", linear, 0.5,
                             energy_gradient);
  add_projected<m::OffsetCarriedByNodeA>(checks, "offset_b_carried_by_a", "energy_gradient", linear, 0.5,
                                         energy_gradient);
  add_joint<m::ConformalSecant<2>, m::ConformalSecant<4>>(checks, "secant_of_half_angle", "energy_gradient",
                                                          angular, 0.5, energy_gradient);
  add_joint<m::AngularTangent<m::NoGeometricTerm>, m::AngularTangent<m::RightTangent>>(
      checks, "tangent_without_geometric_term", "tangent", angular, 0.3, tangent_by_duals);
  add_joint<m::AngularTangent<m::GammaForInverse>, m::AngularTangent<m::RightTangent>>(
      checks, "tangent_with_gamma_for_inverse", "tangent", angular, 0.3, tangent_by_duals);
  add_fingerprint<m::XiForOneMinusXi>(checks, "xi_for_one_minus_xi", 0.3);
  add_fingerprint<m::LogOfTranspose>(checks, "log_of_transpose", 0.5);
  add_function<m::GammaLateThreshold, m::Gamma>(checks, "gamma_late_threshold", "so3/gamma/double");
  add_function<m::GammaSeriesSign, m::Gamma>(checks, "gamma_series_sign", "so3/gamma/double");
  add_function<m::LogBySine, m::Log>(checks, "log_by_sine_near_pi", "so3/log_matrix/double");
  add_mutant(checks, "euler_321_for_312", "recomposition of the angles", 1e-45, [] {
    return std::pair{euler_312_recomposed<2, 1, 0>(), euler_312_recomposed<2, 0, 1>()};
  });
}

}  // namespace halfway::verify
