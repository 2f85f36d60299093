// What no formulation's face returns (a function of rotations, a batch, a solid, a reader's message) passes a
// tap on its way into a check: there a saboteur spoils it.
#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace halfway::verify {

enum class Tap { healthy, nan, slight, gross };

struct TapState {
  Tap tap = Tap::healthy;
  int passed = 0;
  /// In (-1, 1), another one for each number: one factor for all might cancel.
  double share() { return std::sin(++passed); }
};
inline TapState& tap_state() {
  static TapState state;
  return state;
}

/// For numbers that are computed once: they are kept for each tap, and pass it whenever they are asked for.
inline Tap passing() {
  ++tap_state().passed;
  return tap_state().tap;
}

/// Other numbers pass while it lives.
class ScopedTap {
 public:
  explicit ScopedTap(Tap tap) { tap_state() = {tap}; }
  ~ScopedTap() { tap_state() = {}; }
  ScopedTap(const ScopedTap&) = delete;
  ScopedTap& operator=(const ScopedTap&) = delete;
};

/// A number: as it is, NaN, off by up to 1e-6 of itself, or by up to a tenth and a thousandth more.
template <class T>
T tapped(const T& x) {
  const double share = tap_state().share();
  switch (tap_state().tap) {
    case Tap::nan:
      return T(x * T(std::numeric_limits<double>::quiet_NaN()));
    case Tap::slight:
      return T(x * T(1 + 1e-6 * share));
    case Tap::gross:
      return T(x * T(1 + 0.1 * share) + T(1e-3 * share));
    default:
      return x;
  }
}

/// Each entry of a matrix.
template <class M>
requires requires { typename M::PlainObject; }
typename M::PlainObject tapped(const M& m) {
  typename M::PlainObject out = m;
  for (auto& x : out.reshaped()) x = tapped(x);
  return out;
}

/// A message: as it is, or another one.
inline std::string tapped(const std::string& text) {
  ++tap_state().passed;
  return tap_state().tap == Tap::healthy ? text : "another message";
}

}  // namespace halfway::verify
