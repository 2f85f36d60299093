#include "reference/path.hpp"

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
Path<T>::Path(const Scene& scene, const Entry& entry, double xi, const Setting& setting)
    : entry_(entry), spec_(scene.joint), exchanged_(setting.nodes_exchanged) {
  spec_.xi = xi;
  clamped_.x = setting.frame_shift.cast<T>();
  clamped_.R = so3::exp<T>(setting.frame_turn.cast<T>());
  start_ = unstrained(cast_end<T>(spec_.a), cast_end<T>(spec_.b), clamped_);
  load_ = node_load<T>(scene, clamped_.R);
  if (exchanged_) std::swap(spec_.a, spec_.b);
  state_.b = start_;
}

template <class T>
template <Kind kind>
Balance<T, unknown_count(kind)> Path<T>::internal(const Pose<T>& moving) const {
  constexpr int n = unknown_count(kind);
  const Pose<T>& a = exchanged_ ? moving : clamped_;
  const Pose<T>& b = exchanged_ ? clamped_ : moving;
  Balance<T, n> out;
  if constexpr (kind == Kind::angular) {
    const AngularLoads<T> q = entry_.in<T>().angular(spec_, a, b, true);
    out.load = exchanged_ ? Vec3<T>(-q.m_b) : q.m_b;
    out.tangent = exchanged_ ? Mat3<T>(-q.m_b_wa) : q.m_b_wb;
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
Outcome<T> Path<T>::follow_to(const T& factor) const {
  const auto internal_load = [this](const Pose<T>& moving) { return internal<kind>(moving); };
  return follow<kind>(internal_load, load_, state_.b, state_.factor, factor);
}

template <class T>
const Outcome<T>& Path<T>::advance(double factor) {
  const int iterations = state_.iterations;
  switch (spec_.kind) {
    case Kind::angular:
      state_ = follow_to<Kind::angular>(T(factor));
      break;
    case Kind::linear:
      state_ = follow_to<Kind::linear>(T(factor));
      break;
    case Kind::linear_angular:
      state_ = follow_to<Kind::linear_angular>(T(factor));
      break;
  }
  state_.iterations += iterations;
  return state_;
}

template <class T>
T Path<T>::component(const std::string& name, const Vec3<T>& theta, const Vec3<T>& u) {
  const int axis = name.empty() ? -1 : name.back() - 'x';
  if (axis >= 0 && axis <= 2 && name.starts_with("theta_")) return theta[axis];
  if (axis >= 0 && axis <= 2 && name.starts_with("u_")) return u[axis];
  throw std::invalid_argument("unknown output " + name);
}

template <class T>
T Path<T>::output(const std::string& name) const {
  const Mat3<T> to_scene = clamped_.R.transpose();
  return component(name, to_scene * so3::log<T>(state_.b.R * start_.R.transpose()),
                   to_scene * (state_.b.x - start_.x));
}

template <class T>
template <Kind kind>
Eigen::Matrix<T, unknown_count(kind), 1> Path<T>::linear_response(const T& factor) const {
  const auto load = applied<kind>(load_, factor, start_).load;
  return solved(internal<kind>(start_).tangent, load);
}

template <class T>
T Path<T>::linear_output(const std::string& name, double factor) const {
  const Mat3<T> to_scene = clamped_.R.transpose();
  Vec3<T> theta = Vec3<T>::Zero(), u = Vec3<T>::Zero();
  switch (spec_.kind) {
    case Kind::angular:
      theta = linear_response<Kind::angular>(T(factor));
      break;
    case Kind::linear:
      u = linear_response<Kind::linear>(T(factor));
      break;
    case Kind::linear_angular: {
      const auto both = linear_response<Kind::linear_angular>(T(factor));
      u = both.template head<3>();
      theta = both.template tail<3>();
    }
  }
  return component(name, to_scene * theta, to_scene * u);
}

template class Path<double>;
template class Path<Real50>;

}  // namespace halfway::reference
