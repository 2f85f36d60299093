// Functions of one variable that are polynomials between knots: measured curves, once read, in any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace halfway::reference {

enum class Interpolation {
  linear,
  akima,    ///< C1, local
  monotone  ///< C1 without overshoot (Steffen 1990)
};

/// Between two knots, and on beyond the outer ones, c0 + c1 t + ... + c5 t^5 with t from the piece's origin.
/// Coefficients are doubles and exact: every scalar sees the same function.
struct PiecewisePolynomial {
  using Piece = std::array<double, 6>;
  std::vector<double> knots{};                          ///< increasing; none: one polynomial
  std::vector<Piece> pieces = {Piece{}};                ///< one more than knots
  Interpolation interpolation = Interpolation::linear;  ///< of points at the knots: how the pieces were made

  /// The knot at which a piece begins; of the first one that at which it ends.
  double origin(std::size_t piece) const { return knots.empty() ? 0 : knots[piece > 0 ? piece - 1 : 0]; }

  /// At a knot the piece that begins there.
  template <class T>
  std::size_t piece_at(const T& x) const {
    const auto next = std::ranges::find_if(knots, [&](double knot) { return x < T(knot); });
    return std::size_t(next - knots.begin());
  }

  template <class T>
  struct Value {
    T value, slope;
  };
  template <class T>
  Value<T> on_piece(std::size_t piece, const T& x) const {
    const T t = x - T(origin(piece));
    Value<T> out{T(0), T(0)};
    for (std::size_t k = 6; k-- > 0;) {
      out.slope = out.slope * t + out.value;
      out.value = out.value * t + T(pieces[piece][k]);
    }
    return out;
  }
  template <class T>
  Value<T> at(const T& x) const {
    return on_piece(piece_at(x), x);
  }

  /// From 0 to x, by Gauss's rule of three points: exact to degree 5, and no difference of large numbers.
  template <class T>
  T integral(const T& x) const {
    using std::sqrt;
    const bool is_back = x < T(0);
    const T from = is_back ? x : T(0), to = is_back ? T(0) : x;
    const T node = sqrt(T(3) / T(5));
    T sum(0), low = from;
    for (std::size_t i = piece_at(from), last = piece_at(to); i <= last; ++i) {
      const T high = i < last ? T(knots[i]) : to;
      const T middle = (low + high) / T(2), half = (high - low) / T(2);
      sum +=
          half *
          (T(5) * (on_piece(i, T(middle - half * node)).value + on_piece(i, T(middle + half * node)).value) +
           T(8) * on_piece(i, middle).value);
      low = high;
    }
    return (is_back ? T(-sum) : sum) / T(9);
  }
};

/// How many points it takes.
std::size_t fewest_points(Interpolation method);

/// Through points at strictly increasing finite x, at least fewest_points() of them; beyond the outer ones
/// straight on with the slope there. Values and slopes at the points are GSL's.
PiecewisePolynomial interpolated(std::span<const double> x, std::span<const double> y, Interpolation method);

}  // namespace halfway::reference
