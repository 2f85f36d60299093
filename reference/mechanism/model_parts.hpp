// What model.hpp declares; included by the units of its scalars alone.
#pragma once

#include "reference/mechanism/model.hpp"

namespace halfway::reference::mechanism {

/// A load of the scene on a body.
template <class T>
NodeLoad<T> on_node(const SceneLoad& load) {
  NodeLoad<T> out;
  const Vec3<T> value = load.value.cast<T>();
  out.point = load.point.cast<T>();
  out.arm = load.arm.cast<T>();
  Vec3<T>* const places[] = {&out.moment,         &out.follower_moment,        &out.force,
                             &out.follower_force, &out.semi_tangential_moment, &out.quasi_tangential_moment};
  *places[int(load.type)] = value;
  return out;
}

/// A small vector is a rounding of what was subtracted.
template <class T>
bool is_rounding(const T& difference, const T& size) {
  return difference <= T(64) * Eigen::NumTraits<T>::epsilon() * size;
}

template <class T>
Model<T>::Model(const MechanismScene& scene, const Entry& entry, double xi) : scene_(scene), entry_(entry) {
  const auto poses = initial_poses<T>(scene);
  std::vector<bool> has_axes(scene.bodies.size(), false);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    bodies_.push_back({scene.bodies[i].moves, unknowns_, *poses[i]});
    unknowns_ += bodies_.back().count();
  }
  for (const SceneJoint& from : scene.joints) {
    JointModel<T> joint;
    joint.spec = from.spec;
    joint.spec.xi = xi;
    joint.spec.a = joint.spec.b = {};
    const JointEnd<T> a = end_of<T>(from.spec.a), b = end_of<T>(from.spec.b);
    joint.A = poses[std::size_t(from.a)]->R * a.H;
    for (const bool is_a : {true, false}) {
      Node<T>& node = is_a ? joint.a : joint.b;
      node.body = is_a ? from.a : from.b;
      Body<T>& body = bodies_[std::size_t(node.body)];
      const Vec3<T>& o = is_a ? a.o : b.o;
      if (!has_axes[std::size_t(node.body)]) {
        has_axes[std::size_t(node.body)] = node.is_own = true;
        body.E = joint.A;
        if (body.moves != Kind::angular) body.point = o;  // one that only turns does so about its origin
      }
      if (!node.is_own) node.U = joint.A.transpose() * body.E;
      node.arm = joint.A.transpose() * (body.rest.R * (o - body.point));
    }
    const Pose<T>&rest_a = *poses[std::size_t(from.a)], &rest_b = *poses[std::size_t(from.b)];
    const Vec3<T> d = (rest_b.x + rest_b.R * b.o) - (rest_a.x + rest_a.R * a.o);
    const T size = rest_a.x.norm() + rest_b.x.norm() + a.o.norm() + b.o.norm();
    if (joint.spec.kind != Kind::angular && !is_rounding<T>(d.norm(), size))
      joint.gap = joint.A.transpose() * d;
    const Mat3<T> misfit = joint.A.transpose() * (rest_b.R * b.H);
    if (!is_rounding<T>((misfit - Mat3<T>::Identity()).norm(), T(1))) joint.misfit = misfit;
    joints_.push_back(joint);
  }
  for (const BodyLoad& load : scene.loads) {
    const Body<T>& body = bodies_[std::size_t(load.body)];
    const JointEnd<T> end{body.point, body.rest.R.transpose() * body.E};
    loads_.push_back(joint_load<T>(body.moves.value_or(Kind::linear_angular), on_node<T>(load), body.E, end));
  }
  for (const SceneMotion& motion : scene.motions) {
    const Body<T>& body = bodies_[std::size_t(motion.body)];
    motions_.push_back({motion, body.E.transpose() * motion.value.cast<T>(),
                        body.arm(Vec3<T>(motion.point.cast<T>())), prescribed_});
    prescribed_ += motions_.back().count();
  }
}

/// A rotation given in a body's axes, in those of the joint; small ones to their own digits.
template <class T>
Mat3<T> turned_in(const Node<T>& node, const Mat3<T>& R) {
  return node.is_own ? R : so3::exp<T>(node.U * so3::log<T>(R));
}

/// (R - 1) arm, to the digits of a small rotation.
template <class T>
Vec3<T> swung(const Mat3<T>& R, const Vec3<T>& arm) {
  const Vec3<T> theta = so3::log<T>(R);
  return so3::gamma(theta) * theta.cross(arm);
}

template <class T>
Seen<T> Model<T>::seen(const JointModel<T>& joint, const Poses<T>& at) const {
  const Pose<T>&a = at[std::size_t(joint.a.body)], &b = at[std::size_t(joint.b.body)];
  Seen<T> out;
  out.S_a = turned_in(joint.a, a.R);
  out.S_b = turned_in(joint.b, b.R);
  out.r_a = out.S_a * joint.a.arm;
  out.r_b = out.S_b * joint.b.arm;
  out.pose.R = out.S_a.transpose() * (out.S_b * joint.misfit);
  if (joint.spec.kind == Kind::angular) return out;
  const Vec3<T> d = joint.gap + (joint.b.U * b.x + swung<T>(out.S_b, joint.b.arm)) -
                    (joint.a.U * a.x + swung<T>(out.S_a, joint.a.arm));
  out.pose.x = out.S_a.transpose() * d;
  return out;
}

