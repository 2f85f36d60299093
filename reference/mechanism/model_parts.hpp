// What model.hpp declares; included by the units of its scalars alone.
#pragma once

#include "reference/mechanism/model.hpp"
#include "reference/mechanism/node_load.hpp"

namespace halfway::reference::mechanism {

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
    const JointEnd<T> a = end_in<T>(from.spec.a), b = end_in<T>(from.spec.b);
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

/// The twelve rows or columns of a joint in blocks of three: 50 digits have such products compiled.
template <class T>
Mat3<T> block(const Eigen::Matrix<T, 12, 12>& m, int i, int j) {
  return m.template block<3, 3>(3 * i, 3 * j);
}
template <class T>
Vec3<T> block(const Eigen::Matrix<T, 12, 1>& v, int i) {
  return v.template segment<3>(3 * i);
}

/// From the joint's points, axes A, to the bodies' reference points and axes: d(x_point) = U dx - [r] U psi,
/// and loads by the transpose.
template <class T>
void carry_tangent(const Eigen::Matrix<T, 12, 12>& K, const Node<T>* const nodes[2],
                   const Vec3<T>* const arms[2], JointLoads<T>& out) {
  for (int i = 0; i < 2; ++i) {
    const Mat3<T> U_i = nodes[i]->U.transpose(), r_i = skew<T>(*arms[i]);
    for (int j = 0; j < 2; ++j) {
      const Mat3<T>&U_j = nodes[j]->U, r_j = skew<T>(*arms[j]);
      const Mat3<T> f_x = block<T>(K, 2 * i, 2 * j), m_x = block<T>(K, 2 * i + 1, 2 * j);
      const Mat3<T> f_w = block<T>(K, 2 * i, 2 * j + 1) - f_x * r_j;
      const Mat3<T> m_w = block<T>(K, 2 * i + 1, 2 * j + 1) - m_x * r_j + r_i * f_w;
      const auto set = [&](int row, int column, const Mat3<T>& part) {
        out.tangent.template block<3, 3>(6 * i + 3 * row, 6 * j + 3 * column) = U_i * (part * U_j);
      };
      set(0, 0, f_x), set(0, 1, f_w), set(1, 0, Mat3<T>(m_x + r_i * f_x)), set(1, 1, m_w);
    }
  }
}

template <class T>
JointLoads<T> Model<T>::loads(const JointModel<T>& joint, const Poses<T>& at) const {
  using Vec12 = Eigen::Matrix<T, 12, 1>;
  const Seen<T> now = seen(joint, at);
  const Mat3<T> back = now.S_a.transpose();
  NodeLoads<T> own = node_loads<T>(entry_, joint.spec, {}, now.pose, true);  // axes of P_a, then of A
  for (int i = 0; i < 4; ++i) {
    own.q.template segment<3>(3 * i) = now.S_a * block<T>(own.q, i);
    for (int j = 0; j < 4; ++j)
      own.tangent.template block<3, 3>(3 * i, 3 * j) = now.S_a * (block<T>(own.tangent, i, j) * back);
  }
  const Node<T>* const nodes[] = {&joint.a, &joint.b};
  const Vec3<T>* const arms[] = {&now.r_a, &now.r_b};
  Vec12 size, rounding;  // what the nodes have moved, and what rounds of the loads
  for (int i = 0; i < 2; ++i) {
    const Pose<T>& body = at[std::size_t(nodes[i]->body)];
    const Vec3<T> theta = nodes[i]->U * so3::log<T>(body.R);
    const T swing = theta.norm() * nodes[i]->arm.norm();
    size.template segment<3>(6 * i) = Vec3<T>(nodes[i]->U * body.x).cwiseAbs() + Vec3<T>::Constant(swing);
    size.template segment<3>(6 * i + 3) = theta.cwiseAbs();
  }
  size.template segment<3>(6) += joint.gap.cwiseAbs();
  if (!joint.misfit.isIdentity(T(0))) size.template tail<3>() += Vec3<T>::Ones();
  constexpr int kRoundings = 8;  // as rounding_of() in halfway/equilibrium
  for (int i = 0; i < 4; ++i) {
    Vec3<T> sum = block<T>(own.q, i).cwiseAbs();
    for (int j = 0; j < 4; ++j) sum += Mat3<T>(block<T>(own.tangent, i, j).cwiseAbs()) * block<T>(size, j);
    rounding.template segment<3>(3 * i) = T(kRoundings) * Eigen::NumTraits<T>::epsilon() * sum;
  }
  JointLoads<T> out;
  carry_tangent(own.tangent, nodes, arms, out);
  for (int i = 0; i < 2; ++i) {
    const Mat3<T> back_i = nodes[i]->U.transpose(), size_i = back_i.cwiseAbs(), r = skew<T>(*arms[i]);
    const Vec3<T> f = block<T>(own.q, 2 * i), m = block<T>(own.q, 2 * i + 1);
    const Vec3<T> df = block<T>(rounding, 2 * i), dm = block<T>(rounding, 2 * i + 1);
    out.load.template segment<3>(6 * i) = back_i * f;
    out.load.template segment<3>(6 * i + 3) = back_i * Vec3<T>(m + r * f);
    out.rounding.template segment<3>(6 * i) = size_i * df;
    out.rounding.template segment<3>(6 * i + 3) = size_i * Vec3<T>(dm + Mat3<T>(r.cwiseAbs()) * df);
    // The arms turn with their bodies: d(r) x f = [f][r] w.
    const Mat3<T> turns = back_i * (skew<T>(f) * r * nodes[i]->U);
    out.tangent.template block<3, 3>(6 * i + 3, 6 * i + 3) += turns;
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
