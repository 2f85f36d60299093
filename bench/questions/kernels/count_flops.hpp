// Flops of a formulation's joints, counted by running them. Only halfway_flops is made of it: the counting
// scalar doubles the compile time of what it meets.
#pragma once

#include "bench/harness/flops.hpp"
#include "bench/questions/kernels/kernel_joint.hpp"
#include "halfway/kernels/compensated.hpp"
#include "reference/face/registry.hpp"
#include "reference/numbers/counting.hpp"

#include <type_traits>

namespace halfway::bench {

/// Of one evaluation of the transcription, the mean over every eighth pose: branches differ.
template <class F, Kind kind, bool with_tangent>
double transcription_flops(const Inputs& in) {
  using reference::Counting;
  const auto joint = make_joint<F, kind, Counting>(in.spec);
  constexpr int kStep = 8;
  const auto count = reference::counted([&] {
    for (int i = 0; i < kPoses; i += kStep) {
      (void)loads<with_tangent>(joint, reference::cast<Counting>(in.a[i]),
                                reference::cast<Counting>(in.b[i]));
    }
  });
  return double(count.flops()) * kStep / kPoses;
}

/// Of one evaluation of the kernel: it has no branches, one pose tells all.
template <class F, Kind kind, bool with_tangent, class Accuracy, class E>
reference::OperationCount kernel_operations(const Inputs& in) {
  using reference::Counting;
  const auto joint = static_kernel_joint<F, kind, Counting, E>(in.spec);
  const auto cast = [](const reference::QuaternionPose<double>& p) {
    return reference::plain(reference::QuaternionPose<Counting>{p.x.cast<Counting>(), p.q.cast<Counting>()});
  };
  const auto a = cast(in.qa.front()), b = cast(in.qb.front());
  return reference::counted([&] {
    if constexpr (kind == Kind::angular)
      (void)kernel::loads<with_tangent, Accuracy>(joint, a.q, b.q);
    else
      (void)kernel::loads<with_tangent, Accuracy>(joint, a, b);
  });
}

/// The kernel with another accuracy, by the name of its benchmark.
template <class F, Kind kind, bool with_tangent, class Accuracy, class E>
void count_kernel(Flops& flops, const Inputs& in, const std::string& variant) {
  const std::string name = std::string(F::name) + '/' + to_string(kind) +
                           (with_tangent ? "/residual_tangent" : "/residual") + "/kernel" + variant;
  const reference::OperationCount count = kernel_operations<F, kind, with_tangent, Accuracy, E>(in);
  flops[name] = double(count.flops());
  if constexpr (std::is_same_v<E, kernel::NoEnds>)  // what the lean batches do
    flops[name + kProducts] = double(count.multiplications);
}

/// @tparam lean  also of joints without ends: what the lean batches do
template <class F, Kind kind, bool with_tangent, bool lean>
void count(Flops& flops) {
  using Ends = kernel::Ends<reference::Counting>;
  const Inputs in = inputs_of<F>(kind);
  flops[std::string(F::name) + '/' + to_string(kind) + (with_tangent ? "/residual_tangent" : "/residual")] =
      transcription_flops<F, kind, with_tangent>(in);
  if constexpr (kernel::kHasKernel<F>) {
    count_kernel<F, kind, with_tangent, kernel::Accuracy<>, Ends>(flops, in, "");
    if constexpr (lean) {
      const Inputs bare = inputs_of<F>(kind, false);
      count_kernel<F, kind, with_tangent, kernel::Accuracy<>, kernel::NoEnds>(flops, bare, "/no_ends");
    }
  }
}

template <class F, bool lean>
Flops count() {
  Flops flops;
  count<F, Kind::angular, false, lean>(flops), count<F, Kind::angular, true, lean>(flops);
  count<F, Kind::linear, false, lean>(flops), count<F, Kind::linear, true, lean>(flops);
  count<F, Kind::linear_angular, false, lean>(flops), count<F, Kind::linear_angular, true, lean>(flops);
  return flops;
}

}  // namespace halfway::bench
