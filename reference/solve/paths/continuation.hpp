// Pseudo-arc-length continuation: the equilibria of a scene followed through folds and branchings, with
// steps that are taken only when they cannot have changed to another path.
#pragma once

#include "reference/solve/paths/singular.hpp"

#include <optional>
#include <string>
#include <vector>

namespace halfway::reference {

/// Lengths are in the path's scales: a radian counts as one, and so does the whole load.
struct ContinuationOptions {
  double end_factor = 1;     ///< the path ends when the load factor rises to this
  double lowest_factor = 0;  ///< or comes down to this: unloaded
  double first_step = 0.02;
  double largest_step = 0.1;
  double smallest_step = 1e-7;
  double largest_angle = 0.12;       ///< between successive tangents, rad
  double largest_correction = 0.06;  ///< first correction over the step
  double largest_contraction = 0.2;  ///< second correction over the first
  double largest_arc = 40;
  int largest_count = 4000;  ///< accepted steps
};

enum class PathEnd {
  end_factor,
  unloaded,
  arc_limit,
  step_limit,
  half_turn,               ///< phi = pi: rotation vectors jump there
  pole,                    ///< loads or tangent grow without bound: gimbal lock
  singular_beyond_simple,  ///< several directions become singular at once
  singular_start,          ///< the first point has no direction
  jump_not_excluded,       ///< the smallest step still looks as if it changed to another path
  no_convergence
};
const char* to_string(PathEnd end);

struct PathPoint {
  ArcState<double> state{};
  double arc = 0;
  double phi = 0;  ///< rotation from rest, 0 ... pi, rad
  ArcVector<double> tangent{};
  int stiffness_sign = 1;  ///< of the determinant of the tangent stiffness; 0: neutral to 1e-10
  int branching_sign = 1;  ///< of the determinant bordered by the path's tangent
  /// The real eigenvalue nearest zero of the tangent stiffness, over the stiffness at rest; NaN where all
  /// are complex. Not that of the symmetric part: under fixed moments the tangent is not symmetric, and
  /// only a real eigenvalue of the whole of it passes zero where the determinant does.
  double eigenvalue = 0;
  int negative = 0;  ///< real eigenvalues below zero: ways to diverge; 0 on the stable path
};

struct EquilibriumPath {
  std::vector<PathPoint> points;
  std::vector<SingularPoint> singular;  ///< in the order they are met
  PathEnd end = PathEnd::no_convergence;
  std::string outcome;  ///< for people: what ended it, and where
  int iterations = 0;   ///< of Newton, rejected steps included
  int rejected = 0;     ///< steps that were shortened
};

class Continuation {
 public:
  /// References must outlive it. @param xi  for a formulation that has one.
  Continuation(const Scene& scene, const Entry& entry, double xi, const ContinuationOptions& options,
               const Setting& setting = {});
  Continuation(const Continuation&) = delete;

  const EquilibriumProblem<double>& problem() const { return problem_; }

  /// The path of the unstrained pose, the load rising.
  EquilibriumPath from_rest() const;
  /// The path through a known point of it, on the side of `towards`.
  EquilibriumPath from(const ArcState<double>& start, const ArcVector<double>& towards) const;
  /// The two halves of the other path through a branching; empty where none could be stepped onto.
  std::vector<EquilibriumPath> other_path(const SingularPoint& branching) const;
  /// Where the path meets a load factor, in its order; a fold gives two, or none.
  std::vector<ArcState<double>> at_factor(const EquilibriumPath& path, double factor) const;
  /// How far apart two states are, in the path's scales: rad where only rotations are unknown.
  double distance(const ArcState<double>& a, const ArcState<double>& b) const {
    return step_.difference(a, b).norm();
  }

 private:
  struct Trial;
  struct Walk;
  PathPoint described(const ArcState<double>& state, const ArcVector<double>& towards, double arc) const;
  Trial attempt(const PathPoint& from, double distance) const;
  std::optional<PathEnd> looks_wrong(const PathPoint& from, const Correction<double>& correction,
                                     const PathPoint& next, double distance) const;
  std::optional<PathEnd> add_singular(Trial& trial, const PathPoint& from) const;
  std::optional<ArcState<double>> landed(const ArcState<double>& from, const ArcState<double>& to,
                                         double factor) const;
  void land(Trial& trial, const PathPoint& from) const;
  void take(Walk& walk, const Trial& trial) const;
  void close(Walk& walk, PathEnd end) const;

  ContinuationOptions options_;
  EquilibriumProblem<double> problem_;
  EquilibriumProblem<Real50> problem50_;
  ContinuationStep<double> step_;
  ContinuationStep<Real50> step50_;
};

}  // namespace halfway::reference
