// Measurements of one joint, at 50 digits: what the property checks and the mutants both call.
//
// Every measurement takes the joint as callbacks, so that a wrong twin is measured exactly as a
// formulation of the registry is. A defect is relative and 0 for a joint that has none; in 50 digits
// rounding stays below kRounding.
#pragma once

#include "verify/oracle/probes.hpp"
#include "verify/oracle/worst.hpp"

#include <functional>
#include <optional>

namespace halfway::verify {

using Dual50 = reference::Dual<Real50>;

/// What rounding leaves of a relative defect at 50 digits: 1e-50 times what the probes cancel.
inline constexpr double kRounding = 1e-40;
inline constexpr const char* kRoundingReason =
    "50 digits, and up to ten of them for the cancellation of loads that span the probes' stiffness range";

template <class T>
using LoadsFn =
    std::function<NodeLoads<T>(const JointSpec&, const Pose<T>&, const Pose<T>&, bool with_tangent)>;
template <class T>
using EnergyFn = std::function<std::optional<T>(const JointSpec&, const Pose<T>&, const Pose<T>&)>;

struct JointUnderTest {
  LoadsFn<Real50> loads;
  LoadsFn<Dual50> dual_loads;
  EnergyFn<Dual50> dual_energy;
  std::string formulation{};  ///< its name in the catalog: a failure can be replayed; empty of a wrong twin
};

/// The formulation of a registry entry. @param entry  must outlive the result.
JointUnderTest under_test(const Entry& entry);

/// The probe's pose in 50 digits, with the joint frame R H orthonormal to 50 digits: the frames H of
/// a spec are doubles, and their drift would otherwise hide everything below 1e-16.
Pose<Real50> exact_pose(const Pose<double>& pose, const JointEnd<double>& end);

/// The larger relative difference, of forces or of moments; of no forces, or no moments, the other one alone.
/// NaN of no loads.
double loads_apart(const Eigen::Matrix<Real50, 12, 1>& q, const Eigen::Matrix<Real50, 12, 1>& other);

/// |f_a + f_b| / |f_b|.
Measurement force_balance(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// |m_a + m_b + (x_b - x_a) x f_b| / (|m_a| + |m_b|).
Measurement moment_balance(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// Change of the loads when the nodes, with their ends, are exchanged; the larger one of the forces'
/// and the moments', each over its own norm.
Measurement node_swap(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// Change of the loads, seen from the moved frame, when both nodes move as one rigid body.
Measurement objectivity(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// Largest difference of the analytic tangent and the dual derivative of the loads over the largest entry.
Measurement tangent_by_duals(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// Largest difference of the loads and the dual gradient of the energy over the largest load; NaN
/// where the joint has no energy.
Measurement energy_gradient(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// |T - T^T + B| / |T| with B = diag(0, [m_a], 0, [m_b]): spins do not commute, and for loads that
/// have a potential the antisymmetric part of the tangent is exactly this one.
Measurement symmetry_defect(const JointUnderTest& joint, const std::vector<Probe>& probes);

/// Largest difference of the loads of two joints, forces and moments each over their own norm.
Measurement load_difference(const JointUnderTest& joint, const JointUnderTest& other,
                            const std::vector<Probe>& probes);

/// Work of the loads round a generic closed loop of node b, in J.
struct LoopWork {
  Real50 net;       ///< sum of dW
  Real50 turnover;  ///< sum of |dW|
  double relative() const { return std::abs(double(net / turnover)); }
};

/// @param spec       kind, law and ends; node a stays at the identity.
/// @param amplitude  of the loop: about 2 amplitude rad, and for other than angular joints also m.
/// The trapezoidal rule in `points` points converges faster than any power: 100 points leave
/// nothing above 1e-20 up to amplitude 0.4.
LoopWork loop_work(const JointUnderTest& joint, const JointSpec& spec, double amplitude, int points = 100);

/// Second-order fingerprint of an angular joint, K = diag(2, 3, 7) N m/rad:
/// m_b = K theta + alpha theta x K theta + beta (k1 - k2 + k3) (t2 t3, t3 t1, t1 t2) + O(3).
struct Fingerprint {
  double alpha = 0, beta = 0;
  double linear_defect = 0;  ///< of the first-order part from K theta, relative
  double residual = 0;       ///< of the second-order part from that form, relative
};
Fingerprint fingerprint(const JointUnderTest& joint, double xi);

}  // namespace halfway::verify
