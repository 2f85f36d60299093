// What every formulation does where the relative rotation grows large: at pi, at the full turn, and at
// the gimbal lock of those that count angles one after another.
#pragma once

#include "reference/face/registry.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

/// Stiffness of the angular joint that is turned, N m/rad; nodes without offsets or frames, node a at rest.
inline constexpr double kTurnStiffness[] = {2, 3, 7};

/// 0: (2, 3, 6)/7, generic; 1, 2, 3: an axis of the law.
inline constexpr int kTurnAxes[] = {0, 1, 2, 3};
Vec3<Real50> turn_axis(int axis);
std::string axis_name(int axis);

JointSpec turn_joint(const Entry& entry);

/// Moment on node b (N m) and its tangent (N m/rad) when b is turned by phi about the axis.
AngularLoads<Real50> turned_loads(const Entry& entry, const Vec3<Real50>& axis, const Real50& phi);

/// One pose. Sizes are those of K: |K| is the largest stiffness.
struct TurnPoint {
  std::string angle{};  ///< "pi - eps", ...
  double phi = 0;
  double moment = 0;      ///< |m| / (|K| phi)
  double smallest = 0;    ///< singular value of the tangent over |K|
  double condition = 0;   ///< of the tangent, in the spectral norm
  bool is_finite = true;  ///< else the numbers above are 0
};

/// Both sides of one angle, 1e-10 and 1e-20 rad away at 50 digits.
struct Crossing {
  std::string angle{};
  double phi = 0;
  double jump = 0;           ///< |m(+) - m(-)| / (|K| phi) in the limit
  double moment = 0;         ///< |m| / (|K| phi), the larger of both sides
  double tangent_jump = 0;   ///< of the tangent, over |K|
  double order = 0;          ///< m grows as distance^-order; 0 or less: it does not
  double tangent_order = 0;  ///< of the tangent
  std::string behaviour{};  ///< "smooth", "kink", "zero moment", "jump", "pole", "tangent pole", "not finite"
};

struct LargeRotation {
  std::string formulation{};
  int axis = 0;
  std::vector<TurnPoint> points{};
  std::vector<Crossing> crossings{};
  const Crossing& across(std::string_view angle) const;  ///< "pi/2", "pi", "3 pi/2", "2 pi"
};

/// At pi/2, pi - 1e-9, pi, pi + 1e-9, 3 pi/2, 2 pi, and across pi/2, pi, 3 pi/2, 2 pi. Computed once.
const LargeRotation& large_rotation(const Entry& entry, int axis);

/// Across one angle (rad).
Crossing crossing(const Entry& entry, const Vec3<Real50>& axis, const std::string& name, const Real50& phi);

/// Three turns about distinct axes: R = R_i(0.4) R_j(pi/2 - distance) R_k(-0.7), the pose before a lock.
struct Sequence {
  int i, j, k;
};
inline constexpr Sequence kSequences[] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
std::string sequence_name(const Sequence& s);

/// Approach to the lock of one sequence.
struct Gimbal {
  std::string formulation{}, sequence{};
  double load_order = 0,
         tangent_order = 0;                 ///< they grow as distance^-order, from 1e-8 to 1e-10 at 50 digits
  std::vector<double> distance{}, error{};  ///< rad; of the loads in double, relative
  double lost_1e6 = 0, lost_1e3 = 0;  ///< largest distance at which the error exceeds 1e-6, 1e-3; 0: none
};

/// One for each sequence at which the tangent is unbounded; none where the formulation has no lock. Computed
/// once.
const std::vector<Gimbal>& gimbal_locks(const Entry& entry);

/// Moment about the generic axis, n.m / n.K n (rad), over phi in double.
struct TurnCurve {
  std::string formulation{};
  bool unwrapped = false;  ///< the rotation vector goes on beyond pi: halfway/joint/unwrapped.hpp
  std::vector<double> phi{}, moment{};
};

/// Of R alone, 0 to 2 pi.
TurnCurve turn_curve(const Entry& entry);
/// With the unwrapped vector, 0 to 3 pi: laws on the rotation vector and on the half-way frame.
std::vector<TurnCurve> unwrapped_curves();

}  // namespace halfway::reference
