// The equations of a mechanism at one load factor: the system of Newton's method.
//
// Unknowns are the motions of the bodies and, for each direction that is prescribed, the load that does it.
#pragma once

#include "reference/mechanism/model.hpp"

namespace halfway::reference::mechanism {

/// A multiplier at a load factor.
template <class T>
struct Line {
  T at_zero{0}, rate{0};
  T at(const T& factor) const { return at_zero + rate * factor; }
};

/// A part of the way on which everything grows in straight lines.
template <class T>
struct Stage {
  T begin{0}, end{1};
  std::vector<Line<T>> loads, motions;
  Line<T> holding{};  ///< of what holds the bodies where they are at rest
};

/// Stiffness against directions that nothing holds: load = sum of c (c . z), z what the bodies have moved.
template <class T>
struct Holds {
  Matrix<T> c;  ///< a column each; no column: none is needed
};

/// Where the bodies are and what moves them there.
template <class T>
struct State {
  Poses<T> at;
  Vector<T> exerted;  ///< by the motions; N, N m
};

/// What all joints do on all bodies, in the unknowns.
template <class T>
struct Internal {
  Vector<T> load, rounding;
  Matrix<T> tangent;
};
template <class T>
Internal<T> internal(const Model<T>& model, const Poses<T>& at);

/// What acts on all bodies at given multipliers.
template <class T>
Internal<T> external(const Model<T>& model, const Poses<T>& at, const std::vector<T>& multipliers);

template <class T>
class Equations {
 public:
  /// References must outlive the system. @param resting  the joints' loads on the bodies at rest
  Equations(const Model<T>& model, const Stage<T>& stage, const Vector<T>& resting, const Holds<T>& holds,
            const T& factor, State<T> start);

  NewtonLook<T> look();
  void move();

  const State<T>& state() const { return state_; }
  /// d(unknowns, exerted) / d(load factor) along the path.
  Vector<T> slope() const;
  /// What rounding, or what is left of the imbalance, can be off in each unknown: |J^-1| r.
  Vector<T> error() const;
  /// |imbalance| / |what acts|, or what rounds where nothing does
  T residual() const;
  /// m: what makes rotations comparable to displacements here.
  T length() const;
  /// Of the determinant of the whole tangent.
  int sign() const { return sign_; }
  /// The tangent in the bodies' unknowns, with what the motions exert, and the directions that they hold.
  const Matrix<T>& tangent() const { return K_; }
  const Matrix<T>& held_directions() const { return G_; }
  /// How much of what acts the holds carry.
  T carried_by_holds() const;

 private:
  void add_motions();
  void add_holds();
  void factorise();
  Vector<T> solved(const Vector<T>& r) const;

  const Model<T>& model_;
  const Stage<T>& stage_;
  const Vector<T>& resting_;
  const Holds<T>& holds_;
  T factor_;
  State<T> state_;
  Matrix<T> K_, G_, F_, inverse_;  ///< F: the loads of what motions exert; the inverse of [K, -F; G, 0]
  Vector<T> imbalance_, rounding_, by_factor_, step_;
  T acting_{0}, carried_{0};
  int sign_ = 0;
};

}  // namespace halfway::reference::mechanism
