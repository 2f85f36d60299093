// Equilibrium of a joint in its own coordinates: the pose of joint frame b seen from joint frame a.
//
// x = P_a^T d and R = P_a^T P_b are what every strain follows from. Carried as they are, the strain of a
// stiff direction is never the difference of two large positions, and a lever costs no digit.
#pragma once

#include "halfway/equilibrium/joint_load.hpp"
#include "halfway/equilibrium/newton.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace halfway {

/// The joint's load on b at its joint point and its derivative by (dx, psi), axes of P_a.
template <class T, int n>
struct Balance {
  Eigen::Matrix<T, n, 1> load;
  Eigen::Matrix<T, n, n> tangent;
};

/// A joint pose moved by (dx, psi), each where it is unknown, rotations kept orthonormal.
template <Kind kind, class T>
Pose<T> displaced(const Pose<T>& joint, const Eigen::Matrix<T, unknown_count(kind), 1>& step) {
  Pose<T> out = joint;
  if constexpr (kind != Kind::angular) out.x += step.template head<3>();
  if constexpr (kind != Kind::linear)
    out.R = so3::matrix(so3::quaternion<T>(so3::exp<T>(step.template tail<3>()) * joint.R));
  return out;
}

/// By cofactors. A determinant that overflows would make the inverse zero, and any state an equilibrium.
template <class T>
Mat3<T> inverse_of(const Mat3<T>& J) {
  using std::isfinite;
  if (isfinite(T(J.determinant()))) return J.inverse();
  const T largest = J.cwiseAbs().maxCoeff();
  return Mat3<T>(J / largest).inverse() / largest;
}

template <class T>
Eigen::Matrix<T, 6, 6> inverse_of(const Eigen::Matrix<T, 6, 6>& J) {
  return J.inverse();
}

/// J^-1 r; not finite where J is singular. Three unknowns by cofactors, six by elimination: Newton
/// corrects what either loses, because the imbalance is computed afresh.
template <class T, int n>
Eigen::Matrix<T, n, 1> solved(const Eigen::Matrix<T, n, n>& J, const Eigen::Matrix<T, n, 1>& r) {
  if constexpr (n == 3)
    return inverse_of(J) * r;
  else
    return J.partialPivLu().solve(r);
}

/// |x| and |theta| of a joint pose, component by component.
template <Kind kind, class T>
Eigen::Matrix<T, unknown_count(kind), 1> motion_size(const Pose<T>& joint) {
  Eigen::Matrix<T, unknown_count(kind), 1> out;
  if constexpr (kind != Kind::angular) out.template head<3>() = joint.x.cwiseAbs();
  if constexpr (kind != Kind::linear) out.template tail<3>() = so3::log<T>(joint.R).cwiseAbs();
  return out;
}

/// What rounding leaves of applied - internal, direction by direction: that of the loads that are added up,
/// and of the motion, magnified by the tangent.
template <Kind kind, class T>
Eigen::Matrix<T, unknown_count(kind), 1> rounding_of(const Balance<T, unknown_count(kind)>& inside,
                                                     const Applied<T, unknown_count(kind)>& acting,
                                                     const Pose<T>& joint) {
  constexpr int kRoundings = 8;  // between a pose and its loads; see verify: what random scenes need
  return T(kRoundings) * Eigen::NumTraits<T>::epsilon() *
         (inside.load.cwiseAbs() + acting.size + inside.tangent.cwiseAbs() * motion_size<kind>(joint));
}

/// What it may leave at most: loads are turned on their way to the nodes by up to the joint's rotation, and
/// forces have an arm of up to x, so that what rounds in one direction is seen in the others.
template <Kind kind, class T>
Eigen::Matrix<T, unknown_count(kind), 1> spread_over(Eigen::Matrix<T, unknown_count(kind), 1> rounding,
                                                     const Pose<T>& joint) {
  if constexpr (kind != Kind::linear) {
    const auto motion = motion_size<kind>(joint);
    const T turn = std::min(T(1), T(motion.template tail<3>().norm()));
    const T moments = turn * rounding.template tail<3>().norm();
    if constexpr (kind == Kind::linear_angular) {
      const T forces = rounding.template head<3>().norm();
      rounding.template head<3>().array() += turn * forces;
      rounding.template tail<3>().array() += motion.template head<3>().norm() * forces;
    }
    rounding.template tail<3>().array() += moments;
  }
  return rounding;
}

