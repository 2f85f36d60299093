// Sums and products of 50-digit matrices, compiled once. Argument-dependent lookup finds them by their scalar
// before Eigen's own operators, whose expressions each unit would instantiate: a fifth of its compile time.
// The sums are Eigen's, in the same order; other sizes are left to Eigen.
#pragma once

#include <Eigen/Core>

#include <concepts>

namespace halfway::reference {

class Real50;
template <class R>
struct Dual;

template <class T>
concept Deep = std::same_as<T, Real50> || std::same_as<T, Dual<Real50>>;

/// Sizes that matrices50.cpp compiles.
template <int m, int n>
inline constexpr bool kIsSummed = (m == 3 || m == 6) && (n == 1 || n == m);
template <int m, int k, int n>
inline constexpr bool kIsMultiplied = (m == 3 && n == 3 && (k == 1 || k == 3)) ||
                                      (n == 1 && m == k && (m == 3 || m == 6));

template <Deep T, int m, int k, int n>
requires(kIsMultiplied<m, k, n>) Eigen::Matrix<T, m, n>
operator*(const Eigen::Matrix<T, m, k>& a, const Eigen::Matrix<T, k, n>& b);
template <Deep T, int m, int k, int n>
requires(kIsMultiplied<m, k, n>) Eigen::Matrix<T, m, n>
operator*(const Eigen::Transpose<const Eigen::Matrix<T, k, m>>& a, const Eigen::Matrix<T, k, n>& b);
template <Deep T, int m, int k, int n>
requires(kIsMultiplied<m, k, n>) Eigen::Matrix<T, m, n>
operator*(const Eigen::Matrix<T, m, k>& a, const Eigen::Transpose<const Eigen::Matrix<T, n, k>>& b);
template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Eigen::Matrix<T, m, n>
operator*(const T& s, const Eigen::Matrix<T, m, n>& a);
template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Eigen::Matrix<T, m, n>
operator+(const Eigen::Matrix<T, m, n>& a, const Eigen::Matrix<T, m, n>& b);
template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Eigen::Matrix<T, m, n>
operator-(const Eigen::Matrix<T, m, n>& a, const Eigen::Matrix<T, m, n>& b);
template <Deep T, int m, int n>
requires(kIsSummed<m, n>) Eigen::Matrix<T, m, n>
operator-(const Eigen::Matrix<T, m, n>& a);

}  // namespace halfway::reference
