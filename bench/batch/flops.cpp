// Flops of one joint of a batch: those of its kernel, counted with the kernels' own cases; what they
// spend on ends is the same for every formulation and counted once.
#include "bench/batch/problem.hpp"
#include "bench/kernels/kernel_joint.hpp"
#include "formulations/systems/attached.hpp"
#include "formulations/systems/intrinsic.hpp"
#include "formulations/systems/jointc.hpp"
#include "formulations/systems/potentials.hpp"
#include "reference/counting.hpp"

namespace halfway::bench {

template <class F, Kind kind, bool with_tangent, class Accuracy = kernel::Accuracy<>>
double kernel_flops(const Inputs& in);

namespace {

/// Of an attached joint without ends.
template <Kind kind, bool with_tangent>
double without_ends(const Inputs& in) {
  using reference::Counting;
  const auto joint = static_kernel_joint<AttachedA, kind, Counting, kernel::NoEnds>(in.spec);
  const auto cast = [](const reference::QuaternionPose<double>& p) {
    return reference::plain(reference::QuaternionPose<Counting>{p.x.cast<Counting>(), p.q.cast<Counting>()});
  };
  const auto a = cast(in.qa.front()), b = cast(in.qb.front());
  const auto operations = reference::counted([&] {
    if constexpr (kind == Kind::angular)
      (void)kernel::loads<with_tangent, kernel::Accuracy<>>(joint, a.q, b.q);
    else
      (void)kernel::loads<with_tangent, kernel::Accuracy<>>(joint, a, b);
  });
  return double(operations.flops());
}

template <class F, Kind kind, bool with_tangent>
double count(const BatchProblem& p) {
  const double with_ends = kernel_flops<F, kind, with_tangent>(*p.in);
  if (p.ends) return with_ends;
  return with_ends -
         (kernel_flops<AttachedA, kind, with_tangent>(*p.in) - without_ends<kind, with_tangent>(*p.in));
}

template <class F, Kind kind>
double count(const BatchProblem& p) {
  return p.output == batch::Output::residual ? count<F, kind, false>(p) : count<F, kind, true>(p);
}

template <class F>
double count(const BatchProblem& p) {
  switch (p.in->spec.kind) {
    case Kind::angular:
      return count<F, Kind::angular>(p);
    case Kind::linear:
      return count<F, Kind::linear>(p);
    default:
      return count<F, Kind::linear_angular>(p);
  }
}

}  // namespace

double batch_flops(const BatchProblem& p) {
  if (p.output == batch::Output::product) return 0;  // the batch's own dual numbers are not counted
  if (p.formulation == AttachedA::name) return count<AttachedA>(p);
  if (p.formulation == Invariant::name) return count<Invariant>(p);
  if (p.formulation == Intrinsic::name) return count<Intrinsic>(p);
  if (p.formulation == Jointc::name) return count<Jointc>(p);
  if (p.formulation == Conformal::name) return count<Conformal>(p);
  return 0;
}

}  // namespace halfway::bench
