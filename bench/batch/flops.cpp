// Flops of one joint of a batch: those of its kernel, with or without ends.
#include "bench/batch/problem.hpp"
#include "bench/kernels/counted_flops.hpp"
#include "formulations/systems/attached.hpp"
#include "formulations/systems/intrinsic.hpp"
#include "formulations/systems/jointc.hpp"
#include "formulations/systems/potentials.hpp"

namespace halfway::bench {

template <class F, Kind kind, bool with_tangent, class Accuracy = kernel::Accuracy<>>
double kernel_flops(const Inputs& in);

namespace {

template <class F, Kind kind, bool with_tangent>
double count(const BatchProblem& p) {
  if (p.ends) return kernel_flops<F, kind, with_tangent>(*p.in);
  return counted_flops<F, kind, with_tangent, kernel::Accuracy<>, kernel::NoEnds>(*p.in);
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
