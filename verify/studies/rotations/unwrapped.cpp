// The unwrapped rotation vector over several turns, against paths whose vector is known in closed form.
#include "halfway/joint/unwrapped.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace halfway::verify {
namespace {

constexpr const char* kSubject = "unwrapped";
constexpr double kPi = std::numbers::pi;

template <class T>
double epsilon() {
  return std::ldexp(1., 1 - RealDigits<T>::value);
}

template <class T>
T pi() {
  if constexpr (std::is_same_v<T, Real50>)
    return reference::pi50();
  else
    return T(kPi);
}

/// A path theta(t), t = i/steps, that starts at zero.
template <class T>
struct Winding {
  int steps;
  T phi_end;
  bool turns_axis;

  T phi(int i) const { return phi_end * T(i) / T(steps); }
  Vec3<T> axis(int i) const {
    if (!turns_axis) return Vec3<T>(T(2), T(3), T(6)) / T(7);
    const T half = T(i) / T(4 * steps);  // tan of half the angle: half a radian in all, about (0, -4, 3)/5
    const T c = (T(1) - half * half) / (T(1) + half * half), s = T(2) * half / (T(1) + half * half);
    return Vec3<T>(c, T(3) * s / T(5), T(4) * s / T(5));
  }
  Vec3<T> theta(int i) const { return phi(i) * axis(i); }
};

/// Worst error between full turns in eps of the contract, and what happened at the full turns.
struct Followed {
  Measurement error{};
  Measurement axis_error{};  ///< at a full turn, over 2 pi k |change of the axis in the last step|, less 1
  int full_turns = 0, refused = 0;
};

template <class T>
Followed follow(const Winding<T>& path) {
  using std::abs, std::sin, std::sqrt;
  Followed out;
  UnwrappedRotation<T> rotation;
  for (int i = 1; i <= path.steps; ++i) {
    const Vec3<T> theta = path.theta(i);
    const Unwrapping status = rotation.update(so3::exp<T>(theta));
    const double phi = double(path.phi(i)), error = double(T(T((tapped(rotation.theta()) - theta).norm())));
    const std::string at = fmt::format("phi = {:.6g} rad", phi);
    if (status == Unwrapping::at_full_turn) {
      ++out.full_turns;
      const double turned = double(T((path.axis(i) - path.axis(i - 1)).norm()));
      if (path.turns_axis) out.axis_error.include(std::abs(error / (phi * turned) - 1), at);
      if (!path.turns_axis) out.error.include(error / (epsilon<T>() * phi), at);
    } else if (status == Unwrapping::continued) {
      const double across = larger(1., phi / std::abs(2 * std::sin(phi / 2)));
      out.error.include(error / (epsilon<T>() * (phi + across)), at);
    } else {
      ++out.refused;
    }
  }
  return out;
}

Finding expected(const std::string& name, double value, double expectation, double limit, const char* unit,
                 const std::string& reason) {
  return finding(name)
      .about(kSubject)
      .measured(value)
      .in(unit)
      .equal(expectation, limit, reason)
      .by(Oracle::closed_form);
}

template <class T>
std::vector<Finding> wound(const std::string& name, const Winding<T>& path, int full_turns, double limit) {
  const Followed followed = follow(path);
  std::vector<Finding> out = {
      at_most(name + "/error", kSubject, followed.error, limit, "eps", Oracle::closed_form,
              "of theta's length and of its axis, which R tells to eps/sin(phi/2); a few roundings of exp "
              "and log"),
      expected(name + "/full_turns", followed.full_turns, full_turns, 0, "",
               "each is passed, none is missed"),
      expected(name + "/refused", followed.refused, 0, 0, "steps", "all steps are within the largest one")};
  if (path.turns_axis)
    out.push_back(at_most(name + "/axis_kept", kSubject, followed.axis_error, 1e-11, "relative",
                          Oracle::closed_form,
                          "at 2 pi k the last axis is kept: wrong by 2 pi k times its turn since the last "
                          "step, 0.00025 rad, which doubles tell to 1e-12"));
  return out;
}

std::vector<Finding> paths() {
  std::vector<Finding> out;
  const auto add = [&](std::vector<Finding> more) { out.insert(out.end(), more.begin(), more.end()); };
  add(wound<double>("unwrapped/fixed_axis/double", {1000, 10 * kPi, false}, 5, 4));
  add(wound<double>("unwrapped/turning_axis/double", {2000, 10 * kPi, true}, 5, 4));
  add(wound<Real50>("unwrapped/fixed_axis/fifty_digits", {500, Real50(10) * pi<Real50>(), false}, 5, 8));
  add(wound<Real50>("unwrapped/turning_axis/fifty_digits", {500, Real50(10) * pi<Real50>(), true}, 5, 8));
  return out;
}

/// A step that must be refused, or a state that must be kept: each mismatch counts.
struct Counter {
  double wrong = 0;
  std::string which{};
  void hold(bool holds, const char* what) {
    if (holds) return;
    ++wrong;
    which += std::string(which.empty() ? "" : ", ") + what;
  }
};

Mat3<double> turned(double phi) { return so3::exp<double>(phi * Vec3<double>(2, 3, 6) / 7); }

/// Past a full turn beside the axis: theta would swing by half a sphere of radius 2 pi.
bool refuses_lost_axis() {
  UnwrappedRotation<double> rotation(Vec3<double>(2 * kPi - 1, 0, 0));
  for (double t = -1; t < 1; t += 0.03) {
    if (rotation.update(so3::exp<double>(Vec3<double>(t, 0.01, 0))) == Unwrapping::step_too_large)
      return true;
  }
  return false;
}

std::vector<Finding> statuses() {
  Counter c;
  UnwrappedRotation<double> rotation;
  c.hold(rotation.update(turned(1.5)) == Unwrapping::continued, "1.5 rad accepted");
  const Vec3<double> kept = rotation.theta();
  c.hold(rotation.update(turned(3.1)) == Unwrapping::step_too_large, "1.6 rad refused");
  c.hold(rotation.theta() == kept, "state kept after a refusal");
  const auto tried = rotation.tried(turned(2.5));
  c.hold(tried.accepted() && rotation.theta() == kept, "state kept after a try");
  rotation.commit(tried);
  c.hold((tapped(rotation.theta()) - tried.theta).norm() == 0, "state is the committed one");
  const Mat3<double> nan = Mat3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  c.hold(rotation.update(nan) == Unwrapping::not_finite, "NaN refused by name");
  c.hold(refuses_lost_axis(), "lost axis refused");
  rotation.reset();
  c.hold(rotation.theta().norm() == 0, "reset");
  UnwrappedRotation<double> wide(Vec3<double>::Zero(), 3.1);
  wide.update(turned(1.2));
  wide.update(turned(4.2));
  c.hold(std::abs(wide.theta().norm() - 4.2) < 1e-14, "3 rad at once where 3.1 are allowed");
  return {at_most("unwrapped/statuses", kSubject, {c.wrong, c.which}, 0, "mismatches", Oracle::closed_form,
                  "what the header promises")};
}

/// theta' = Gamma^-1 w by dual numbers, over several turns; none at the turns themselves.
std::vector<Finding> rates() {
  using reference::pi50;
  Measurement worst;
  Counter singular;
  const Vec3<Real50> spin(Real50("0.3"), Real50("-0.7"), Real50("0.5"));
  for (const double phi : {0.5, 3., 3.5, 6., 6.6, 9., 12.4, 20., 31.}) {
    const Vec3<Real50> theta = Real50(phi) * Vec3<Real50>(2, 3, 6) / Real50(7);
    const Mat3<Real50> R = so3::exp(theta), rate = skew(spin) * R;
    Mat3<Dual50> turning = R.cast<Dual50>();
    for (int i = 0; i < 9; ++i) turning(i).d = rate(i);
    const UnwrappedRotation<Dual50> rotation(theta.cast<Dual50>());
    const auto step = rotation.tried(turning);
    const auto inverse = unwrapped_rate(theta);
    singular.hold(inverse.has_value(), "a rate between the turns");
    if (!inverse) continue;
    const Vec3<Real50> expected_rate = *inverse * spin;
    for (int i = 0; i < 3; ++i) {
      const Real50 miss = abs(tapped(step.theta[i].d) - expected_rate[i]);
      worst.include(double(miss / expected_rate.norm()), fmt::format("phi = {} rad", phi));
    }
  }
  for (int k = 1; k <= 5; ++k) {
    singular.hold(!unwrapped_rate<double>(Vec3<double>(2 * kPi * k, 0, 0)), "none at a turn, double");
    const Real50 phi = pi50() * Real50(2 * k);
    singular.hold(!unwrapped_rate<Real50>(Vec3<Real50>(phi, Real50(0), Real50(0))),
                  "none at a turn, 50 digits");
  }
  return {
      at_most("unwrapped/rate", kSubject, worst, kRounding, "relative", Oracle::independent, kRoundingReason),
      at_most("unwrapped/rate_singular", kSubject, {singular.wrong, singular.which}, 0, "mismatches",
              Oracle::closed_form, "Gamma is singular at 2 pi k, k != 0, and nowhere else")};
}

}  // namespace

void unwrapped(Checks& checks) {
  checks.push_back({"unwrapped/paths", "stability", paths});
  checks.push_back({"unwrapped/statuses", "stability", statuses});
  checks.push_back({"unwrapped/rates", "stability", rates});
}

}  // namespace halfway::verify
