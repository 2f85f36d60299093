#include "reference/solve/equilibrium_problem.hpp"

#include <stdexcept>
#include <utility>

namespace halfway::reference {
namespace {

/// The scene's loads on the node, those of fixed direction turned with the scene.
template <class T>
NodeLoad<T> node_load(const Scene& scene, const Mat3<T>& R) {
  NodeLoad<T> load;
  for (const SceneLoad& l : scene.loads) {
    const Vec3<T> value = l.value.cast<T>();
    switch (l.type) {
      case LoadType::fixed_moment:
        load.moment += R * value;
        break;
      case LoadType::follower_moment:
        load.follower_moment += value;
        break;
      case LoadType::fixed_force:
        load.force += R * value;
        load.point = l.point.cast<T>();
        break;
    }
  }
  return load;
}

template <class T>
JointEnd<T> cast_end(const JointEnd<double>& e) {
  return {e.o.template cast<T>(), e.H.template cast<T>()};
}

}  // namespace

template <class T>
EquilibriumProblem<T>::EquilibriumProblem(const Scene& scene, const Entry& entry, double xi,
                                          const Setting& setting)
    : entry_(entry), spec_(scene.joint), exchanged_(setting.nodes_exchanged) {
  spec_.xi = xi;
  clamped_.x = setting.frame_shift.cast<T>();
  clamped_.R = so3::exp<T>(setting.frame_turn.cast<T>());
  start_ = unstrained(cast_end<T>(spec_.a), cast_end<T>(spec_.b), clamped_);
  load_ = node_load<T>(scene, clamped_.R);
  if (exchanged_) std::swap(spec_.a, spec_.b);
}

template <class T>
template <int n>
Balance<T, n> EquilibriumProblem<T>::internal(const Pose<T>& moving) const {
  const Pose<T>& a = exchanged_ ? moving : clamped_;
  const Pose<T>& b = exchanged_ ? clamped_ : moving;
  Balance<T, n> out;
  if (spec_.kind == Kind::angular) {
    const AngularLoads<T> q = entry_.in<T>().angular(spec_, a, b, true);
    out.load.template tail<3>() = exchanged_ ? Vec3<T>(-q.m_b) : q.m_b;
    out.tangent.template bottomRightCorner<3, 3>() = exchanged_ ? Mat3<T>(-q.m_b_wa) : q.m_b_wb;
  } else {
    const NodeLoads<T> q = entry_.in<T>().point(spec_, a, b, true);
    const int first = exchanged_ ? 0 : 6;
    out.load = q.q.template segment<n>(first);
    out.tangent = q.tangent.template block<n, n>(first, first);
  }
  return out;
}

template <class T>
template <Kind kind>
NodeBalance<T> EquilibriumProblem<T>::balance_kind(const Pose<T>& b, const T& factor) const {
  const auto inside = internal<unknown_count(kind)>(b);
  const auto outside = applied<kind>(load_, factor, b);
  return {outside.load - inside.load, inside.tangent - outside.tangent, applied<kind>(load_, T(1), b).load};
}

template <class T>
NodeBalance<T> EquilibriumProblem<T>::balance(const Pose<T>& b, const T& factor) const {
  switch (spec_.kind) {
    case Kind::angular:
      return balance_kind<Kind::angular>(b, factor);
    case Kind::linear:
      return balance_kind<Kind::linear>(b, factor);
    default:
      return balance_kind<Kind::linear_angular>(b, factor);
  }
}

template <class T>
template <Kind kind>
Outcome<T> EquilibriumProblem<T>::follow_kind(const Pose<T>& from, const T& factor_from,
                                              const T& factor_to) const {
  const auto load = [this](const Pose<T>& b) { return internal<unknown_count(kind)>(b); };
  return follow<kind>(load, load_, from, factor_from, factor_to);
}

template <class T>
Outcome<T> EquilibriumProblem<T>::follow_to(const Pose<T>& from, const T& factor_from,
                                            const T& factor_to) const {
  switch (spec_.kind) {
    case Kind::angular:
      return follow_kind<Kind::angular>(from, factor_from, factor_to);
    case Kind::linear:
      return follow_kind<Kind::linear>(from, factor_from, factor_to);
    default:
      return follow_kind<Kind::linear_angular>(from, factor_from, factor_to);
  }
}

template <class T>
Pose<T> EquilibriumProblem<T>::displaced(const Pose<T>& b, const NodeVector<T>& step) const {
  Pose<T> out = b;
  if (spec_.kind != Kind::angular) out.x += step.template head<3>();
  if (spec_.kind != Kind::linear) out.R = so3::exp<T>(step.template tail<3>()) * b.R;
  return out;
}

template <class T>
T EquilibriumProblem<T>::component(const std::string& name, const Vec3<T>& theta, const Vec3<T>& u) const {
  const int axis = name.empty() ? -1 : name.back() - 'x';
  const bool known = axis >= 0 && axis <= 2;
  if (known && name.starts_with("theta_")) return clamped_.R.col(axis).dot(theta);
  if (known && name.starts_with("u_")) return clamped_.R.col(axis).dot(u);
  throw std::invalid_argument("unknown output " + name);
}

template <class T>
T EquilibriumProblem<T>::output(const std::string& name, const Pose<T>& b) const {
  return component(name, so3::log<T>(b.R * start_.R.transpose()), b.x - start_.x);
}

template <class T>
T EquilibriumProblem<T>::linear_output(const std::string& name, const T& factor) const {
  const NodeBalance<T> at_rest = balance(start_, T(0));
  Vec3<T> theta = Vec3<T>::Zero(), u = Vec3<T>::Zero();
  const NodeVector<T> response = at_rest.tangent.partialPivLu().solve(factor * at_rest.by_factor);
  if (spec_.kind != Kind::linear) theta = response.template tail<3>();
  if (spec_.kind != Kind::angular) u = response.template head<3>();
  return component(name, theta, u);
}

template class EquilibriumProblem<double>;
template class EquilibriumProblem<Real50>;

}  // namespace halfway::reference
