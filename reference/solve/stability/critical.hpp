// Critical moments of an angular joint along its primary path: rotation about one principal axis.
//
// The loaded node is turned by phi about a joint axis from the unstrained pose, the moment about the axis is
// the one that the formulation answers. All is seen from the clamped node's joint frame: frames on the nodes
// change nothing but the place of the body's inertia. Semi- and quasi-tangential moments come in two
// settings: arms square to the forces at each state (then the moment is the magnitude), or in the unstrained
// state (dead couples: the moment is M cos(phi), which ends the path at a quarter of a turn).
#pragma once

#include "reference/face/registry.hpp"
#include "reference/solve/stability/kind.hpp"
#include "reference/solve/stability/moments.hpp"
#include "reference/solve/turned_joint.hpp"

#include <optional>
#include <vector>

namespace halfway::reference {

/// A moment type and where its couples are square.
struct MomentSetting {
  MomentType type = MomentType::fixed;
  bool square_unstrained = false;  ///< false: square at the state; only couples differ
};

/// fixed, follower, semi_tangential, quasi_tangential, dead_couples (semi-tangential, square when
/// unstrained).
inline constexpr MomentSetting kMomentSettings[] = {{MomentType::fixed, false},
                                                    {MomentType::follower, false},
                                                    {MomentType::semi_tangential, false},
                                                    {MomentType::quasi_tangential, false},
                                                    {MomentType::semi_tangential, true}};
const char* to_string(const MomentSetting& setting);

/// A state of the primary path under one moment, in the axes of the clamped node's joint frame.
template <class T>
struct LoadedState {
  Mat3<T> R;  ///< orientation of the loaded node
  Mat3<T> J;  ///< tangent of internal minus applied moment, N m
  T load{};   ///< magnitude M, N m
};

/// T is double or Real50. @param axis  0, 1 or 2, of the joint. @param angle  rad.
/// @param nodes_exchanged  the clamped node, whose end is spec.a, is listed as b.
template <class T>
LoadedState<T> loaded_state(const Entry& entry, const JointSpec& spec, int axis, const MomentSetting& setting,
                            const T& angle, bool nodes_exchanged = false);

struct Critical {
  Real50 load;   ///< M, N m
  Real50 angle;  ///< rotation about the axis, rad
};

/// Where the search ends.
enum class SearchEnd {
  half_turn,    ///< 1e-6 rad below pi
  off_axis,     ///< the formulation answers with a moment across the axis: beyond the gimbal lock
  no_more_load  ///< the moment, or the couples' grip on it, has fallen to zero
};
const char* to_string(SearchEnd end);

/// The first of each kind; nothing when there is none up to `end_angle`.
struct CriticalLoads {
  std::optional<Critical> divergence, flutter;
  double end_angle = 0;  ///< rad, to rounding in double
  SearchEnd end = SearchEnd::half_turn;
  /// What happens first.
  StabilityKind first() const;
};

/// Primary path of one formulation about one axis, sampled once for all moments and bodies.
class PrimaryPath {
 public:
  /// Angular joint whose law has the axis for a principal one. `entry` must outlive the path.
  PrimaryPath(const Entry& entry, JointSpec spec, int axis, bool nodes_exchanged = false);

  /// First divergence (the determinant changes sign, or touches zero where two turns become unstable at once)
  /// and first flutter (the discriminant becomes negative), located to 40 digits at 50. A pole of either is
  /// no critical load. Flutter in islands narrower than the samples (2 mrad) is not seen.
  /// @param setting  of the moment. @param body  at the loaded node; divergence does not depend on it.
  CriticalLoads critical(const MomentSetting& setting, const BodyInertia& body) const;

  /// Of the formulation's path, whatever the load. rad.
  double end_angle() const { return end_angle_; }

 private:
  struct Sample {
    double angle;
    TurnedJoint<double> joint;
  };
  const Entry& entry_;
  JointSpec spec_;
  int axis_;
  bool nodes_exchanged_;
  double end_angle_ = 0;
  SearchEnd end_ = SearchEnd::half_turn;
  std::vector<Sample> samples_;
};

}  // namespace halfway::reference
