// The size of an error, and the worst of several: what measured nothing is NaN, and a NaN is the worst of
// all.
//
// Folded with std::max or by comparing, an error that is not a number would be forgotten. Errors have no
// order: they fold by include() and keep_largest() alone, and verify/packaging/folds holds the sources to it.
#pragma once

#include <limits>
#include <string>
#include <utility>

namespace halfway::reference {

/// Keeps the larger. A NaN stays, whatever comes after it.
template <class T>
void keep_largest(T& largest, const T& x) {
  const bool is_nan = !(largest == largest);
  if (!is_nan && !(x <= largest)) largest = x;
}

/// The larger of two errors; NaN if one of them is.
template <class T>
T larger(T x, const T& y) {
  keep_largest(x, y);
  return x;
}

/// Largest absolute entry of an Eigen expression of T; NaN of one without entries.
template <class T, class M>
T largest_entry(const M& m) {
  using std::abs;
  if (m.size() == 0) return T(std::numeric_limits<double>::quiet_NaN());
  T out(0);
  for (const T& x : m.reshaped()) keep_largest(out, T(abs(x)));
  return out;
}

/// An error, where it was the worst and what measures it once more. NaN until something is measured.
class Measurement {
 public:
  Measurement() = default;
  Measurement(double value, std::string where = {})
      : value_(value), where_(std::move(where)), is_empty_(false) {}

  /// @return  is it the worst so far?
  bool include(double x, std::string at) {
    const bool is_nan = !is_empty_ && !(value_ == value_);
    if (is_nan || (!is_empty_ && x <= value_)) return false;
    *this = Measurement(x, std::move(at));
    return true;
  }
  /// A request of `halfway eval`, or a scene, that has the worst case.
  void set_replay(std::string text) { replay_ = std::move(text); }
  double value() const { return value_; }
  const std::string& where() const { return where_; }
  const std::string& replay() const { return replay_; }
  bool is_empty() const { return is_empty_; }

 private:
  double value_ = std::numeric_limits<double>::quiet_NaN();
  std::string where_ = "nothing measured", replay_;
  bool is_empty_ = true;
};

/// The least and the largest of some numbers; NaN until there is one, and once there is one that is NaN.
class Extent {
 public:
  void include(double x) {
    low_.include(-x, {});
    high_.include(x, {});
  }
  double low() const { return -low_.value(); }
  double high() const { return high_.value(); }

 private:
  Measurement low_, high_;  ///< of -x, of x
};

}  // namespace halfway::reference