/// (dx, psi) of a body -> those of a joint point on it, axes A; loads go back by the transpose.
template <class T>
Mat6<T> to_point(const Node<T>& node, const Vec3<T>& r) {
  Mat6<T> out = Mat6<T>::Zero();
  out.template topLeftCorner<3, 3>() = out.template bottomRightCorner<3, 3>() = node.U;
  out.template topRightCorner<3, 3>() = -skew<T>(r) * node.U;
  return out;
}

template <class T>
JointLoads<T> Model<T>::loads(const JointModel<T>& joint, const Poses<T>& at) const {
  using Vec12 = Eigen::Matrix<T, 12, 1>;
  using Mat12 = Eigen::Matrix<T, 12, 12>;
  const Seen<T> seen_now = seen(joint, at);
  const NodeLoads<T> own = node_loads<T>(entry_, joint.spec, {}, seen_now.pose, true);
  Vec12 q, size;
  Mat12 K;
  for (int i = 0; i < 4; ++i) {
    q.template segment<3>(3 * i) = seen_now.S_a * own.q.template segment<3>(3 * i);
    for (int j = 0; j < 4; ++j)
      K.template block<3, 3>(3 * i, 3 * j) =
          seen_now.S_a * Mat3<T>(own.tangent.template block<3, 3>(3 * i, 3 * j)) * seen_now.S_a.transpose();
  }
  const Node<T>* const nodes[] = {&joint.a, &joint.b};
  const Vec3<T>* const arms[] = {&seen_now.r_a, &seen_now.r_b};
  JointLoads<T> out;
  Mat12 points = Mat12::Zero();
  for (int i = 0; i < 2; ++i) {
    const Pose<T>& body = at[std::size_t(nodes[i]->body)];
    const T turn = so3::log<T>(body.R).norm();
    const Vec3<T> shift = (nodes[i]->U * body.x).cwiseAbs();
    size.template segment<3>(6 * i) = shift.array() + turn * nodes[i]->arm.norm();
    size.template segment<3>(6 * i + 3) = Vec3<T>(nodes[i]->U * so3::log<T>(body.R)).cwiseAbs();
    points.template block<6, 6>(6 * i, 6 * i) = to_point(*nodes[i], *arms[i]);
  }
  size.template segment<3>(6) += joint.gap.cwiseAbs();
  if (!joint.misfit.isIdentity(T(0))) size.template tail<3>().array() += T(1);
  // What rounds in the node's own axes is seen in others', by its size; a small angle rounds small.
  constexpr int kRoundings = 8;
  const Vec12 rounding =
      T(kRoundings) * Eigen::NumTraits<T>::epsilon() * (q.cwiseAbs() + K.cwiseAbs() * size);
  out.load = points.transpose() * q;
  out.rounding = points.cwiseAbs().transpose() * rounding;
  out.tangent = points.transpose() * K * points;
  for (int i = 0; i < 2; ++i) {  // the arms turn with their bodies: d(r) x f = [f][r] w
    const Vec3<T> f = q.template segment<3>(6 * i);
    out.tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) +=
        nodes[i]->U.transpose() * skew<T>(f) * skew<T>(*arms[i]) * nodes[i]->U;
  }
  return out;
}

template <class T>
Applied<T, 6> Model<T>::applied_load(std::size_t i, const Poses<T>& at) const {
  return applied<Kind::linear_angular>(loads_[i], at[std::size_t(scene_.loads[i].body)].R);
}

template <class T>
Vec6<T> Model<T>::of_body(const Vector<T>& all, const Body<T>& body) const {
  Vec6<T> out = Vec6<T>::Zero();
  if (body.moves)
    out.segment(first_direction(*body.moves), body.count()) = all.segment(body.first, body.count());
  return out;
}

template <class T>
void Model<T>::add_to_body(Vector<T>& all, const Body<T>& body, const Vec6<T>& part) const {
  if (body.moves)
    all.segment(body.first, body.count()) += part.segment(first_direction(*body.moves), body.count());
}

template <class T>
Poses<T> Model<T>::moved(const Poses<T>& at, const Vector<T>& step) const {
  Poses<T> out = at;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].moves) continue;
    const Vec6<T> part = of_body(step, bodies_[i]);
    out[i] = by_kind(*bodies_[i].moves, [&](auto kind) {
      return displaced<kind(), T>(at[i], narrowed<kind(), T>(Motion<T>(part)));
    });
  }
  return out;
}

}  // namespace halfway::reference::mechanism
