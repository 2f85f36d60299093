// What equations.hpp declares; included by the units of its scalars alone.
#pragma once

#include "halfway/joint/measures.hpp"
#include "reference/mechanism/equations.hpp"
#include "reference/mechanism/invert.hpp"

namespace halfway::reference::mechanism {

/// Roundings between a pose and its loads: as rounding_of() in halfway/equilibrium.
inline constexpr int kRoundings = 8;

template <class T>
T rounding_unit() {
  return T(kRoundings) * Eigen::NumTraits<T>::epsilon();
}

/// A 6 x 6 block of two bodies into the matrix of all unknowns.
template <class T, class Block>
void add_block(Matrix<T>& to, const Body<T>& row, const Body<T>& column, const Block& block, const T& sign) {
  if (!row.moves || !column.moves) return;
  to.block(row.first, column.first, row.count(), column.count()) +=
      sign *
      block.block(first_direction(*row.moves), first_direction(*column.moves), row.count(), column.count());
}

template <class T>
Internal<T> internal(const Model<T>& model, const Poses<T>& at) {
  const int n = model.unknowns();
  Internal<T> out{Vector<T>::Zero(n), Vector<T>::Zero(n), Matrix<T>::Zero(n, n)};
  for (const JointModel<T>& joint : model.joints()) {
    const JointLoads<T> loads = model.loads(joint, at);
    const int bodies[] = {joint.a.body, joint.b.body};
    for (int i = 0; i < 2; ++i) {
      const Body<T>& row = model.bodies()[std::size_t(bodies[i])];
      model.add_to_body(out.load, row, Vec6<T>(loads.load.template segment<6>(6 * i)));
      model.add_to_body(out.rounding, row, Vec6<T>(loads.rounding.template segment<6>(6 * i)));
      for (int j = 0; j < 2; ++j)
        add_block<T>(out.tangent, row, model.bodies()[std::size_t(bodies[j])],
                     Mat6<T>(loads.tangent.template block<6, 6>(6 * i, 6 * j)), T(1));
    }
  }
  return out;
}

template <class T>
Internal<T> external(const Model<T>& model, const Poses<T>& at, const std::vector<T>& multipliers) {
  const int n = model.unknowns();
  Internal<T> out{Vector<T>::Zero(n), Vector<T>::Zero(n), Matrix<T>::Zero(n, n)};
  for (std::size_t i = 0; i < multipliers.size(); ++i) {
    if (multipliers[i] == T(0)) continue;
    const Body<T>& body = model.bodies()[std::size_t(model.body_of_load(i))];
    const Applied<T, 6> load = multipliers[i] * model.applied_load(i, at);
    model.add_to_body(out.load, body, load.load);
    model.add_to_body(out.rounding, body, Vec6<T>(rounding_unit<T>() * load.size));
    add_block<T>(out.tangent, body, body, load.tangent, T(1));
  }
  return out;
}

template <class T>
std::vector<T> at_factor(const std::vector<Line<T>>& lines, const T& factor) {
  std::vector<T> out;
  for (const Line<T>& line : lines) out.push_back(line.at(factor));
  return out;
}
template <class T>
std::vector<T> rates(const std::vector<Line<T>>& lines) {
  std::vector<T> out;
  for (const Line<T>& line : lines) out.push_back(line.rate);
  return out;
}

template <class T>
Equations<T>::Equations(const Model<T>& model, const Stage<T>& stage, const Vector<T>& resting,
                        const Holds<T>& holds, const T& factor, State<T> start)
    : model_(model),
      stage_(stage),
      resting_(resting),
      holds_(holds),
      factor_(factor),
      state_(std::move(start)) {}

template <class T>
NewtonLook<T> Equations<T>::look() {
  using std::isfinite, std::sqrt;
  const int n = model_.unknowns(), m = model_.prescribed();
  const Internal<T> inside = internal(model_, state_.at);
  const Internal<T> outside = external(model_, state_.at, at_factor(stage_.loads, factor_));
  const Internal<T> growing = external(model_, state_.at, rates(stage_.loads));
  const T holding = stage_.holding.at(factor_);
  K_ = inside.tangent - outside.tangent;
  imbalance_ = Vector<T>::Zero(n + m);
  rounding_ = Vector<T>::Zero(n + m);
  by_factor_ = Vector<T>::Zero(n + m);
  imbalance_.head(n) = outside.load + holding * resting_ - inside.load;
  rounding_.head(n) =
      outside.rounding + inside.rounding + rounding_unit<T>() * (holding * resting_).cwiseAbs();
  by_factor_.head(n) = growing.load + stage_.holding.rate * resting_;
  acting_ = outside.load.norm() + holding * resting_.norm();
  add_motions();
  add_holds();
  factorise();
  step_ = solved(imbalance_);
  const T overflow = rounding_.sum();
  if (!isfinite(overflow)) return {overflow, false};
  Vector<T> most = rounding_;
  for (std::size_t i = 0; i < model_.bodies().size(); ++i) {
    const Body<T>& body = model_.bodies()[i];
    if (!body.moves) continue;
    most.segment(body.first, body.count()) = by_kind(*body.moves, [&](auto kind) -> Vector<T> {
      const Eigen::Matrix<T, halfway::unknown_count(kind()), 1> own =
          rounding_.segment(body.first, body.count());
      return spread_over<kind(), T>(own, state_.at[i]);
    });
  }
  const Vector<T> off = imbalance_.cwiseAbs();
  return {sqrt(T(step_.cwiseProduct(imbalance_).cwiseAbs().sum())), (off.array() <= rounding_.array()).all(),
          (off.array() <= most.array()).all()};
}

template <class T>
void Equations<T>::move() {
  const int n = model_.unknowns();
  state_.at = model_.moved(state_.at, Vector<T>(step_.head(n)));
  state_.exerted += step_.tail(model_.prescribed());
}

/// One equation of a motion: how it grows with (dx, psi) of its body, what it exerts there and how that
/// turns.
template <class T>
struct Prescribed {
  Vec6<T> by_motion, exerts;
  Mat6<T> turns = Mat6<T>::Zero();  ///< d exerts / d(dx, psi)
  T missing{0}, rounding{0}, rate{0};
};

/// What a motion to zero leaves: beside bodies of some length, or turns of matrices whose entries are of size
/// one, nothing smaller is seen. Without it the equation of a motion to zero is never met.
template <class T>
T unseen(const T& size) {
  return rounding_unit<T>() * T(Eigen::NumTraits<T>::epsilon()) * size;
}

/// @param length  of the mechanism, m
template <class T>
Prescribed<T> displacement_along(const Vec3<T>& e, const Motions<T>& motion, const Pose<T>& at,
                                 const Line<T>& grows, const T& factor, const T& length) {
  Prescribed<T> out;
  const Vec3<T> r = at.R * motion.arm;
  out.by_motion << e, r.cross(e);
  out.exerts = out.by_motion;
  out.turns.template bottomRightCorner<3, 3>() = skew<T>(e) * skew<T>(r);
  const T wanted = e.dot(motion.value), u = e.dot(at.x + swung<T>(at.R, motion.arm));
  using std::abs;
  out.missing = grows.at(factor) * wanted - u;
  out.rate = grows.rate * wanted;
  out.rounding = rounding_unit<T>() * (T(abs(grows.at(factor) * wanted)) + e.cwiseAbs().dot(at.x.cwiseAbs()) +
                                       motion.arm.norm() * so3::log<T>(at.R).norm()) +
                 unseen<T>(motion.value.norm() + length);
  return out;
}

template <class T>
Prescribed<T> rotation_about(const Vec3<T>& e, const Motions<T>& motion, const Pose<T>& at,
                             const Line<T>& grows, const T& factor) {
  using std::abs;
  Prescribed<T> out;
  const Vec3<T> theta = so3::log<T>(at.R);
  out.by_motion << Vec3<T>::Zero(), so3::gamma_inverse(theta).transpose() * e;
  out.exerts = out.by_motion;
  out.turns.template bottomRightCorner<3, 3>() = spin_derivative<T>(theta, e, Mat3<T>::Zero());
  const T wanted = e.dot(motion.value);
  out.missing = grows.at(factor) * wanted - e.dot(theta);
  out.rate = grows.rate * wanted;
  out.rounding =
      rounding_unit<T>() * (T(abs(grows.at(factor) * wanted)) + e.cwiseAbs().dot(theta.cwiseAbs())) +
      unseen<T>(T(1));
  return out;
}

/// The whole orientation, beyond pi as well: what is missing is the turn that leads there, and the moment
/// that is exerted is an unknown in fixed axes.
template <class T>
Prescribed<T> orientation(int axis, const Motions<T>& motion, const Pose<T>& at, const Line<T>& grows,
                          const T& factor) {
  Prescribed<T> out;
  const Vec3<T> wanted = grows.at(factor) * motion.value;
  const Vec3<T> over = so3::log<T>(Mat3<T>(at.R * so3::exp<T>(wanted).transpose()));
  const Vec3<T> e = Vec3<T>::Unit(axis);
  out.exerts << Vec3<T>::Zero(), e;
  out.by_motion << Vec3<T>::Zero(), so3::gamma_inverse(over).transpose() * e;
  out.missing = -over[axis];
  out.rate = grows.rate * motion.value[axis];
  out.rounding = rounding_unit<T>() * wanted.norm() + unseen<T>(T(1));
  return out;
}

template <class T>
void Equations<T>::add_motions() {
  const int n = model_.unknowns(), m = model_.prescribed();
  G_ = Matrix<T>::Zero(m, n);
  F_ = Matrix<T>::Zero(n, m);
  for (std::size_t i = 0; i < model_.motions().size(); ++i) {
    const Motions<T>& motion = model_.motions()[i];
    const Body<T>& body = model_.bodies()[std::size_t(motion.scene.body)];
    const Pose<T>& at = state_.at[std::size_t(motion.scene.body)];
    for (int j = 0; j < motion.count(); ++j) {
      const Line<T>& grows = stage_.motions[i];
      const bool is_whole = motion.scene.axis < 0;
      const Vec3<T> e = body.E.transpose() * Vec3<T>::Unit(is_whole ? j : motion.scene.axis);
      const Prescribed<T> p = !motion.scene.is_rotation
                                  ? displacement_along<T>(e, motion, at, grows, factor_, length())
                              : is_whole ? orientation<T>(j, motion, at, grows, factor_)
                                         : rotation_about<T>(e, motion, at, grows, factor_);
      const int row = motion.first + j, first = first_direction(*body.moves);
      const T& exerted = state_.exerted[row];
      G_.row(row).segment(body.first, body.count()) = p.by_motion.segment(first, body.count()).transpose();
      F_.col(row).segment(body.first, body.count()) = p.exerts.segment(first, body.count());
      add_block<T>(K_, body, body, p.turns, T(-exerted));
      imbalance_[n + row] = p.missing;
      rounding_[n + row] = p.rounding;
      by_factor_[n + row] = p.rate;
    }
  }
  const Vector<T> exerted = F_.lazyProduct(state_.exerted);
  imbalance_.head(n) += exerted;
  rounding_.head(n) += rounding_unit<T>() * F_.cwiseAbs().lazyProduct(state_.exerted.cwiseAbs());
  acting_ += exerted.norm();
}

template <class T>
void Equations<T>::add_holds() {
  if (holds_.c.cols() == 0) return;
  const int n = model_.unknowns();
  Vector<T> z = Vector<T>::Zero(n);
  Matrix<T> rate = Matrix<T>::Identity(n, n);
  for (std::size_t i = 0; i < model_.bodies().size(); ++i) {
    const Body<T>& body = model_.bodies()[i];
    const Vec3<T> theta = so3::log<T>(state_.at[i].R);
    Vec6<T> moved;
    moved << state_.at[i].x, theta;
    model_.add_to_body(z, body, moved);
    Mat6<T> own = Mat6<T>::Zero();
    own.template bottomRightCorner<3, 3>() = so3::gamma_inverse(theta) - Mat3<T>::Identity();
    add_block<T>(rate, body, body, own, T(1));
  }
  const Vector<T> along = holds_.c.transpose().lazyProduct(z);
  const Vector<T> carried = holds_.c.lazyProduct(along);
  const Matrix<T> grows = holds_.c.transpose().lazyProduct(rate);
  const Vector<T> size = holds_.c.cwiseAbs().transpose().lazyProduct(z.cwiseAbs());
  imbalance_.head(n) -= carried;
  K_ += holds_.c.lazyProduct(grows);
  rounding_.head(n) += rounding_unit<T>() * holds_.c.cwiseAbs().lazyProduct(size);
  carried_ = carried.norm();
}

/// N/m and N m/rad, stiff and soft side by side: rows and columns are scaled to one size before elimination.
template <class T>
void Equations<T>::factorise() {
  using std::isfinite, std::sqrt;
  const int n = model_.unknowns(), m = model_.prescribed(), all = n + m;
  Matrix<T> scaled = Matrix<T>::Zero(all, all);
  scaled.topLeftCorner(n, n) = K_;
  scaled.topRightCorner(n, m) = -F_;
  scaled.bottomLeftCorner(m, n) = G_;
  Vector<T> rows = Vector<T>::Ones(all), columns = rows;
  for (int sweep = 0; sweep < 4; ++sweep) {
    for (int i = 0; i < all; ++i) {
      const T size = scaled.row(i).cwiseAbs().maxCoeff();
      if (size > T(0) && isfinite(size)) rows[i] /= T(sqrt(size)), scaled.row(i) /= T(sqrt(size));
    }
    for (int i = 0; i < all; ++i) {
      const T size = scaled.col(i).cwiseAbs().maxCoeff();
      if (size > T(0) && isfinite(size)) columns[i] /= T(sqrt(size)), scaled.col(i) /= T(sqrt(size));
    }
  }
  sign_ = invert(scaled);
  for (int i = 0; i < all; ++i) scaled.row(i) *= columns[i];
  for (int i = 0; i < all; ++i) scaled.col(i) *= rows[i];
  inverse_ = scaled;
}

template <class T>
Vector<T> Equations<T>::solved(const Vector<T>& r) const {
  return inverse_.lazyProduct(r);  // Newton corrects what this loses: the imbalance is computed afresh
}

template <class T>
Vector<T> Equations<T>::slope() const {
  return solved(by_factor_);
}

template <class T>
Vector<T> Equations<T>::error() const {
  const Vector<T> off = imbalance_.cwiseAbs().cwiseMax(rounding_);
  return inverse_.cwiseAbs().lazyProduct(off);
}

template <class T>
T Equations<T>::residual() const {
  // Beside what cancels: bodies under stress of each other alone are acted on by nothing.
  const T cancels = rounding_.head(model_.unknowns()).norm() / rounding_unit<T>();
  const T size = std::max(acting_, cancels);
  return imbalance_.head(model_.unknowns()).norm() / (size > T(0) ? size : T(1));
}

template <class T>
T Equations<T>::carried_by_holds() const {
  return acting_ > T(0) ? T(carried_ / acting_) : carried_;
}

template <class T>
T Equations<T>::length() const {
  using std::sqrt;
  T out(0);
  for (const Body<T>& body : model_.bodies()) {
    if (body.moves != Kind::linear_angular) continue;
    const Mat6<T> own = K_.block(body.first, body.first, 6, 6);
    const T forces = own.template topLeftCorner<3, 3>().norm();
    const T ratio = own.template bottomRightCorner<3, 3>().norm() / forces;
    if (forces > T(0) && T(sqrt(ratio)) > out) out = sqrt(ratio);
  }
  return out;
}

}  // namespace halfway::reference::mechanism
