#include "verify/studies/newton/newton.hpp"

#include "reference/face/instantiations.hpp"

#include <cmath>
#include <numbers>

namespace halfway::reference {
namespace {

template <class T>
T epsilon() {
  return Eigen::NumTraits<T>::epsilon();
}

template <class M>
bool all_finite(const M& m) {
  using std::isfinite;
  for (const auto& x : m.reshaped()) {
    if (!isfinite(x)) return false;
  }
  return true;
}

/// What the rounding of the load and of the pose leaves of the imbalance. The tangent is that of the
/// unstrained pose: next to a singular measure the tangent has no bound, and would excuse any imbalance.
template <class T>
T rounding(const EquilibriumProblem<T>& problem, const T& factor) {
  using std::abs;
  const NodeBalance<T> at_rest = problem.balance(problem.start(), factor);
  return T(64) * epsilon<T>() * T(abs(factor) * at_rest.by_factor.norm() + at_rest.tangent.norm());
}

template <class T>
NodeMatrix<T> forward_difference(const EquilibriumProblem<T>& problem, const Pose<T>& b, const T& factor) {
  const int n = problem.unknowns();
  const T h(kDifferenceStep);
  const NodeVector<T> here = problem.balance(b, factor).imbalance;
  NodeMatrix<T> out(n, n);
  for (int j = 0; j < n; ++j) {
    NodeVector<T> step = NodeVector<T>::Zero(n);
    step[j] = h;
    out.col(j) = (here - problem.balance(problem.displaced(b, step), factor).imbalance) / h;
  }
  return out;
}

/// The matrix of one iteration from what the analytic balance gave there.
template <class T>
NodeMatrix<T> matrix(const EquilibriumProblem<T>& problem, NewtonTangent tangent, const Pose<T>& b,
                     const T& factor, const NodeMatrix<T>& analytic) {
  switch (tangent) {
    case NewtonTangent::symmetrised:
      return (analytic + analytic.transpose()) / T(2);
    case NewtonTangent::forward_difference:
      return forward_difference(problem, b, factor);
    default:
      return analytic;
  }
}

/// False where no digit of the step would be right: a pivot vanishes beside the largest one.
template <class T>
bool solvable(const NodeVector<T>& pivots) {
  using std::abs;
  T least(abs(pivots[0])), largest = least;
  for (Eigen::Index i = 1; i < pivots.size(); ++i) {
    const T pivot = abs(pivots[i]);
    if (pivot < least) least = pivot;
    if (pivot > largest) largest = pivot;
  }
  return least > epsilon<T>() * largest;
}

}  // namespace

const char* to_string(NewtonTangent tangent) {
  constexpr std::array names = {"analytic", "symmetrised", "frozen", "forward_difference"};
  return names[std::size_t(tangent)];
}

const char* to_string(NewtonEnd end) {
  constexpr std::array names = {"converged", "too many iterations", "singular tangent", "not finite"};
  return names[std::size_t(end)];
}

template <class T>
NodeMatrix<T> newton_tangent(const EquilibriumProblem<T>& problem, NewtonTangent tangent, const Pose<T>& b,
                             const T& factor) {
  return matrix(problem, tangent, b, factor, problem.balance(b, factor).tangent);
}

template <class T>
NewtonRun<T> plain_newton(const EquilibriumProblem<T>& problem, NewtonTangent tangent, const Pose<T>& start,
                          const T& factor, int most_iterations) {
  NewtonRun<T> run;
  run.poses.push_back(start);
  const T at_rounding = rounding(problem, factor);
  NodeMatrix<T> solved_with;
  while (true) {
    const Pose<T>& b = run.poses.back();
    const NodeBalance<T> balance = problem.balance(b, factor);
    if (!all_finite(balance.imbalance) || !all_finite(balance.tangent)) {
      run.end = NewtonEnd::not_finite;
      return run;
    }
    if (balance.imbalance.norm() <= at_rounding) {
      run.end = NewtonEnd::converged;
      return run;
    }
    if (run.iterations == most_iterations) return run;
    if (run.iterations == 0 || tangent != NewtonTangent::frozen) {
      solved_with = matrix(problem, tangent, b, factor, balance.tangent);
      if (!solvable<T>(lu_pivots(solved_with))) {
        run.end = NewtonEnd::singular_tangent;
        return run;
      }
    }
    const NodeVector<T> step = lu_solve(solved_with, balance.imbalance);
    if (!(step.norm() <= T(kLongestStep))) {
      run.end = NewtonEnd::singular_tangent;
      return run;
    }
    run.has_wrapped |= step.norm() > T(std::numbers::pi);
    run.poses.push_back(problem.displaced(b, step));
    ++run.iterations;
  }
}

template NodeMatrix<double> newton_tangent(const EquilibriumProblem<double>&, NewtonTangent,
                                           const Pose<double>&, const double&);
template NodeMatrix<Real50> newton_tangent(const EquilibriumProblem<Real50>&, NewtonTangent,
                                           const Pose<Real50>&, const Real50&);
template NewtonRun<double> plain_newton(const EquilibriumProblem<double>&, NewtonTangent, const Pose<double>&,
                                        const double&, int);
template NewtonRun<Real50> plain_newton(const EquilibriumProblem<Real50>&, NewtonTangent, const Pose<Real50>&,
                                        const Real50&, int);

}  // namespace halfway::reference
