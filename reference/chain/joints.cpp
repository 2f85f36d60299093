#include "reference/chain/joints.hpp"

#include <algorithm>

namespace halfway::reference::chain::detail {

using batch::Batch, batch::Output;

Eigen::Matrix<double, 6, 1> stiffness(const Chain& c) {
  const Section& s = c.section;
  const double h = c.length / double(c.links);
  // A joint that knows its length stands for all of its link: across, that also gives way by its bending.
  const double bends = Batch::needs_length(c.formulation) ? h * h / 12 : 0;
  Eigen::Matrix<double, 6, 1> k;
  k << s.EA, 1 / (1 / s.GA2 + bends / s.EI3), 1 / (1 / s.GA3 + bends / s.EI2), s.GJ, s.EI2, s.EI3;
  return k / h;
}

namespace {

/// A rod runs from the root on, whichever node is listed first.
batch::Model model_of(const Chain& c) {
  batch::Model out{c.formulation, Kind::linear_angular, batch::LawForm::linear, c.xi};
  out.length = c.length / double(c.links);
  out.axis = c.node_order == NodeOrder::tip_first ? -1 : 1;
  return out;
}

}  // namespace

Joints::Joints(const Chain& chain, const Settings& settings) {
  const Batch own(model_of(chain), settings.isa);
  how_.loads = own.loop(Output::residual, false).evaluate;
  how_.foreign = settings.tangent == Tangent::attached;
  how_.symmetrised = settings.tangent == Tangent::symmetrised;
  how_.tip_first = chain.node_order == NodeOrder::tip_first;
  set_tangent(how_.foreign ? Batch({"attached_a", Kind::linear_angular}, settings.isa) : own,
              chain.node_order);
  const auto k = stiffness(chain);
  constexpr int kDiagonal[] = {0, 6, 11, 15, 18, 20};  // of an upper triangle by rows
  if (Batch::needs_length(chain.formulation)) {
    how_.rod.length = chain.length / double(chain.links);
    std::copy_n(k.data(), 6, how_.rod.stiffness);
  }
  for (int i = 0; i < 6; ++i) std::fill_n(law_ + kDiagonal[i] * kChunk, kChunk, k[i]);
  static constexpr batch::BatchEnd<double> kAtTheNode{};
  how_.job.law = {law_, kChunk};
  how_.job.a = how_.job.b = &kAtTheNode;
  how_.job.parameters = batch::parameters(own.model());
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
