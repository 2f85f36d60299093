#include "reference/solve/equilibrium_problem.hpp"

#include "reference/face/in_scalar.hpp"

#include <stdexcept>
#include <utility>

namespace halfway::reference {
namespace {

/// A load of the scene on the node; one of fixed direction is turned with the scene.
template <class T>
NodeLoad<T> node_load(const SceneLoad& load, const Mat3<T>& R) {
  NodeLoad<T> out;
  const Vec3<T> value = load.value.cast<T>();
  switch (load.type) {
    case LoadType::fixed_moment:
      out.moment = R * value;
      break;
    case LoadType::follower_moment:
      out.follower_moment = value;
      break;
    case LoadType::fixed_force:
      out.force = R * value;
      out.point = load.point.cast<T>();
      break;
    case LoadType::follower_force:
      out.follower_force = value;
      out.point = load.point.cast<T>();
      break;
    case LoadType::semi_tangential_moment:
      out.semi_tangential_moment = R * value;
      break;
    case LoadType::quasi_tangential_moment:
      out.quasi_tangential_moment = R * value;
      out.arm = load.arm.cast<T>();
      break;
  }
  return out;
}

}  // namespace

template <class T>
EquilibriumProblem<T>::EquilibriumProblem(const Scene& scene, const Entry& entry, double xi,
                                          const Setting& setting)
    : entry_(entry),
      spec_(scene.joint),
      a_(end_in<T>(scene.joint.a)),
      b_(end_in<T>(scene.joint.b)),
      exchanged_(setting.nodes_exchanged) {
  spec_.xi = xi;
  spec_.a = spec_.b = {};
  clamped_.x = setting.frame_shift.cast<T>();
  clamped_.R = so3::exp<T>(setting.frame_turn.cast<T>());
  const Mat3<T> frame = clamped_.R * a_.H;
  load_.on_a = held_.on_a = exchanged_;
  for (const SceneLoad& load : scene.loads) {
    (load.held ? held_ : load_) +=
        joint_load<T>(spec_.kind, node_load<T>(load, clamped_.R), frame, b_, exchanged_);
    has_held_ = has_held_ || load.held;
  }
  if (exchanged_) std::swap(a_, b_), spec_.axis = -spec_.axis;
}

template <class T>
Pose<T> EquilibriumProblem<T>::node(const Pose<T>& joint) const {
  Pose<T> out = exchanged_ ? node_a(a_, b_, clamped_, joint) : node_b(a_, b_, clamped_, joint);
  // Of an angular joint nothing but the rotation is known: its node stays where it is held.
  if (spec_.kind == Kind::angular)
    out.x = (exchanged_ ? node_a(a_, b_, clamped_, start()) : node_b(a_, b_, clamped_, start())).x;
  return out;
}

template <class T>
Pose<T> EquilibriumProblem<T>::joint(const Pose<T>& node) const {
  const Pose<T>& a = exchanged_ ? node : clamped_;
  const Pose<T>& b = exchanged_ ? clamped_ : node;
  const RelativeMotion<T> m = full_motion(a_, b_, a, b);
  return {spec_.kind == Kind::angular ? Vec3<T>(Vec3<T>::Zero()) : m.p, m.R};
}

template <class T>
template <int n>
Balance<T, n> EquilibriumProblem<T>::internal(const Pose<T>& joint) const {
  Balance<T, n> out;
  if (spec_.kind == Kind::angular) {
    const AngularLoads<T> q = entry_.in<T>().angular(spec_, {}, joint, true);
    out.load.template tail<3>() = q.m_b;
    out.tangent.template bottomRightCorner<3, 3>() = q.m_b_wb;
    return out;
  }
  // A loaded node a carries the opposite of what it would as b, and so its load as one on b has the sign
  // turned.
  const NodeLoads<T> q = entry_.in<T>().point(spec_, {}, joint, true);
  const int first = exchanged_ ? 0 : 6;
  const T sign(exchanged_ ? -1 : 1);
  out.load = sign * q.q.template segment<n>(first);
  out.tangent = sign * q.tangent.template block<n, n>(first, 6);
  return out;
}

template <class T>
template <Kind kind>
NodeBalance<T> EquilibriumProblem<T>::balance_kind(const Pose<T>& joint, const T& factor) const {
  const auto inside = internal<unknown_count(kind)>(joint);
  const auto growing = applied<kind>(load_, joint.R);
  const auto acting = acting_on<kind>(growing, factor, held(), joint.R);
  return {acting.load - inside.load, inside.tangent - acting.tangent, growing.load,
          rounding_of<kind>(inside, acting, joint)};
}

template <class T>
NodeBalance<T> EquilibriumProblem<T>::balance(const Pose<T>& joint, const T& factor) const {
  return by_kind(spec_.kind, [&](auto kind) { return balance_kind<kind()>(joint, factor); });
}

template <class T>
NodeMatrix<T> EquilibriumProblem<T>::node_tangent(const Pose<T>& joint, const T& factor) const {
  using Mat6 = Eigen::Matrix<T, 6, 6>;
  const JointEnd<T>& loaded = exchanged_ ? a_ : b_;
  const Pose<T> at = node(joint);
  const Mat3<T> P_a = exchanged_ ? Mat3<T>(at.R * a_.H) : Mat3<T>(clamped_.R * a_.H);
  // (dx, w) of the node -> those of its joint point, axes of P_a; loads are carried by the transpose.
  Mat6 to_point = Mat6::Zero();
  to_point.template topLeftCorner<3, 3>() = to_point.template bottomRightCorner<3, 3>() = P_a.transpose();
  to_point.template topRightCorner<3, 3>() = -P_a.transpose() * skew<T>(at.R * loaded.o);
  Mat6 to_joint = to_point;
  if (exchanged_) {  // x turns with node a
    to_joint = -to_point;
    to_joint.template topRightCorner<3, 3>() += P_a.transpose() * skew<T>(P_a * joint.x);
  }
  const int n = unknowns(), first = spec_.kind == Kind::angular ? 3 : 0;
  const NodeMatrix<T> rows = to_point.block(first, first, n, n).transpose() * balance(joint, factor).tangent;
  return T(exchanged_ ? -1 : 1) * rows * to_joint.block(first, first, n, n);
}

template <class T>
Outcome<T> EquilibriumProblem<T>::follow(const Outcome<T>& from, const T& factor_to, const JointLoad<T>& rate,
                                         const JointLoad<T>* base, const SolverOptions<T>& options) const {
  return by_kind(spec_.kind, [&](auto tag) {
    constexpr Kind kind = decltype(tag)::value;
    const auto inside = [this](const Pose<T>& joint) { return internal<unknown_count(kind)>(joint); };
    return PathFollower<kind, T, decltype(inside)>(inside, rate, options, from, base).to(factor_to);
  });
}

template <class T>
Outcome<T> EquilibriumProblem<T>::follow_to(const Outcome<T>& from, const T& factor_to,
                                            const SolverOptions<T>& options) const {
  return follow(from, factor_to, load_, held(), options);
}

template <class T>
JointLoad<T> EquilibriumProblem<T>::as_joint_load(const NodeVector<T>& load) const {
  JointLoad<T> out;
  out.on_a = exchanged_;
  const T sign(exchanged_ ? -1 : 1);  // one on node a is seen as on b
  if (spec_.kind != Kind::angular) out.force = sign * load.template head<3>();
  if (spec_.kind != Kind::linear) out.moment = sign * load.template tail<3>();
  return out;
}

template <class T>
Outcome<T> EquilibriumProblem<T>::initial(T* reached) const {
  if (reached) *reached = T(1);
  const NodeVector<T> stress = by_kind(
      spec_.kind, [&](auto kind) -> NodeVector<T> { return internal<unknown_count(kind())>(start()).load; });
  if (!has_held_ && stress.isZero(T(0))) return {};
  const JointLoad<T> holding = as_joint_load(stress);
  JointLoad<T> rate = held_;
  rate.add(holding, T(-1));
  Outcome<T> out = follow({}, T(1), rate, &holding);
  if (reached) *reached = out.factor;
  out.factor = T(0);
  out.sign = 0;  // on a path of its own, whose slope nobody knows
  return out;
}

template <class T>
Outcome<T> EquilibriumProblem<T>::equilibrium_near(const Pose<T>& joint, const T& factor) const {
  Outcome<T> from;
  from.factor = from.last.factor = from.before.factor = factor;
  from.joint = joint;
  return follow_to(from, factor);
}

template <class T>
Pose<T> EquilibriumProblem<T>::displaced(const Pose<T>& joint, const NodeVector<T>& step) const {
  return by_kind(spec_.kind, [&](auto kind) { return halfway::displaced<kind(), T>(joint, step); });
}

template <class T>
T EquilibriumProblem<T>::component(const std::string& name, const Vec3<T>& theta, const Vec3<T>& u) const {
  const int axis = name.empty() ? -1 : name.back() - 'x';
  const bool known = axis >= 0 && axis <= 2;
  const Mat3<T>& H = exchanged_ ? b_.H : a_.H;  // scene axes <- clamped joint frame
  if (known && name.starts_with("theta_")) return H.row(axis).dot(theta);
  if (known && name.starts_with("u_")) return H.row(axis).dot(u);
  throw std::invalid_argument("unknown output " + name);
}

template <class T>
Vec3<T> EquilibriumProblem<T>::node_displacement(const Pose<T>& joint) const {
  // The loaded frame seen from the clamped one; what its offset adds, without the difference of two
  // positions.
  const Vec3<T> x = exchanged_ ? Vec3<T>(-(joint.R.transpose() * joint.x)) : joint.x;
  const Vec3<T> theta = rotation(joint);
  const JointEnd<T>& loaded = exchanged_ ? a_ : b_;
  const Vec3<T> arm = loaded.H.transpose() * loaded.o;
  return x - so3::gamma(theta) * theta.cross(arm);  // Gamma [theta] = exp([theta]) - 1
}

template <class T>
Vec3<T> EquilibriumProblem<T>::rotation(const Pose<T>& joint) const {
  const Vec3<T> theta = so3::log<T>(joint.R);
  return exchanged_ ? Vec3<T>(-theta) : theta;
}

template <class T>
T EquilibriumProblem<T>::output(const std::string& name, const Pose<T>& joint) const {
  return component(name, rotation(joint), node_displacement(joint));
}

template <class T>
T EquilibriumProblem<T>::output_error(const std::string& name, const Outcome<T>& state) const {
  const T turn = state.error.template tail<3>().norm();
  if (name.starts_with("theta_")) return turn;
  const T arm = (exchanged_ ? a_ : b_).o.norm() + (exchanged_ ? state.joint.x.norm() : T(0));
  return state.error.template head<3>().norm() + arm * turn;
}

template <class T>
T EquilibriumProblem<T>::linear_output(const std::string& name, const T& factor) const {
  const NodeMatrix<T> stiffness = by_kind(spec_.kind, [&](auto kind) -> NodeMatrix<T> {
    return internal<unknown_count(kind())>(start()).tangent;
  });
  Vec3<T> theta = Vec3<T>::Zero(), u = Vec3<T>::Zero();
  const NodeVector<T> response = lu_solve<T>(stiffness, balance(start(), factor).imbalance);
  if (spec_.kind != Kind::linear) theta = response.template tail<3>();
  if (spec_.kind != Kind::angular) u = response.template head<3>();
  if (exchanged_) theta = -theta, u = -u;
  const JointEnd<T>& loaded = exchanged_ ? a_ : b_;
  return component(name, theta, u - theta.cross(Vec3<T>(loaded.H.transpose() * loaded.o)));
}

template class EquilibriumProblem<double>;
template class EquilibriumProblem<Real50>;

}  // namespace halfway::reference
