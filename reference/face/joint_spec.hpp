// A joint as data: what a scene file or a request says, in double, exact in any scalar.
#pragma once

#include "halfway/joint.hpp"
#include "halfway/joint/parameters.hpp"
#include "reference/numbers/piecewise.hpp"

#include <Eigen/LU>

#include <memory>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

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

/// A curve for each strain: stress (N, N m) over strain (m, rad). Never changed once it is read, and so
/// shared by copies.
struct PerAxisSpec {
  std::shared_ptr<const std::vector<PiecewisePolynomial>> axes;
};

using PlainLawSpec = std::variant<LinearSpec, PolynomialSpec, PerAxisSpec>;

/// stress = law(strain - offset) + preload, n values each. A sort of law of its own: what takes linear laws
/// alone does not take one that is preloaded.
struct ShiftedSpec {
  PlainLawSpec law;
  Eigen::VectorXd offset, preload;
};

using LawSpec = std::variant<LinearSpec, PolynomialSpec, PerAxisSpec, ShiftedSpec>;

/// fn of the law as it is without offset and preload: a LinearSpec, a PolynomialSpec or a PerAxisSpec.
template <class Fn>
auto visit_unshifted(Fn&& fn, const LawSpec& law) {
  return std::visit(
      [&](const auto& spec) {
        if constexpr (std::is_same_v<decltype(spec), const ShiftedSpec&>)
          return std::visit(fn, spec.law);
        else
          return fn(spec);
      },
      law);
}

struct JointSpec : Parameters {
  Kind kind = Kind::angular;
  LawSpec law;
  JointEnd<double> a{}, b{};
};

/// A curve for each of N strains. At a knot where the slope jumps, the stiffness is that of the piece above.
template <class T, int N>
struct PerAxisLaw {
  std::shared_ptr<const std::vector<PiecewisePolynomial>> axes;

  LawResponse<T, N> operator()(const Eigen::Matrix<T, N, 1>& strain) const;
  T energy(const Eigen::Matrix<T, N, 1>& strain) const;
};

/// Any of the laws, with N strains in scalar T. Members are defined outside the class so that an extern
/// template keeps them out of every formulation's unit.
template <class T, int N>
class AnyLaw {
 public:
  using Vector = Eigen::Matrix<T, N, 1>;

  explicit AnyLaw(const LawSpec& spec);
  LawResponse<T, N> operator()(const Vector& strain) const;
  /// From no strain on.
  T energy(const Vector& strain) const;

 private:
  struct Shift {
    Vector offset, preload;
  };
  std::variant<LinearLaw<T, N>, PolynomialLaw<T, N>, PerAxisLaw<T, N>> law_;
  std::optional<Shift> shift_{};
};

namespace detail {

/// A diagonal compliance is inverted entry by entry: its digits must not depend on elimination.
template <class T, int N>
Eigen::Matrix<T, N, N> inverse_stiffness(const Eigen::Matrix<T, N, N>& m) {
  if (m.isDiagonal(T(0))) return m.diagonal().cwiseInverse().asDiagonal();
  return m.partialPivLu().inverse();
}

template <class T, int N>
LinearLaw<T, N> law_of(const LinearSpec& spec) {
  const Eigen::Matrix<T, N, N> m = spec.matrix.template cast<T>();
  return {spec.is_compliance ? inverse_stiffness<T, N>(m) : m};
}

template <class T, int N>
PolynomialLaw<T, N> law_of(const PolynomialSpec& spec) {
  return {spec.k1.template cast<T>(), spec.k3.template cast<T>(), spec.k5.template cast<T>()};
}

template <class T, int N>
PerAxisLaw<T, N> law_of(const PerAxisSpec& spec) {
  return {spec.axes};
}

}  // namespace detail

template <class T, int N>
LawResponse<T, N> PerAxisLaw<T, N>::operator()(const Eigen::Matrix<T, N, 1>& strain) const {
  LawResponse<T, N> out{Eigen::Matrix<T, N, 1>::Zero(), Eigen::Matrix<T, N, N>::Zero()};
  for (int i = 0; i < N; ++i) {
    const auto [value, slope] = (*axes)[std::size_t(i)].at(strain[i]);
    out.stress[i] = value;
    out.stiffness(i, i) = slope;
  }
  return out;
}

template <class T, int N>
T PerAxisLaw<T, N>::energy(const Eigen::Matrix<T, N, 1>& strain) const {
  T sum(0);
  for (int i = 0; i < N; ++i) sum += (*axes)[std::size_t(i)].integral(strain[i]);
  return sum;
}

template <class T, int N>
AnyLaw<T, N>::AnyLaw(const LawSpec& spec)
    : law_(visit_unshifted([](const auto& own) -> decltype(law_) { return detail::law_of<T, N>(own); },
                           spec)) {
  if (const auto* shifted = std::get_if<ShiftedSpec>(&spec))
    shift_ = {shifted->offset.template cast<T>(), shifted->preload.template cast<T>()};
}

template <class T, int N>
LawResponse<T, N> AnyLaw<T, N>::operator()(const Vector& strain) const {
  const Vector seen = shift_ ? Vector(strain - shift_->offset) : strain;
  LawResponse<T, N> out = std::visit([&](const auto& law) { return law(seen); }, law_);
  if (shift_) out.stress += shift_->preload;
  return out;
}

template <class T, int N>
T AnyLaw<T, N>::energy(const Vector& strain) const {
  const auto own = [&](const Vector& e) -> T {
    return std::visit([&](const auto& law) { return law.energy(e); }, law_);
  };
  if (!shift_) return own(strain);
  return own(strain - shift_->offset) - own(-shift_->offset) + shift_->preload.dot(strain);
}

// Those of every scene and request; the other scalars' are in instantiations.hpp.
extern template class AnyLaw<double, 3>;
extern template class AnyLaw<double, 6>;

}  // namespace halfway::reference
