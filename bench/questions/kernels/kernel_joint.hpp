// The kernel joint of a spec as a static type.
#pragma once

#include "bench/questions/static_joint.hpp"
#include "reference/face/kernel_instance.hpp"

namespace halfway::bench {

/// @tparam E  kernel::Ends<T>, or kernel::NoEnds where the spec has none
template <class F, Kind kind, class T, class E>
auto static_kernel_joint(const reference::JointSpec& spec) {
  return reference::make_kernel_joint<F, kind, T, E>(make_formulation<F>(), spec);
}

}  // namespace halfway::bench
