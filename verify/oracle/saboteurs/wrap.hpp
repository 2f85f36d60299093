// An entry whose loads are a healthy one's, changed: the run-time face of a wrong twin.
#pragma once

#include "reference/face/registry.hpp"

namespace halfway::verify::sabotage {

using reference::Dual;
using reference::Entry;
using reference::Evaluators;
using reference::JointSpec;
using reference::Real50;

template <class T>
using Loads = typename Evaluators<T>::template LoadsAt<NodeLoads<T>>;

/// One call of the face, with the healthy loads of any pose.
template <class T>
struct Call {
  const JointSpec& spec;
  const Pose<T>& a;
  const Pose<T>& b;
  bool with_tangent;
  const Loads<T>& healthy;
  NodeLoads<T> loads() const { return healthy(spec, a, b, with_tangent); }
};

/// Loads of every kind in the coordinates of both nodes, a tangent that was not asked for zero.
template <class T>
Loads<T> loads_of(const Evaluators<T>& e) {
  return [e](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b, bool with_tangent) {
    NodeLoads<T> out = spec.kind == Kind::angular
                           ? reference::node_loads(e.angular(spec, a, b, with_tangent), with_tangent)
                           : e.point(spec, a, b, with_tangent);
    if (!with_tangent) out.tangent.setZero();
    return out;
  };
}

/// Sabotage::loads<T>(call) instead of the loads; of an angular joint what it says of node b.
template <class Sabotage, class T>
Evaluators<T> with_loads(Evaluators<T> e) {
  const Loads<T> healthy = loads_of(e);
  e.point = [healthy](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b, bool with_tangent) {
    return Sabotage::template loads<T>({spec, a, b, with_tangent, healthy});
  };
  e.angular = [point = e.point](const JointSpec& spec, const Pose<T>& a, const Pose<T>& b,
                                bool with_tangent) {
    const NodeLoads<T> of_nodes = point(spec, a, b, with_tangent);
    return AngularLoads<T>{of_nodes.q.template tail<3>(), of_nodes.tangent.template block<3, 3>(9, 3),
                           of_nodes.tangent.template block<3, 3>(9, 9)};
  };
  return e;
}

template <class Sabotage>
Entry wrapped(const Entry& healthy) {
  Entry out = healthy;
  out.in_double = with_loads<Sabotage>(healthy.in_double);
  out.in_real50 = with_loads<Sabotage>(healthy.in_real50);
  out.in_dual50 = with_loads<Sabotage>(healthy.in_dual50);
  return out;
}

}  // namespace halfway::verify::sabotage
