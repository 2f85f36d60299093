// One pack of joints between the nodes and the matrix: its inputs and results, in the nearest cache.
#pragma once

#include "halfway/assemble/scatter.hpp"
#include "halfway/batch/batch.hpp"

#include <algorithm>

namespace halfway::assemble::detail {

inline const Scatter& scatter_for([[maybe_unused]] int lanes) {
#ifdef __x86_64__
  if (lanes >= 4) return kScatter_Avx2;
#endif
  return kScatter_Sse2;
}

class Stage {
 public:
  Stage(const batch::Model& model, const batch::detail::PackLoop& loop,
        const batch::Columns<const double>& law, bool law_per_joint)
      : loop_(loop), law_(law), law_rows_(law_rows(model.kind, model.law)), law_per_joint_(law_per_joint) {
    job_.count = loop.lanes;
    job_.q_a = {q_a_, loop.lanes}, job_.q_b = {q_b_, loop.lanes};
    job_.x_a = {x_a_, loop.lanes}, job_.x_b = {x_b_, loop.lanes};
    job_.law = {numbers_, loop.lanes};
    job_.law_step = law_per_joint ? 1 : 0;
    job_.polynomial = model.law == batch::LawForm::polynomial;
    job_.parameters = parameters(model);
    job_.loads = {loads_, loop.lanes}, job_.tangent = {tangent_, loop.lanes};
    static constexpr batch::BatchEnd<double> kAtTheNode{};
    set_ends(kAtTheNode, kAtTheNode);
    if (law_per_joint) return;
    for (int row = 0; row < law_rows_; ++row)
      std::fill_n(numbers_ + row * loop.lanes, loop.lanes, law.first[row * law.stride]);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void set_ends(const batch::BatchEnd<double>& a, const batch::BatchEnd<double>& b) {
    job_.a = &a, job_.b = &b;
  }

  const Scatter& scatter() const { return scatter_; }
  /// Where the results are; targets and places are the caller's.
  PackResults results() {
    PackResults r{};
    r.loads = loads_, r.tangent = tangent_, r.lanes = loop_.lanes, r.nowhere = nowhere_;
    return r;
  }

  void evaluate(const NodePose* poses, const Target* targets) {
    scatter_.gather(poses, targets, loop_.lanes, {q_a_, q_b_, x_a_, x_b_});
    if (law_per_joint_) read_law(targets);
    loop_.evaluate(job_);
  }

 private:
  /// Joints that follow one another are read where they are.
  void read_law(const Target* targets) {
    const int lanes = loop_.lanes;
    if (targets[lanes - 1].joint == targets[0].joint + lanes - 1) {
      job_.law = {law_.first + targets[0].joint, law_.stride};
      // As many streams as a law has numbers are more than the hardware follows.
      for (int row = 0; row < law_rows_; ++row)
        __builtin_prefetch(job_.law.first + row * law_.stride + 2 * lanes);
      return;
    }
    for (int row = 0; row < law_rows_; ++row) {
      for (int l = 0; l < lanes; ++l)
        numbers_[row * lanes + l] = law_.first[row * law_.stride + targets[l].joint];
    }
    job_.law = {numbers_, lanes};
  }

  static constexpr int kMaxLanes = 8;
  const batch::detail::PackLoop loop_;
  const Scatter& scatter_ = scatter_for(loop_.lanes);
  const batch::Columns<const double> law_;
  const int law_rows_;
  const bool law_per_joint_;
  batch::detail::Job<double> job_;
  alignas(64) double q_a_[4 * kMaxLanes], q_b_[4 * kMaxLanes], x_a_[3 * kMaxLanes], x_b_[3 * kMaxLanes];
  alignas(64) double numbers_[21 * kMaxLanes], loads_[9 * kMaxLanes], tangent_[81 * kMaxLanes];
  double nowhere_[36] = {};
};

}  // namespace halfway::assemble::detail
