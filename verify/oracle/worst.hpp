// The worst of several numbers, of which a NaN is the worst of all.
#pragma once

#include <string>
#include <utility>

namespace halfway::verify {

/// Keeps the larger. A NaN stays, whatever comes after it: comparing alone would forget it.
template <class T>
void keep_largest(T& largest, const T& x) {
  const bool is_nan = !(largest == largest);
  if (!is_nan && !(x <= largest)) largest = x;
}

/// Largest absolute entry of an Eigen expression of T.
template <class T, class M>
T largest_entry(const M& m) {
  using std::abs;
  T out(0);
  for (const T& x : m.reshaped()) keep_largest(out, T(abs(x)));
  return out;
}

/// A measured number and where it was the worst.
struct Measurement {
  double value = 0;
  std::string where{};  ///< the worst probe

  void include(double x, std::string at) {
    const bool is_nan = !(value == value);
    if (is_nan || x <= value) return;
    value = x;
    where = std::move(at);
  }
};

}  // namespace halfway::verify
