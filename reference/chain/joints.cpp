#include "reference/chain/joints.hpp"

#include <algorithm>

namespace halfway::reference::chain::detail {

using batch::Batch, batch::Output;

Eigen::Matrix<double, 6, 1> stiffness(const Chain& c) {
  const Section& s = c.section;
  Eigen::Matrix<double, 6, 1> k;
  k << s.EA, s.GA2, s.GA3, s.GJ, s.EI2, s.EI3;
  return k * (double(c.links) / c.length);
}

Joints::Joints(const Chain& chain, const Settings& settings) {
  const Batch own({chain.formulation, Kind::linear_angular, batch::LawForm::linear, chain.xi}, settings.isa);
  how_.loads = own.loop(Output::residual, false).evaluate;
  how_.foreign = settings.tangent == Tangent::attached;
  how_.symmetrised = settings.tangent == Tangent::symmetrised;
  how_.tip_first = chain.node_order == NodeOrder::tip_first;
  set_tangent(how_.foreign ? Batch({"attached_a", Kind::linear_angular}, settings.isa) : own,
              chain.node_order);
  const auto k = stiffness(chain);
  constexpr int kDiagonal[] = {0, 6, 11, 15, 18, 20};  // of an upper triangle by rows
  for (int i = 0; i < 6; ++i) std::fill_n(law_ + kDiagonal[i] * kChunk, kChunk, k[i]);
  static constexpr batch::BatchEnd<double> kAtTheNode{};
  how_.job.law = {law_, kChunk};
  how_.job.a = how_.job.b = &kAtTheNode;
  how_.job.xi = chain.xi.value_or(0.5);
}

/// The fewest numbers of which there is a loop.
void Joints::set_tangent(const Batch& batch, NodeOrder order) {
  how_.tangent = batch.loop(Output::tangent, false).evaluate;
  const int rows = Batch::compressed_rows(batch.model());
  if (rows == 0 || order == NodeOrder::tip_first) return;
  const auto lean = batch.loop(Output::compressed, false).evaluate;
  if (lean == batch.loop(Output::tangent, true).evaluate)
    return;  // no lean loops: all 81 numbers are written
  how_.tangent = lean;
  how_.kept = rows == 21 ? Kept::conservative : Kept::general;
}

}  // namespace halfway::reference::chain::detail
