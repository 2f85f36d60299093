// A load of a scene as the library takes it.
#pragma once

#include "halfway/equilibrium.hpp"
#include "reference/scene/scene.hpp"

namespace halfway::reference::mechanism {

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

}  // namespace halfway::reference::mechanism
