#include "reference/solve/stability/critical.hpp"

#include "reference/numbers/zeros.hpp"
#include "reference/record/worst.hpp"
#include "reference/solve/stability/critical_zeros.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace halfway::reference {
namespace {

constexpr int kBits = 60;            // of the width of a step: beyond rounding
constexpr int kSteps = 1501;         // odd, so that no sample falls on a gimbal lock
constexpr double kNothing = 1e-9;    // of the stiffness: rounding of moments is far below, a jump far above
constexpr double kRounding = 1e-13;  // of a sixth power of rates in double

template <class T>
LoadedState<T> with_moment(const TurnedJoint<T>& joint, int axis, const MomentSetting& setting,
                           const T& angle) {
  const MomentLoad<T> load{setting.type, axis, setting.square_unstrained ? T(0) : angle};
  const AppliedMoment<T> unit = applied_moment<T>(load, T(1), about(axis, angle));
  const T M = joint.m[axis] / unit.m_M[axis];
  return {joint.R, joint.m_w - M * unit.m_w, M};
}

/// Does a state without moment across the axis exist here? @param scale  N m
bool on_axis(const TurnedJoint<double>& joint, int axis, double scale) {
  Vec3<double> across = joint.m;
  across[axis] = 0;
  return joint.m.allFinite() && joint.m_w.allFinite() && across.norm() <= kNothing * scale;
}

template <class T>
Signed<T> determinant_of(const Characteristic<T>& c) {
  using std::abs;
  return {c.det, abs(c.trace * c.trace * c.trace)};
}

template <class T>
Signed<T> minors_of(const Characteristic<T>& c) {
  return {c.minors, c.trace * c.trace};
}

template <class T>
Signed<T> discriminant_of(const Characteristic<T>& c) {
  using std::abs;
  const T trace2 = c.trace * c.trace, minors2 = c.minors * c.minors, det2 = c.det * c.det;
  return {c.discriminant(), trace2 * trace2 * trace2 + abs(minors2 * c.minors) + det2};
}

}  // namespace

const char* to_string(const MomentSetting& setting) {
  return setting.square_unstrained ? "dead_couples" : to_string(setting.type);
}

template <class T>
LoadedState<T> loaded_state(const Entry& entry, const JointSpec& spec, int axis, const MomentSetting& setting,
                            const T& angle, bool nodes_exchanged) {
  const auto joint = turned_joint<T>(entry, spec, about(axis, angle), nodes_exchanged);
  return with_moment(joint, axis, setting, angle);
}

template LoadedState<double> loaded_state(const Entry&, const JointSpec&, int, const MomentSetting&,
                                          const double&, bool);
template LoadedState<Real50> loaded_state(const Entry&, const JointSpec&, int, const MomentSetting&,
                                          const Real50&, bool);

const char* to_string(SearchEnd end) {
  switch (end) {
    case SearchEnd::half_turn:
      return "half a turn";
    case SearchEnd::off_axis:
      return "gimbal lock";
    default:
      return "no more load";
  }
}

StabilityKind CriticalLoads::first() const {
  if (flutter && (!divergence || flutter->angle < divergence->angle)) return StabilityKind::flutter;
  return divergence ? StabilityKind::divergence : StabilityKind::stable;
}

PrimaryPath::PrimaryPath(const Entry& entry, JointSpec spec, int axis, bool nodes_exchanged)
    : entry_(entry), spec_(std::move(spec)), axis_(axis), nodes_exchanged_(nodes_exchanged) {
  samples_.reserve(kSteps + 1);
  const auto joint_at = [&](double angle) {
    return turned_joint<double>(entry_, spec_, about(axis_, angle), nodes_exchanged_);
  };
  double scale = joint_at(0).m_w.norm();
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = (std::numbers::pi - 1e-6) * i / kSteps;
    const TurnedJoint<double> now = joint_at(angle);
    if (!on_axis(now, axis_, scale)) {
      const auto holds = [&](double x) { return on_axis(joint_at(x), axis_, scale); };
      end_angle_ = last_where(holds, end_angle_, angle, kBits);
      end_ = SearchEnd::off_axis;
      return;
    }
    keep_largest(scale, std::abs(now.m[axis_]));
    samples_.push_back({angle, now});
    end_angle_ = angle;
  }
}

CriticalLoads PrimaryPath::critical(const MomentSetting& setting, const BodyInertia& body) const {
  const auto at = [&](const Real50& angle) {
    const auto p = loaded_state<Real50>(entry_, spec_, axis_, setting, angle, nodes_exchanged_);
    return characteristic(p.J, body, p.R);
  };
  const auto critical_at = [&](const std::optional<Real50>& angle) -> std::optional<Critical> {
    if (!angle) return std::nullopt;
    return Critical{loaded_state<Real50>(entry_, spec_, axis_, setting, *angle, nodes_exchanged_).load,
                    *angle};
  };
  const Function50 determinant = [&](const Real50& angle) { return determinant_of(at(angle)); };
  const Function50 minors = [&](const Real50& angle) { return minors_of(at(angle)); };
  const Function50 discriminant = [&](const Real50& angle) { return discriminant_of(at(angle)); };

  CriticalLoads out{{}, {}, end_angle_, end_};
  double before = 0, before_angle = 0, minors_before = 0;
  for (const Sample& s : samples_) {
    const auto point = with_moment<double>(s.joint, axis_, setting, s.angle);
    if (s.angle > 0 && !(point.load > 0)) {
      const auto holds = [&](double x) {
        return loaded_state<double>(entry_, spec_, axis_, setting, x, nodes_exchanged_).load > 0;
      };
      out.end_angle = last_where(holds, before_angle, s.angle, kBits);
      out.end = SearchEnd::no_more_load;
      return out;
    }
    const auto c = characteristic(point.J, body, point.R);
    if (s.angle == 0 && c.det < 0) out.divergence = critical_at(Real50(0));  // unstable at rest
    if (!out.divergence && before != 0 && (c.det < 0) != (before < 0))
      out.divergence = critical_at(sign_change(determinant, before_angle, s.angle));
    if (!out.divergence && before > 0 && c.det > 0 && minors_before > 0 && c.minors < 0)
      out.divergence = critical_at(double_zero(determinant, minors, before_angle, s.angle));
    const auto d = discriminant_of(c);
    if (!out.flutter && s.angle > 0 && d.value < -kRounding * d.size)
      out.flutter = critical_at(first_negative(discriminant, s.angle - before_angle, s.angle));
    if (out.divergence && out.flutter) break;  // where the path ends then does not matter
    before = c.det;
    minors_before = c.minors;
    before_angle = s.angle;
  }
  return out;
}

}  // namespace halfway::reference
