#include "reference/solve/paths/continuation_step.hpp"

#include <cmath>

namespace halfway::reference {
namespace {

constexpr int kCorrections = 12;

/// Are all entries numbers? Their squares are, unless one of them is not or overflows.
template <class M>
bool all_finite(const M& m) {
  using std::isfinite;
  return isfinite(m.squaredNorm());
}

}  // namespace

template <class T>
ArcState<T> ContinuationStep<T>::moved(const ArcState<T>& from, const ArcVector<T>& v) const {
  const int n = problem_.unknowns();
  NodeVector<T> step = v.head(n);
  if (problem_.kind() != Kind::angular) step.template head<3>() *= T(scales_.length);
  return {problem_.displaced(from.b, step), from.factor + T(scales_.factor) * v[n]};
}

template <class T>
ArcVector<T> ContinuationStep<T>::difference(const ArcState<T>& from, const ArcState<T>& to) const {
  const int n = problem_.unknowns();
  ArcVector<T> v(n + 1);
  if (problem_.kind() != Kind::angular) v.template head<3>() = (to.b.x - from.b.x) / T(scales_.length);
  if (problem_.kind() != Kind::linear)
    v.template segment<3>(n - 3) = so3::log<T>(to.b.R * from.b.R.transpose());
  v[n] = (to.factor - from.factor) / T(scales_.factor);
  return v;
}

template <class T>
typename ContinuationStep<T>::Bordered ContinuationStep<T>::bordered(const ArcState<T>& at) const {
  const int n = problem_.unknowns();
  const NodeBalance<T> balance = problem_.balance(at.b, at.factor);
  ArcVector<T> scale = ArcVector<T>::Ones(n);
  if (problem_.kind() != Kind::angular) scale.template head<3>().setConstant(T(scales_.length));
  const T unit(scales_.stiffness);
  Bordered out{ArcMatrix<T>::Zero(n + 1, n + 1), ArcVector<T>::Zero(n + 1), ArcVector<T>::Zero(n + 1)};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) out.matrix(i, j) = scale[i] * balance.tangent(i, j) * scale[j] / unit;
    out.matrix(i, n) = -scale[i] * balance.by_factor[i] * T(scales_.factor) / unit;
    out.imbalance[i] = scale[i] * balance.imbalance[i] / unit;
    out.rounding[i] = scale[i] * balance.rounding[i] / unit;
  }
  return out;
}

template <class T>
ArcMatrix<T> ContinuationStep<T>::equilibrium_rows(const ArcState<T>& at) const {
  return bordered(at).matrix.topRows(problem_.unknowns());
}

/// Equilibrium and one more equation, normal . difference(base, state) = distance: a system of Newton's
/// method.
template <class T>
class ContinuationStep<T>::OnPlane {
 public:
  OnPlane(const ContinuationStep& step, const ArcState<T>& base, const ArcVector<T>& normal,
          const T& distance, const ArcState<T>& start)
      : step_(step), base_(base), normal_(normal), distance_(distance) {
    out.state = start;
  }

  NewtonLook<T> look() {
    const int n = step_.problem_.unknowns();
    Bordered system = step_.bordered(out.state);
    const ArcVector<T> gone = step_.difference(base_, out.state);
    ArcVector<T> row = normal_;
    if (step_.problem_.kind() != Kind::linear)
      row.template segment<3>(n - 3) = so3::gamma_inverse<T>(gone.template segment<3>(n - 3)).transpose() *
                                       normal_.template segment<3>(n - 3);
    system.matrix.row(n) = row.transpose();
    system.imbalance[n] = distance_ - normal_.dot(gone);
    system.rounding[n] = step_.rounding_of_difference(out.state);
    correction_ = lu_solve(system.matrix, system.imbalance);
    out.finite = all_finite(system.matrix) && all_finite(correction_);
    return {correction_.norm(), (system.imbalance.cwiseAbs().array() <= system.rounding.array()).all()};
  }
  void move() {
    const double size(correction_.norm());
    if (out.iterations == 0) out.first = size;
    if (out.iterations == 1 && out.first > 0) out.contraction = size / out.first;
    ++out.iterations;
    out.state = step_.moved(out.state, correction_);
  }
  void settle() { out.state = step_.moved(out.state, correction_); }
  /// Nothing left to correct but noise.
  bool is_noise() const { return correction_.norm() <= T(1 << 20) * Eigen::NumTraits<T>::epsilon(); }

  Correction<T> out;

 private:
  const ContinuationStep& step_;
  const ArcState<T>& base_;
  const ArcVector<T>& normal_;
  const T& distance_;
  ArcVector<T> correction_;
};

template <class T>
T ContinuationStep<T>::rounding_of_difference(const ArcState<T>& at) const {
  using std::abs;
  const T size = T(1) + at.b.x.norm() / T(scales_.length) + T(abs(at.factor)) / T(scales_.factor);
  return T(8) * Eigen::NumTraits<T>::epsilon() * size;
}

template <class T>
ArcVector<T> ContinuationStep<T>::imbalance(const ArcState<T>& at) const {
  return bordered(at).imbalance.head(problem_.unknowns());
}

template <class T>
Correction<T> ContinuationStep<T>::corrected(const ArcState<T>& base, const ArcVector<T>& normal,
                                             const T& distance, const ArcState<T>& start) const {
  OnPlane system(*this, base, normal, distance, start);
  const NewtonRun<T> run = newton<T>(system, kCorrections);
  // Near a singular point rounding moves the state far: the last correction, already found, takes half of it
  // off.
  if (run.stop == NewtonStop::rounding) system.settle();
  system.out.converged =
      run.stop == NewtonStop::rounding || (run.stop == NewtonStop::stalled && system.is_noise());
  return system.out;
}

template <class T>
Correction<T> ContinuationStep<T>::ahead(const ArcState<T>& base, const ArcVector<T>& tangent,
                                         const T& distance) const {
  return corrected(base, tangent, distance, moved(base, ArcVector<T>(distance * tangent)));
}

template <class T>
Direction<T> ContinuationStep<T>::direction(const ArcState<T>& at, const ArcVector<T>& towards) const {
  const int n = problem_.unknowns();
  ArcMatrix<T> matrix = bordered(at).matrix;
  matrix.row(n) = towards.transpose();
  const ArcVector<T> last = ArcVector<T>::Unit(n + 1, n);
  Direction<T> out;
  out.tangent = lu_solve(matrix, last).normalized();
  matrix.row(n) = out.tangent.transpose();
  out.determinant = lu_determinant(matrix);
  out.tangent_stiffness = lu_determinant<T>(matrix.topLeftCorner(n, n));
  return out;
}

template class ContinuationStep<double>;
template class ContinuationStep<Real50>;

ArcScales arc_scales(const EquilibriumProblem<double>& problem, double factor) {
  const NodeBalance<double> rest = problem.balance(problem.start(), 0);
  ArcScales out;
  out.factor = factor;
  if (problem.kind() == Kind::linear)
    out.length = lu_solve(rest.tangent, rest.by_factor).norm() * std::abs(factor);
  if (problem.kind() == Kind::linear_angular)
    out.length = std::sqrt(
        std::abs(rest.tangent.diagonal().tail<3>().sum() / rest.tangent.diagonal().head<3>().sum()));
  const ContinuationStep<double> unscaled(problem, out);
  out.stiffness = unscaled.equilibrium_rows({problem.start(), 0}).leftCols(problem.unknowns()).norm();
  return out;
}

}  // namespace halfway::reference
