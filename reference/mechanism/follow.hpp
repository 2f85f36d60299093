// The equilibrium path of a mechanism: load steps as of one joint, stage after stage.
#pragma once

#include "reference/mechanism/equations.hpp"

#include <string>

namespace halfway::reference::mechanism {

/// The farthest that a body has been from its pose at rest, rad and m.
template <class T>
struct Moved {
  T turn{0}, shift{0};
};

/// What was reached, whether it converged or not.
template <class T>
struct Reached {
  Status status = Status::converged;
  T factor{0};
  State<T> state;
  Moved<T> moved;
  Vector<T> error;  ///< estimated, of the unknowns and of what motions exert
  int iterations = 0, steps = 0;
  T residual{0};
  int sign = 0;                           ///< of the tangent's determinant
  T carried{0};                           ///< of what acts, by stiffness that the scene does not have
  std::vector<PathKnot<T>> last, before;  ///< of each body, in its axes
  Vector<T> exerted_slope;
};

template <class T>
class Follower {
 public:
  /// The model must outlive it. Goes to load factor 0: bodies that do not fit together at rest are let go,
  /// loads that are held are put on.
  explicit Follower(const Model<T>& model);

  /// On to a load factor, through the steps of the scene.
  const Reached<T>& advance(const T& factor);
  const Reached<T>& reached() const { return reached_; }
  /// How far the way to load factor 0 came; 1 is there.
  const T& held_reached() const { return held_reached_; }
  /// Why there is no equilibrium to begin with: a load works where nothing holds a body. "": there is.
  const std::string& floats() const { return floats_; }
  /// Does something carry what the scene's joints cannot, once the bodies have moved?
  bool is_held_by_nothing() const;

  /// The equations at what was reached.
  Equations<T> equations() const;
  /// At the equilibrium of a later load factor: the sign of the tangent's determinant, 0 where none is
  /// found.
  int sign_at(const T& factor) const;

  const Model<T>& model() const { return model_; }
  const Matrix<T>& holds() const { return holds_.c; }

 private:
  void enter(const Stage<T>& stage);
  Reached<T> follow(const Reached<T>& from, const Stage<T>& stage, const T& to) const;
  NewtonRun<T> attempt(Reached<T>& out, const Stage<T>& stage, const T& factor) const;
  void look_at_start();
  State<T> ahead_of(const Reached<T>& from, const T& factor) const;
  bool is_near(const Reached<T>& from, const State<T>& found, const Vector<T>& error,
               const Moved<T>& moved) const;
  T largest_turn(const Poses<T>& from, const Poses<T>& to) const;
  void settle_holds();

  const Model<T>& model_;
  Vector<T> resting_;
  Holds<T> holds_;
  std::string floats_;
  T held_reached_{1};
  Stage<T> stage_;
  Reached<T> reached_;
};

/// Directions without stiffness, one a column: as motions, m and rad; beside the stiffness of each body's
/// forces and moments, without a unit; and as Holds<double>::c, which holds them by that stiffness.
struct FreeDirections {
  Matrix<double> motion, share, hold;
};
/// Of a tangent and the directions that are prescribed.
FreeDirections free_directions(const Model<double>& model, const Matrix<double>& K, const Matrix<double>& G);

/// "body crank, rotation about (0, 0, 1)": where direction i is largest, global axes.
std::string named_direction(const Model<double>& model, const FreeDirections& free, int i);

/// Does the load work on a motion, beyond rounding?
bool works_on(const Vector<double>& load, const Vector<double>& motion);

}  // namespace halfway::reference::mechanism
