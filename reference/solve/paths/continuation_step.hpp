// One step along an equilibrium path: pose and load factor as unknowns of equal right, so that a fold
// is a point like any other. T is double or Real50.
#pragma once

#include "reference/solve/equilibrium_problem.hpp"

namespace halfway::reference {

/// A vector of (dx / length, w, factor / factor_scale), and square matrices in it.
template <class T>
using ArcVector = SmallVector<T>;
template <class T>
using ArcMatrix = SmallMatrix<T>;

/// What makes displacements, rotations and load factors comparable.
struct ArcScales {
  double length = 1;     ///< m: a displacement of this counts as a radian
  double factor = 1;     ///< a change of the load factor by this counts as a radian
  double stiffness = 1;  ///< N m/rad: of the scaled tangent at rest
};

template <class T>
struct ArcState {
  Pose<T> b{};  ///< joint frame b seen from joint frame a, the state of EquilibriumProblem
  T factor{0};
};

/// What Newton did on its way from a prediction to the path.
template <class T>
struct Correction {
  bool converged = false;
  bool finite = true;  ///< false: the loads or the tangent are no numbers here
  ArcState<T> state{};
  int iterations = 0;      ///< corrections made
  double first = 0;        ///< length of the first
  double contraction = 0;  ///< of the second over the first
};

/// The direction of the path and what of it changes sign at singular points.
template <class T>
struct Direction {
  ArcVector<T> tangent;    ///< unit; its last component changes sign at a fold
  T determinant{0};        ///< of the equilibrium bordered by the tangent: changes sign at a branching
  T tangent_stiffness{0};  ///< determinant of the tangent stiffness alone; its sign: product of the two
};

template <class T>
class ContinuationStep {
 public:
  /// The problem must outlive it.
  ContinuationStep(const EquilibriumProblem<T>& problem, const ArcScales& scales)
      : problem_(problem), scales_(scales) {}

  const EquilibriumProblem<T>& problem() const { return problem_; }
  const ArcScales& scales() const { return scales_; }

  /// from, moved along v.
  ArcState<T> moved(const ArcState<T>& from, const ArcVector<T>& v) const;
  /// The v that moves `from` to `to`; turns below pi.
  ArcVector<T> difference(const ArcState<T>& from, const ArcState<T>& to) const;
  /// The scaled tangent stiffness with the scaled load as last column: n rows, n + 1 columns.
  ArcMatrix<T> equilibrium_rows(const ArcState<T>& at) const;
  /// applied - internal, scaled as the rows.
  ArcVector<T> imbalance(const ArcState<T>& at) const;

  /// Newton from `start` to the point of the path with normal . difference(base, point) = distance,
  /// to rounding.
  Correction<T> corrected(const ArcState<T>& base, const ArcVector<T>& normal, const T& distance,
                          const ArcState<T>& start) const;
  /// Along `tangent` by `distance`, then corrected at right angles to it.
  Correction<T> ahead(const ArcState<T>& base, const ArcVector<T>& tangent, const T& distance) const;

  /// The unit tangent at a point of the path, on the side of `towards`.
  Direction<T> direction(const ArcState<T>& at, const ArcVector<T>& towards) const;

 private:
  struct Bordered {
    ArcMatrix<T> matrix;     ///< last row not set
    ArcVector<T> imbalance;  ///< scaled; last entry not set
    ArcVector<T> rounding;   ///< that may be left of it; likewise
  };
  class OnPlane;
  /// Of `difference`, in the path's scales.
  T rounding_of_difference(const ArcState<T>& at) const;
  Bordered bordered(const ArcState<T>& at) const;

  const EquilibriumProblem<T>& problem_;
  ArcScales scales_;
};

extern template class ContinuationStep<double>;
extern template class ContinuationStep<Real50>;

/// Scales of a problem: lengths from the ratio of its stiffnesses, or from the linear response where only
/// displacements are unknown. @param factor  load factor that is far away
ArcScales arc_scales(const EquilibriumProblem<double>& problem, double factor);

/// Rotation of the loaded node from the unstrained pose, 0 ... pi, rad.
template <class T>
T turn_from_rest(const EquilibriumProblem<T>& problem, const Pose<T>& b) {
  return so3::log<T>(b.R * problem.start().R.transpose()).norm();
}

}  // namespace halfway::reference
