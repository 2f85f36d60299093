// What a formulation is known to do: declared in its header, measured by verify, shown in the report.
#pragma once

#include "halfway/joint/pose.hpp"

namespace halfway {

/// The range in which a measured defect must lie. {0, 0}: none, to rounding. Known failures have a
/// positive band, so that a silent change is noticed.
struct Band {
  double low = 0;
  double high = 0;
  constexpr bool holds() const { return high == 0; }
};

/// The band round a measured defect, a quarter of it either way: kept from this code, for a given probe set.
/// It shows a change and proves nothing; that there is a defect, and its order, is theory.
constexpr Band near(double measured) { return {0.8 * measured, 1.25 * measured}; }

/// One band for each kind of joint.
struct PerKind {
  Band angular{}, linear{}, linear_angular{};
  constexpr const Band& of(Kind kind) const {
    return kind == Kind::angular ? angular : kind == Kind::linear ? linear : linear_angular;
  }
};

/// Defects are relative and measured by verify on its generic probes (fixed seed, anisotropic
/// stiffness, relative rotations up to 0.8 rad). The default is a joint without any defect.
struct Facts {
  PerKind moment_balance{};     ///< |sum of moments| / (|m_a| + |m_b|)
  PerKind node_order{};         ///< change of the loads when a and b are exchanged
  PerKind symmetry{};           ///< of the tangent, but for the commutator of the spins
  PerKind loop_work{};          ///< net work round a closed loop of amplitude 0.4 over the turnover
  double loop_slope = 0;        ///< that work ~ amplitude^slope, of each kind that does any; 0: none
  Band clamped_energy{};        ///< change of the energy of a body on the angular joint to a clamped node, of
                                ///< thousands of periods, relative; {0, 0} of one without potential: any
  bool has_fingerprint = true;  ///< moment on b = K theta + alpha theta x K theta + beta (..) + O(3)
  double alpha = 0.5;
  double beta = 0;  ///< in units of (k1 - k2 + k3)
};

}  // namespace halfway
