// The rotation vector of a motion that goes on beyond pi: of all theta + 2 pi k n of a relative rotation
// the one nearest to the last, so that a spring wound by several turns forgets none of them.
//
// A pose alone tells theta up to pi only. This one remembers, so it belongs to a path: one object a joint,
// one commit a step that the solver accepts. What it cannot give: at phi = 2 pi k, k != 0, every axis has
// the same R, Gamma is singular, and a path that passes there beside its axis swings theta round a sphere
// of radius 2 pi k. Then the last axis is kept, or the step is refused; see Unwrapping.
#pragma once

#include "halfway/joint/pose.hpp"

#include <cmath>
#include <optional>

namespace halfway {

enum class Unwrapping {
  continued,       ///< exp(theta) is the relative rotation to rounding
  at_full_turn,    ///< no relative rotation to rounding, after whole turns: theta is along the last axis
  step_too_large,  ///< no theta within the largest step: the branch cannot be told, or the axis is lost
  not_finite       ///< the relative rotation holds a NaN or an infinity
};

constexpr const char* to_string(Unwrapping status) {
  constexpr const char* kNames[] = {"continued", "at_full_turn", "step_too_large", "not_finite"};
  return kNames[int(status)];
}

/// What a relative rotation is after the last committed one. Refused: theta and turns are the last ones.
template <class T>
struct UnwrappedStep {
  Unwrapping status = Unwrapping::continued;
  Vec3<T> theta = Vec3<T>::Zero();  ///< rad, axes of P_a, any length
  bool odd = false;                 ///< the quaternion of theta is the opposite of the one with w >= 0
  bool accepted() const { return status == Unwrapping::continued || status == Unwrapping::at_full_turn; }
};

namespace detail {

/// 16 eps of T: what a product of a few rotations leaves of a vanishing sine.
template <class T>
T rotation_noise() {
  return T(std::ldexp(16., 1 - RealDigits<T>::value));
}

template <class T>
T two_pi() {
  using std::atan;
  return T(8) * atan(T(1));
}

}  // namespace detail

/// T: float, double, long double, multiprecision or dual numbers.
///
/// Accuracy, in eps of theta's length: as so3::log along the axis; across it the axis of R itself is known
/// to eps/sin(phi/2) only, so phi/(2 sin(phi/2)), the size of Gamma^-1, times eps.
template <class T>
class UnwrappedRotation {
 public:
  static constexpr double kLargestStep = 1.5707963267948966;  ///< pi/2, rad

  /// @param theta         where the path starts, rad
  /// @param largest_step  longest accepted |change of theta|, rad; below pi, more counts as pi: two thetas
  ///                      of the same rotation are 2 pi apart
  explicit UnwrappedRotation(const Vec3<T>& theta = Vec3<T>::Zero(), double largest_step = kLargestStep)
      : largest_step_(largest_step < 2 * kLargestStep ? largest_step : 2 * kLargestStep) {
    reset(theta);
  }

  /// The committed rotation vector, rad.
  const Vec3<T>& theta() const { return last_.theta; }

  void reset(const Vec3<T>& theta = Vec3<T>::Zero()) {
    using std::sqrt;
    last_ = {};
    last_.theta = theta;
    const double turns = double(T(sqrt(theta.squaredNorm()) / detail::two_pi<T>()));
    last_.odd = is_odd(std::round(turns));
  }

  /// Where the relative rotation q (unit, either sign) is; changes nothing, so that a solver can try it.
  UnwrappedStep<T> tried(const so3::Quaternion<T>& q) const;
  UnwrappedStep<T> tried(const Mat3<T>& R) const { return tried(so3::quaternion(R)); }

  /// The step becomes the state; a refused one changes nothing.
  void commit(const UnwrappedStep<T>& step) {
    if (step.accepted()) last_ = step;
  }

  /// Tries and commits. @param rotation  the relative rotation, matrix or unit quaternion.
  template <class Rotation>
  Unwrapping update(const Rotation& rotation) {
    const UnwrappedStep<T> step = tried(rotation);
    commit(step);
    return step.status;
  }

