// A batch as a benchmark case: its tables, and its check at 50 digits.
#pragma once

#include "bench/harness/check.hpp"
#include "halfway/batch/table.hpp"

#include <memory>

namespace halfway::bench {

/// What is timed.
struct BatchProblem {
  std::shared_ptr<const Inputs> in;  ///< its poses, over and over
  std::string formulation;
  batch::Isa isa;
  batch::Output output;
  long joints;
  bool ends = false;
  bool block_diagonal = false;  ///< is the law of `in`: some kernels have a loop for it
  batch::Options options{};
};

/// Tables of `joints` joints and of their results.
template <class T>
class BatchData {
 public:
  explicit BatchData(const BatchProblem& problem);
  /// Allocation and conversion are done: this is the timed call.
  void evaluate() const { batch_.evaluate(joints_, results_, output_, options_); }
  /// A compressed tangent, for at() and same().
  void expand() const;
  /// Loads and tangent of joint i; of a product the loads alone.
  Evaluated at(long i) const;
  /// Largest |J v - tangent v| over the first joints, relative to the tangent's largest entry.
  double product_error(const BatchData& with_tangent, long joints) const;
  /// Is joint i bit for bit as joint j?
  bool same(long i, long j) const;
  bool built() const { return batch_.has<T>(output_); }

 private:
  batch::Batch batch_;
  batch::Output output_;
  batch::Options options_;
  batch::Table<T> q_a_, q_b_, x_a_, x_b_, law_, direction_;
  mutable batch::Table<T> loads_, tangent_, expanded_;
  batch::BatchEnd<T> a_, b_;
  batch::Joints<T> joints_;
  batch::Results<T> results_;
};

/// Is there code for that, and does this machine have the instruction set?
template <class T>
bool can_run(const BatchProblem& problem);

/// Name, check and loop; flops are added by the caller: those of the kernel of one joint.
template <class T>
Case batch_case(const BatchProblem& problem);

}  // namespace halfway::bench
