// Error of one function of halfway/rotations/so3.hpp in one scalar, against the same input at 50 digits.
//
// A function is a type with `name`, `input` and `template <class T> apply(const Eigen matrix of T&)`,
// so that a wrong twin is measured exactly as the library's own function is.
#pragma once

#include "reference/numbers/random.hpp"
#include "reference/record/effort.hpp"
#include "verify/oracle/measures.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace halfway::verify {

enum class Input { rotation_vector, matrix, quaternion };

/// What an error in eps is relative to.
enum class Scale { absolute, largest_entry };

struct Rotation {
  Real50 phi;
  Vec3<Real50> n;     ///< unit to 50 digits
  std::string where;  ///< angle and direction, for people
};

namespace detail {

inline std::vector<Vec3<Real50>> directions() {
  std::vector<Vec3<double>> raw = {{1, 0, 0},  {0, 1, 0},  {0, 0, -1},   {1, 1, 0},
                                   {1, -1, 1}, {0, 1, -1}, {1, 1e-8, 0}, {-1e-3, 2e-5, 1}};
  reference::Generator g(2011);
  for (int i = 0; i < by_effort(6, 1); ++i) raw.push_back(g.vector(1));
  std::vector<Vec3<Real50>> out;
  for (const auto& v : raw) out.push_back(Vec3<Real50>(v.cast<Real50>().normalized()));
  return out;
}

/// Every decade, the neighbourhood of pi, and both sides of every switch below pi.
inline std::vector<std::pair<Real50, std::string>> angles() {
  std::vector<std::pair<Real50, std::string>> out;
  for (int decade = -16; decade <= 0; decade += by_effort(1, 4)) {
    for (const char* mantissa : {"1", "2.3", "6.1"}) {
      const std::string text = fmt::format("{}e{}", mantissa, decade);
      if (Real50(text.c_str()) < reference::pi50()) out.emplace_back(Real50(text.c_str()), text);
    }
  }
  for (int k = 1; k <= 12; k += by_effort(1, 4)) {
    const std::string gap = fmt::format("1e-{}", k);
    out.emplace_back(reference::pi50() - Real50(gap.c_str()), "pi - " + gap);
  }
  const auto both_sides = [&](const Real50& phi, const std::string& text) {
    for (const char* step : {"1e-3", "3e-7", "1e-15", "1e-19"}) {
      out.emplace_back(phi * (Real50(1) - Real50(step)), fmt::format("{} (1 - {})", text, step));
      out.emplace_back(phi * (Real50(1) + Real50(step)), fmt::format("{} (1 + {})", text, step));
    }
  };
  both_sides(Real50(4) * atan(Real50("0.2")), "4 atan(0.2)");       // atan_quotient
  both_sides(reference::pi50() / Real50(2), "pi/2");                // quaternion pivot, axis-aligned
  both_sides(Real50(2) * reference::pi50() / Real50(3), "2 pi/3");  // the same for (1, -1, 1)
  return out;
}

/// Beyond pi, for functions of a rotation vector of any length: the switch of the Stumpff functions.
inline std::vector<std::pair<Real50, std::string>> long_angles() {
  std::vector<std::pair<Real50, std::string>> out;
  for (const char* s : {"9.99", "9.9999999999", "10.0000000001", "10.01", "25", "36"}) {
    out.emplace_back(sqrt(Real50(s)), fmt::format("sqrt({})", s));
  }
  return out;
}

inline std::vector<Rotation> rotations(const std::vector<std::pair<Real50, std::string>>& phis) {
  const auto ns = directions();
  std::vector<Rotation> out;
  for (const auto& [phi, text] : phis) {
    for (const auto& n : ns) {
      out.push_back({phi, n,
                     fmt::format("phi = {}, n = ({:.3g}, {:.3g}, {:.3g})", text, double(n[0]), double(n[1]),
                                 double(n[2]))});
    }
  }
  return out;
}

}  // namespace detail

/// All rotations of the table, generated once; phi < pi.
inline const std::vector<Rotation>& table_rotations() {
  static const auto out = detail::rotations(detail::angles());
  return out;
}

/// Rotation vectors longer than pi, up to 6 rad.
inline const std::vector<Rotation>& long_rotations() {
  static const auto out = detail::rotations(detail::long_angles());
  return out;
}

/// The rotation as input, to 50 digits: 3x1, 3x3 or (w, v) 4x1.
template <Input input>
auto exact_input(const Rotation& r) {
  const Vec3<Real50> theta = r.phi * r.n;
  if constexpr (input == Input::rotation_vector) {
    return theta;
  } else if constexpr (input == Input::matrix) {
    return so3::exp(theta);
  } else {
    const Real50 half = r.phi / Real50(2);
    return Eigen::Matrix<Real50, 4, 1>(cos(half), sin(half) * r.n[0], sin(half) * r.n[1], sin(half) * r.n[2]);
  }
}

/// Largest entry; a NaN comes through.
inline Real50 largest(const auto& m) { return largest_entry<Real50>(m); }

template <class T>
Eigen::Matrix<T, 4, 1> as_vector(const so3::Quaternion<T>& q) {
  return {q.w, q.v[0], q.v[1], q.v[2]};
}
template <class T>
so3::Quaternion<T> as_quaternion(const Eigen::Matrix<T, 4, 1>& q) {
  return {q[0], q.template tail<3>()};
}

/// Largest error of one entry, in eps of S; NaN where a result is not finite. Where the rounded input is
/// a pole of the function (phi = pi exactly, for Cayley) the function must say so too: then 0.
template <class S, class Function>
double error_in_eps(const Rotation& r, Scale scale) {
  const auto rounded = exact_input<Function::input>(r).template cast<S>().eval();
  const auto value = tapped(Function::template apply<S>(rounded).template cast<Real50>().eval());
  const auto expected = Function::template apply<Real50>(rounded.template cast<Real50>()).eval();
  const auto finite = [](const auto& m) {
    return std::all_of(m.data(), m.data() + m.size(), [](auto x) { return isfinite(x); });
  };
  if (!finite(expected) && !finite(value)) return 0;
  if (!finite(expected) || !finite(value)) return std::numeric_limits<double>::quiet_NaN();
  const Real50 size = scale == Scale::absolute ? Real50(1) : largest(expected);
  return double(largest(value - expected) / size / Real50(double(std::numeric_limits<S>::epsilon())));
}

/// The worst over `rotations`.
template <class Fn>
Measurement worst_rotation(const std::vector<Rotation>& rotations, const Fn& error) {
  Measurement out;
  for (const Rotation& r : rotations) {
    out.include(error(r), r.where);
  }
  return out;
}

template <class S, class Function>
Measurement function_error(Scale scale) {
  return worst_rotation(table_rotations(),
                        [&](const Rotation& r) { return error_in_eps<S, Function>(r, scale); });
}

}  // namespace halfway::verify
