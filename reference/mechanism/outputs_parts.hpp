// What outputs.hpp declares of any scalar; included by the units of its scalars alone.
#pragma once

#include "reference/mechanism/outputs.hpp"
#include "reference/record/worst.hpp"

#include <algorithm>
#include <stdexcept>

namespace halfway::reference::mechanism {

template <class T>
Pose<T> node_of(const Model<T>& model, const Poses<T>& at, std::size_t i) {
  const Body<T>& body = model.bodies()[i];
  const Pose<T>& moved = at[i];
  const Vec3<T> from_point = body.arm(Vec3<T>::Zero());
  return {body.rest.x + body.E * (moved.x + swung<T>(moved.R, from_point)),
          body.E * moved.R * body.E.transpose() * body.rest.R};
}

template <class T>
Vec6<T> reaction(const Model<T>& model, const Poses<T>& at, std::size_t joint, bool at_a) {
  const JointModel<T>& j = model.joints()[joint];
  const std::size_t i = std::size_t(at_a ? j.a.body : j.b.body);
  const Body<T>& body = model.bodies()[i];
  const Vec6<T> own = model.loads(j, at).load.template segment<6>(at_a ? 0 : 6);
  const Vec3<T> f = body.E * own.template head<3>(), m = body.E * own.template tail<3>();
  const Vec3<T> r = body.E * (at[i].R * Vec3<T>(-body.arm(Vec3<T>::Zero())));  // node -> reference point
  Vec6<T> out;
  out << -f, -(m + r.cross(f));
  return out;
}

/// What a motion exerts on its body, likewise.
template <class T>
Vec6<T> exerted(const Follower<T>& path, const Motions<T>& motion) {
  const Model<T>& model = path.model();
  const std::size_t i = std::size_t(motion.scene.body);
  const Body<T>& body = model.bodies()[i];
  const Pose<T>& at = path.reached().state.at[i];
  Vec6<T> own = Vec6<T>::Zero();  // about the reference point, body's axes
  const bool is_whole = motion.scene.axis < 0;
  for (int j = 0; j < motion.count(); ++j) {
    const T& size = path.reached().state.exerted[motion.first + j];
    const Vec3<T> e = body.E.transpose() * Vec3<T>::Unit(is_whole ? j : motion.scene.axis);
    if (!motion.scene.is_rotation) {
      const Vec3<T> r = at.R * motion.arm;
      own.template head<3>() += size * e;
      own.template tail<3>() += size * r.cross(e);
    } else if (is_whole) {
      own.template tail<3>() += size * Vec3<T>::Unit(j);
    } else {
      own.template tail<3>() += size * (so3::gamma_inverse(so3::log<T>(at.R)).transpose() * e);
    }
  }
  const Vec3<T> f = body.E * own.template head<3>(), m = body.E * own.template tail<3>();
  const Vec3<T> r = body.E * (at.R * Vec3<T>(-body.arm(Vec3<T>::Zero())));
  Vec6<T> out;
  out << f, m + r.cross(f);
  return out;
}

template <class T>
T joint_energy(const Model<T>& model, const Poses<T>& at, std::size_t joint) {
  const JointModel<T>& j = model.joints()[joint];
  const auto& evaluate = model.entry().template in<T>();
  const Pose<T> b = model.seen(j, at).pose;
  if (const auto potential = evaluate.energy(j.spec, {}, b)) return *potential;
  const auto strain = evaluate.strain(j.spec, {}, b);
  if (j.spec.kind == Kind::linear_angular)
    return AnyLaw<T, 6>(j.spec.law).energy(Eigen::Matrix<T, 6, 1>(strain));
  return AnyLaw<T, 3>(j.spec.law).energy(Vec3<T>(strain));
}

/// 0 ... 5 of f_x ... m_z, or of theta_x ... u_z.
inline int component_of(std::string_view name) {
  const bool second = name.starts_with("m_") || name.starts_with("u_");
  return (second ? 3 : 0) + (name.back() - 'x');
}

template <class T>
T body_output(const Follower<T>& path, std::size_t i, std::string_view name) {
  const Model<T>& model = path.model();
  const Body<T>& body = model.bodies()[i];
  const Pose<T>& at = path.reached().state.at[i];
  const int axis = component_of(name) % 3;
  if (name.starts_with("theta_")) return Vec3<T>(body.E * so3::log<T>(at.R))[axis];
  return Vec3<T>(body.E * (at.x + swung<T>(at.R, body.arm(Vec3<T>::Zero()))))[axis];
}

template <class T>
T joint_output(const Follower<T>& path, std::size_t i, std::string_view name) {
  const Model<T>& model = path.model();
  const Poses<T>& at = path.reached().state.at;
  if (name == "energy") return joint_energy(model, at, i);
  if (name.starts_with("strain_")) {
    const JointModel<T>& joint = model.joints()[i];
    return model.entry().template in<T>().strain(joint.spec, {},
                                                 model.seen(joint, at).pose)[name.back() - '1'];
  }
  return reaction(model, at, i, name.front() == 'a')[component_of(name.substr(2))];
}

template <class T>
T output(const Follower<T>& path, const std::string& name) {
  const MechanismScene& scene = path.model().scene();
  if (name == "energy") {
    T sum(0);
    for (std::size_t i = 0; i < scene.joints.size(); ++i) sum += joint_output(path, i, "energy");
    return sum;
  }
  const auto dot = name.find('.');
  const std::string owner = dot == std::string::npos ? "b" : name.substr(0, dot);
  const std::string what = dot == std::string::npos ? name : name.substr(dot + 1);
  const auto at = [&](const auto& all) -> std::size_t {
    return std::size_t(std::ranges::find_if(all, [&](const auto& x) { return x.name == owner; }) -
                       all.begin());
  };
  if (const std::size_t i = at(scene.bodies); i < scene.bodies.size()) return body_output(path, i, what);
  if (const std::size_t i = at(scene.joints); i < scene.joints.size()) return joint_output(path, i, what);
  if (const std::size_t i = at(scene.motions); i < scene.motions.size())
    return exerted(path, path.model().motions()[i])[component_of(what)];
  throw std::invalid_argument("unknown output " + name);
}

template <class T>
T motion_error(const Follower<T>& path) {
  T out(0);
  const Model<T>& model = path.model();
  for (const Body<T>& body : model.bodies()) {
    const Vec6<T> own = model.of_body(path.reached().error, body);
    const T turn = own.template tail<3>().norm();
    keep_largest(out, turn);
    keep_largest(out, T(own.template head<3>().norm() + body.point.norm() * turn));
  }
  return out;
}

}  // namespace halfway::reference::mechanism
