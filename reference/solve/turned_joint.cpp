#include "reference/solve/turned_joint.hpp"

#include <Eigen/LU>

#include <utility>

namespace halfway::reference {

template <class T>
TurnedJoint<T> turned_joint(const Entry& entry, const JointSpec& spec, const Mat3<T>& turn,
                            bool nodes_exchanged) {
  // The clamped node stands so that its joint frame is the global one: no rigid motion changes the answer.
  // Inverses, not transposes: frames are orthonormal in double only, and the turn is to be exact at 50
  // digits.
  Pose<T> clamped, moving;
  clamped.R = spec.a.H.template cast<T>().inverse();
  moving.R = turn * spec.b.H.template cast<T>().inverse();
  const auto angular = entry.in<T>().angular;
  if (!nodes_exchanged) {
    const AngularLoads<T> q = angular(spec, clamped, moving, true);
    return {q.m_b, q.m_b_wb, moving.R};
  }
  JointSpec exchanged = spec;
  std::swap(exchanged.a, exchanged.b);
  const AngularLoads<T> q = angular(exchanged, moving, clamped, true);
  return {-q.m_b, -q.m_b_wa, moving.R};
}

template TurnedJoint<double> turned_joint(const Entry&, const JointSpec&, const Mat3<double>&, bool);
template TurnedJoint<Real50> turned_joint(const Entry&, const JointSpec&, const Mat3<Real50>&, bool);

}  // namespace halfway::reference
