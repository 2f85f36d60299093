// Everything of a mechanism in one scalar, compiled once.
#pragma once

#include "reference/mechanism/model_parts.hpp"

#include "reference/mechanism/equations_parts.hpp"

#include "reference/mechanism/follow_parts.hpp"

#include "reference/mechanism/outputs_parts.hpp"

// clang-format off
#define HALFWAY_MECHANISM(T)                                                                                   \
  template class Model<T>;                                                                                     \
  template Internal<T> internal(const Model<T>&, const Poses<T>&);                                             \
  template Internal<T> external(const Model<T>&, const Poses<T>&, const std::vector<T>&);                      \
  template class Equations<T>;                                                                                 \
  template class Follower<T>;                                                                                  \
  template T output(const Follower<T>&, const std::string&);                                                   \
  template T motion_error(const Follower<T>&);                                                                 \
  template Vec6<T> reaction(const Model<T>&, const Poses<T>&, std::size_t, bool);                              \
  template T joint_energy(const Model<T>&, const Poses<T>&, std::size_t);                                      \
  template Pose<T> node_of(const Model<T>&, const Poses<T>&, std::size_t);
// clang-format on
