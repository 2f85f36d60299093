// What a formulation is known to do: declared in its header, measured by verify, shown in the report.
#pragma once

namespace halfway {

/// The range in which a measured defect must lie. {0, 0}: none, to rounding. Known failures have a
/// positive band, so that a silent change is noticed.
struct Band {
  double low = 0;
  double high = 0;
  constexpr bool holds() const { return high == 0; }
};

/// Defects are relative and measured by verify on its generic probe poses (fixed seed, anisotropic
/// stiffness, |theta| <= 0.8 rad). The default is a joint without any defect.
struct Facts {
  Band moment_balance{};       ///< |sum of moments| / (|m_a| + |m_b|), linear/angular joint
  Band node_order_angular{};   ///< change of the loads when a and b are exchanged, angular joint
  Band node_order_linear{};    ///< the same, linear joint
  double loop_slope = 0;       ///< work round a closed loop ~ amplitude^slope, angular; 0: none
  bool has_fingerprint = true; ///< moment on b = K theta + alpha theta x K theta + beta (..) + O(3)
  double alpha = 0.5;
  double beta = 0;             ///< in units of (k1 - k2 + k3)
};

}  // namespace halfway
