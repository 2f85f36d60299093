// Constitutive laws: numbers in, numbers out. A law knows no frame, no pose and no formulation.
//
// A law is any callable that takes N strains (3 or 6, translation first; m and rad) and returns
// LawResponse<T, N>: the conjugate stresses (N, N m) and the stiffness d(stress)/d(strain). A law
// that derives from a potential also has energy(strain), J.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <array>
#include <concepts>

namespace halfway {

template <class T, int N>
struct LawResponse {
  Eigen::Matrix<T, N, 1> stress;
  Eigen::Matrix<T, N, N> stiffness;
};

template <class L, class T, int N>
concept Law = requires(const L& law, const Eigen::Matrix<T, N, 1>& strain) {
  { law(strain) } -> std::convertible_to<LawResponse<T, N>>;
};

template <class L, class T, int N>
concept ElasticLaw = Law<L, T, N> && requires(const L& law, const Eigen::Matrix<T, N, 1>& strain) {
  { law.energy(strain) } -> std::convertible_to<T>;
};

/// stress = K strain, K symmetric, N x N: isotropic, orthotropic, anisotropic or coupled.
template <class T, int N>
struct LinearLaw {
  Eigen::Matrix<T, N, N> K;

  LawResponse<T, N> operator()(const Eigen::Matrix<T, N, 1>& strain) const { return {K * strain, K}; }
  T energy(const Eigen::Matrix<T, N, 1>& strain) const { return strain.dot(K * strain) / T(2); }
};

template <class T>
LinearLaw<T, 3> isotropic_law(const T& k) {
  return {k * Mat3<T>::Identity()};
}

template <class T, int N>
LinearLaw<T, N> orthotropic_law(const Eigen::Matrix<T, N, 1>& k) {
  return {Eigen::Matrix<T, N, N>(k.asDiagonal())};
}

/// The same of a list in braces.
template <class T, int N, std::size_t M>
LinearLaw<T, N> orthotropic_law(const T (&k)[M]) {
  static_assert(M == N, "halfway: orthotropic_law<T, N> takes N stiffnesses");
  return orthotropic_law<T, N>(Eigen::Matrix<T, N, 1>(k));
}

/// Per axis stress = k1 e + k3 e^3 + k5 e^5: odd, hence the same in tension and compression;
/// hardening when k3, k5 > 0.
template <class T, int N>
struct PolynomialLaw {
  Eigen::Matrix<T, N, 1> k1, k3, k5;

  LawResponse<T, N> operator()(const Eigen::Matrix<T, N, 1>& strain) const {
    const auto e = strain.array();
    const auto s = e * e;
    const Eigen::Matrix<T, N, 1> slope = k1.array() + s * (T(3) * k3.array() + s * T(5) * k5.array());
    return {e * (k1.array() + s * (k3.array() + s * k5.array())), Eigen::Matrix<T, N, N>(slope.asDiagonal())};
  }
  T energy(const Eigen::Matrix<T, N, 1>& strain) const {
    const auto s = strain.array().square();
    return (s * (k1.array() / T(2) + s * (k3.array() / T(4) + s * k5.array() / T(6)))).sum();
  }
};

}  // namespace halfway
