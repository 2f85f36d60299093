// A joint as data: what a scene file or a request says, in double, exact in any scalar.
#pragma once

#include "halfway/joint.hpp"
#include "halfway/joint/parameters.hpp"

#include <Eigen/LU>

#include <string>
#include <variant>

namespace halfway::reference {

/// Linear law by its stiffness or its compliance (N, m, rad; translation first), n x n, n = 3 or 6.
/// A compliance is inverted in the scalar of the evaluation, so 50 digits stay 50 digits.
struct LinearSpec {
  Eigen::MatrixXd matrix;
  bool is_compliance = false;
};

/// Per-axis odd polynomial, n values each.
struct PolynomialSpec {
  Eigen::VectorXd k1, k3, k5;
};

using LawSpec = std::variant<LinearSpec, PolynomialSpec>;

struct JointSpec : Parameters {
  Kind kind = Kind::angular;
  LawSpec law;
  JointEnd<double> a{}, b{};
};

/// Either law, with N strains in scalar T. Members are defined outside the class so that an extern
/// template keeps them out of every formulation's unit.
template <class T, int N>
class AnyLaw {
 public:
  explicit AnyLaw(const LawSpec& spec);
  LawResponse<T, N> operator()(const Eigen::Matrix<T, N, 1>& strain) const;
  T energy(const Eigen::Matrix<T, N, 1>& strain) const;

 private:
  std::variant<LinearLaw<T, N>, PolynomialLaw<T, N>> law_;
};

namespace detail {

/// A diagonal compliance is inverted entry by entry: its digits must not depend on elimination.
template <class T, int N>
Eigen::Matrix<T, N, N> inverse_stiffness(const Eigen::Matrix<T, N, N>& m) {
  if (m.isDiagonal(T(0))) return m.diagonal().cwiseInverse().asDiagonal();
  return m.partialPivLu().inverse();
}

}  // namespace detail

template <class T, int N>
AnyLaw<T, N>::AnyLaw(const LawSpec& spec) {
  if (const auto* p = std::get_if<PolynomialSpec>(&spec)) {
    law_ = PolynomialLaw<T, N>{p->k1.template cast<T>(), p->k3.template cast<T>(), p->k5.template cast<T>()};
    return;
  }
  const auto& linear = std::get<LinearSpec>(spec);
  const Eigen::Matrix<T, N, N> m = linear.matrix.template cast<T>();
  law_ = LinearLaw<T, N>{linear.is_compliance ? detail::inverse_stiffness<T, N>(m) : m};
}

template <class T, int N>
LawResponse<T, N> AnyLaw<T, N>::operator()(const Eigen::Matrix<T, N, 1>& strain) const {
  return std::visit([&](const auto& law) { return law(strain); }, law_);
}

template <class T, int N>
T AnyLaw<T, N>::energy(const Eigen::Matrix<T, N, 1>& strain) const {
  return std::visit([&](const auto& law) { return law.energy(strain); }, law_);
}

// Those of every scene and request; the other scalars' are in instantiations.hpp.
extern template class AnyLaw<double, 3>;
extern template class AnyLaw<double, 6>;

}  // namespace halfway::reference
