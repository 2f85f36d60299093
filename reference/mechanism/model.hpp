// A mechanism in numbers of one scalar: bodies in axes of their own, joints in theirs, loads and motions.
//
// The state of a body is how its reference point and its orientation have moved from where they were while
// nothing was loaded, in constant axes: those of its first joint, at that joint's point. So it is of a joint
// between the ground and a loaded body what halfway/equilibrium takes for its unknowns: no lever and no frame
// of a node enters a stiff direction, and a strain is no difference of two positions.
#pragma once

#include "halfway/equilibrium.hpp"
#include "reference/face/registry.hpp"
#include "reference/scene/mechanism_scene.hpp"

#include <vector>

namespace halfway::reference::mechanism {

/// In the unknowns of all bodies.
template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
template <class T>
using Vec6 = Eigen::Matrix<T, 6, 1>;
template <class T>
using Mat6 = Eigen::Matrix<T, 6, 6>;

/// How each body has moved, see above; clamped ones have not.
template <class T>
using Poses = std::vector<Pose<T>>;

template <class T>
struct Body {
  std::optional<Kind> moves;
  int first = 0;                    ///< of its unknowns
  Pose<T> rest;                     ///< of its node, global axes
  Mat3<T> E = Mat3<T>::Identity();  ///< its axes -> global axes
  Vec3<T> point = Vec3<T>::Zero();  ///< its reference point, axes of the body, m
  int count() const { return moves ? halfway::unknown_count(*moves) : 0; }
  /// From the reference point to another point of the body at rest, in E's axes.
  Vec3<T> arm(const Vec3<T>& p) const { return E.transpose() * (rest.R * (p - point)); }
};

/// One node of a joint: from the axes of its body to those of the joint at rest, A.
template <class T>
struct Node {
  int body = 0;
  bool is_own = false;              ///< the body's axes are the joint's: U is the identity
  Mat3<T> U = Mat3<T>::Identity();  ///< body's axes -> A
  Vec3<T> arm = Vec3<T>::Zero();    ///< from the body's reference point to the joint point at rest, A
};

template <class T>
struct JointModel {
  JointSpec spec;                   ///< without ends: its nodes are the joint points
  Mat3<T> A = Mat3<T>::Identity();  ///< joint frame a at rest -> global axes
  Node<T> a, b;
  Vec3<T> gap = Vec3<T>::Zero();         ///< from joint point a to b at rest, A
  Mat3<T> misfit = Mat3<T>::Identity();  ///< joint frame b seen from a at rest
};

template <class T>
struct Motions {
  SceneMotion scene;
  Vec3<T> value, arm;  ///< axes of the body; arm of the point
  int first = 0;       ///< of its equations
  int count() const { return scene.axis < 0 ? 3 : 1; }
};

/// A joint's loads on the two bodies about their reference points, in their axes, (f_a, m_a, f_b, m_b), and
/// what they are made of.
template <class T>
struct JointLoads {
  Eigen::Matrix<T, 12, 1> load, rounding;
  Eigen::Matrix<T, 12, 12> tangent;
};

/// The joint as its formulation sees it.
template <class T>
struct Seen {
  Pose<T> pose;      ///< joint frame b seen from joint frame a
  Mat3<T> S_a, S_b;  ///< how the nodes' bodies have turned, A
  Vec3<T> r_a, r_b;  ///< from the reference points to the joint points, A
};

template <class T>
class Model {
 public:
  /// References must outlive it. Throws nothing: the scene is checked.
  Model(const MechanismScene& scene, const Entry& entry, double xi);

  const MechanismScene& scene() const { return scene_; }
  const Entry& entry() const { return entry_; }
  const std::vector<Body<T>>& bodies() const { return bodies_; }
  const std::vector<JointModel<T>>& joints() const { return joints_; }
  const std::vector<Motions<T>>& motions() const { return motions_; }
  int unknowns() const { return unknowns_; }
  int prescribed() const { return prescribed_; }

  Seen<T> seen(const JointModel<T>& joint, const Poses<T>& at) const;
  JointLoads<T> loads(const JointModel<T>& joint, const Poses<T>& at) const;
  /// What load i of the scene does on its body at multiplier 1, in the body's axes.
  Applied<T, 6> applied_load(std::size_t i, const Poses<T>& at) const;
  int body_of_load(std::size_t i) const { return scene_.loads[i].body; }

  /// All bodies moved by a step in the unknowns.
  Poses<T> moved(const Poses<T>& at, const Vector<T>& step) const;
  /// Of a body, (dx, psi) with zeros where nothing is unknown; and back, into the vector of all.
  Vec6<T> of_body(const Vector<T>& all, const Body<T>& body) const;
  void add_to_body(Vector<T>& all, const Body<T>& body, const Vec6<T>& part) const;

 private:
  const MechanismScene& scene_;
  const Entry& entry_;
  std::vector<Body<T>> bodies_;
  std::vector<JointModel<T>> joints_;
  std::vector<JointLoad<T>> loads_;
  std::vector<Motions<T>> motions_;
  int unknowns_ = 0, prescribed_ = 0;
};

/// Where the unknowns of a body are among (dx, psi), and how many.
inline int first_direction(Kind kind) { return kind == Kind::angular ? 3 : 0; }

}  // namespace halfway::reference::mechanism