 private:
  static bool is_odd(double k) { return std::fmod(k, 2) != 0; }
  UnwrappedStep<T> refused(Unwrapping status) const { return {status, last_.theta, last_.odd}; }
  UnwrappedStep<T> without_axis(const Vec3<T>& wrapped) const;
  UnwrappedStep<T> along_axis(const Vec3<T>& wrapped) const;

  UnwrappedStep<T> last_;
  double largest_step_;
};

/// Along the axis of the last theta: its whole turns, and what little of the rotation is about it.
template <class T>
UnwrappedStep<T> UnwrappedRotation<T>::without_axis(const Vec3<T>& wrapped) const {
  using std::sqrt;
  const T last_squared = last_.theta.squaredNorm();
  if (last_squared < T(1)) return {Unwrapping::continued, wrapped, false};
  const T last_phi = sqrt(last_squared);
  const double turns = std::round(double(T(last_phi / detail::two_pi<T>())));
  if (turns == 0) return {Unwrapping::continued, wrapped, false};
  const Vec3<T> axis = last_.theta / last_phi;
  const T phi = T(turns) * detail::two_pi<T>() + axis.dot(wrapped);
  return {Unwrapping::at_full_turn, Vec3<T>(phi * axis), is_odd(turns)};
}

/// On the axis of the wrapped vector the point that is nearest to the last theta.
template <class T>
UnwrappedStep<T> UnwrappedRotation<T>::along_axis(const Vec3<T>& wrapped) const {
  using std::sqrt;
  const T phi = sqrt(wrapped.squaredNorm());
  const Vec3<T> axis = wrapped / phi;
  const double turns = std::round(double(T((axis.dot(last_.theta) - phi) / detail::two_pi<T>())));
  const Vec3<T> theta = wrapped + (T(turns) * detail::two_pi<T>()) * axis;
  return {Unwrapping::continued, theta, is_odd(turns)};
}

template <class T>
UnwrappedStep<T> UnwrappedRotation<T>::tried(const so3::Quaternion<T>& q) const {
  const so3::Quaternion<T> up = q.w < T(0) ? so3::Quaternion<T>{T(-q.w), Vec3<T>(-q.v)} : q;
  const T sine_squared = up.v.squaredNorm(), noise = detail::rotation_noise<T>();
  if (!std::isfinite(double(T(up.w + sine_squared)))) return refused(Unwrapping::not_finite);
  const Vec3<T> wrapped = so3::log(up);
  const UnwrappedStep<T> step = sine_squared > noise * noise ? along_axis(wrapped) : without_axis(wrapped);
  const T change = (step.theta - last_.theta).squaredNorm();
  return change <= T(largest_step_ * largest_step_) ? step : refused(Unwrapping::step_too_large);
}

/// Gamma^-1(theta) for theta of any length: theta' = Gamma^-1 spin. None where Gamma is singular to
/// rounding, |theta| = 2 pi k, k != 0; before, it grows as |theta|/(2 sin(|theta|/2)).
template <class T>
std::optional<Mat3<T>> unwrapped_rate(const Vec3<T>& theta) {
  using std::abs, std::sin, std::sqrt;
  const T s = theta.squaredNorm();
  if (s > T(1)) {
    const T half = sqrt(s) / T(2);
    if (abs(T(sin(half))) <= detail::rotation_noise<T>() * half) return std::nullopt;
  }
  return so3::gamma_inverse(theta);
}

/// The relative motion with the unwrapped vector: what a formulation of the family makes of it goes on
/// beyond pi. The quaternion gets the sign of theta, so that half-way frames turn by |theta|/2.
/// @param motion  of the same relative rotation, from relative_motion    @param step  accepted
template <class T>
RelativeMotion<T> unwrapped_motion(const RelativeMotion<T>& motion, const UnwrappedStep<T>& step) {
  RelativeMotion<T> m = motion;
  m.theta = step.theta;
  if (step.odd) m.q = {T(-m.q.w), Vec3<T>(-m.q.v)};
  return m;
}

}  // namespace halfway