/// What acts at one load factor: loads that grow with it, and those that are held.
/// @param growing  at load factor 1    @param held  nullptr: none
template <Kind kind, class T>
Applied<T, unknown_count(kind)> acting_on(const Applied<T, unknown_count(kind)>& growing, const T& factor,
                                          const JointLoad<T>* held, const Mat3<T>& R) {
  Applied<T, unknown_count(kind)> out = factor * growing;
  if (held) out += applied<kind>(*held, R);
  return out;
}

/// A loaded joint at one load factor: the system of Newton's method.
/// @tparam Internal  callable joint pose -> Balance<T, n>
template <Kind kind, class T, class Internal>
class LoadedJoint {
 public:
  static constexpr int n = unknown_count(kind);
  using Vector = Eigen::Matrix<T, n, 1>;
  using Matrix = Eigen::Matrix<T, n, n>;

  /// @param load, held  acting is factor load + held; held: nullptr for none. They must outlive the system.
  LoadedJoint(const Internal& internal, const JointLoad<T>& load, const T& factor, const Pose<T>& start,
              const JointLoad<T>* held = nullptr)
      : internal_(internal), load_(load), held_(held), factor_(factor), joint_(start) {}

  NewtonLook<T> look() {
    using std::sqrt, std::isfinite;
    const Balance<T, n> inside = internal_(joint_);
    const Applied<T, n> growing = applied<kind>(load_, joint_.R);
    const Applied<T, n> acting = acting_on<kind>(growing, factor_, held_, joint_.R);
    by_factor_ = growing.load;
    load_size_ = held_ ? acting.load.norm() : T(0);
    J_ = inside.tangent - acting.tangent;
    imbalance_ = acting.load - inside.load;
    rounding_ = rounding_of<kind>(inside, acting, joint_);
    step_ = solved(J_, imbalance_);
    // Loads that overflow have no rounding that an imbalance could be below.
    const T overflow = rounding_.sum();
    if (!isfinite(overflow)) return {overflow, false};
    // The root of the corrections' work: the one measure in which radians and metres, soft and stiff, add up.
    const Vector off = imbalance_.cwiseAbs(), most = spread_over<kind>(rounding_, joint_);
    return {sqrt(T(step_.cwiseProduct(imbalance_).cwiseAbs().sum())),
            (off.array() <= rounding_.array()).all(), (off.array() <= most.array()).all()};
  }
  void move() { joint_ = displaced<kind>(joint_, step_); }

  const Pose<T>& joint() const { return joint_; }
  /// d(dx, psi) / d(load factor) along the path.
  Vector slope() const { return solved(J_, by_factor_); }
  /// Of the tangent's determinant: 1, -1, or 0 where it is zero or no number. It changes where a path folds
  /// or branches.
  int sign() const {
    T determinant;
    if constexpr (n == 3)
      determinant = J_.determinant();
    else
      determinant = J_.partialPivLu().determinant();
    return int(determinant > T(0)) - int(determinant < T(0));
  }
  /// What the rounding of the loads, or what is left of the imbalance, can be off in each unknown: |J^-1| r.
  Vector error() const {
    const Vector off = imbalance_.cwiseAbs().cwiseMax(rounding_);
    return inverse_of(J_).cwiseAbs() * off;  // a scalar may have its own, found by its namespace
  }
  /// |internal - applied| / |applied|
  T residual() const {
    const T scale = held_ ? T(load_size_ * load_size_) : T(T(factor_ * factor_) * by_factor_.squaredNorm());
    using std::sqrt;
    return imbalance_.norm() / (scale > T(0) ? T(sqrt(scale)) : T(1));
  }
  /// m: what makes rotations comparable to displacements here.
  T length() const {
    if constexpr (n == 3) {
      return T(0);
    } else {
      using std::sqrt;
      const T ratio = J_.template bottomRightCorner<3, 3>().norm() / J_.template topLeftCorner<3, 3>().norm();
      return load_.reach + sqrt(ratio);
    }
  }

 private:
  const Internal& internal_;
  const JointLoad<T>& load_;
  const JointLoad<T>* held_;
  T factor_, load_size_{0};
  Pose<T> joint_;
  Vector by_factor_, imbalance_, rounding_, step_;
  Matrix J_;
};

}  // namespace halfway
