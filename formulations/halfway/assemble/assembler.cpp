#include "halfway/assemble/assembler.hpp"

#include "halfway/assemble/stage.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>

namespace halfway::assemble {
namespace {

using batch::Output, detail::Shape;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("assemble: " + what); }

std::string text(long x) { return std::to_string(x); }

Shape shape_of(const Form& form, Kind kind) {
  const bool three = kind == Kind::angular;
  if (form.layout == Layout::columns) return three ? Shape::columns3 : Shape::columns6;
  if (form.layout == Layout::rows || (three && form.unknowns == 6))
    return three ? Shape::rows3 : Shape::rows6;
  return three ? Shape::whole3 : Shape::whole6;
}

long count_of(const Pattern& pattern, const Options& options) {
  const long all = long(pattern.places().size());
  const long count = options.count < 0 ? all - options.first : options.count;
  if (options.first < 0 || count < 0 || options.first + count > all) {
    refuse("joints " + text(options.first) + " to " + text(options.first + count - 1) + " of " + text(all) +
           " in the pattern");
  }
  return count;
}

}  // namespace

struct Assembler::Call {
  const Input& input;
  std::span<double> residual, values;
  bool assign;
};

Assembler::Assembler(const batch::Model& model, const Pattern& pattern, const Options& options)
    : batch_(model, options.isa),
      shape_(shape_of(pattern.form(), model.kind)),
      symmetric_(pattern.form().part == Part::upper),
      joint_count_(count_of(pattern, options)),
      node_count_(pattern.node_count()),
      unknown_count_(pattern.unknown_count()),
      value_count_(pattern.value_count()) {
  const bool angular = model.kind == Kind::angular;
  const int unknowns = pattern.form().unknowns;
  if (unknowns == 3 && !angular)
    refuse("nodes of 3 unknowns have angular joints alone, not " + std::string(to_string(model.kind)));
  if (symmetric_ && !batch_.has_potential())
    refuse("'" + model.formulation + "' has no potential, so that its tangent is not symmetric: Part::whole");
  if (options.threads < 1) refuse("threads are " + text(options.threads) + ", at least 1");
  const int lanes = batch_.loop(Output::tangent, false).lanes;
  const detail::Packs packs{options.first,
                            joint_count_,
                            lanes,
                            detail::scatter_for(lanes).lanes,
                            angular ? detail::kOrder3 : detail::kOrder6,
                            angular && unknowns == 6 ? 3 : 0};
  shares_ = detail::share_out(pattern, packs, options.threads);
}

void Assembler::check(const Call& call) const {
  if (long(call.input.poses.size()) != node_count_)
    refuse(text(long(call.input.poses.size())) + " poses, the pattern is of " + text(node_count_) + " nodes");
  if (long(call.residual.size()) != unknown_count_)
    refuse("the residual has " + text(long(call.residual.size())) + " numbers, the pattern " +
           text(unknown_count_) + " unknowns");
  if (!call.values.empty() && long(call.values.size()) != value_count_)
    refuse("the matrix has " + text(long(call.values.size())) + " numbers, the pattern " +
           text(value_count_));
  if (joint_count_ > 0 && call.input.law.first == nullptr) refuse("law is missing");
}

void Assembler::assign(const Input& input, std::span<double> residual, std::span<double> values) const {
  run({input, residual, values, true});
}

void Assembler::add(const Input& input, std::span<double> residual, std::span<double> values) const {
  run({input, residual, values, false});
}

void Assembler::run(const Call& call) const {
  check(call);
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < shares_.size(); ++k) {
    others.emplace_back([&, k] { run_share(call, shares_[k]); });
  }
  run_share(call, shares_[0]);
}

void Assembler::run_share(const Call& call, const detail::Share& share) const {
  if (call.assign) std::fill(call.residual.begin() + share.begin, call.residual.begin() + share.end, 0.);
  const Input& in = call.input;
  const bool with_tangent = !call.values.empty();
  const auto loop =
      batch_.loop(with_tangent ? Output::tangent : Output::residual, in.a != nullptr && in.b != nullptr);
  detail::Stage stage(batch_.model(), loop, in.law, in.law_per_joint);
  if (in.a != nullptr && in.b != nullptr) stage.set_ends(*in.a, *in.b);
  detail::PackResults results = stage.results();
  results.firsts = call.assign ? 15 : 0;
  results.symmetric = symmetric_;
  results.residual = call.residual.data(), results.values = call.values.data();
  const detail::Scatter& scatter = stage.scatter();
  const bool angular = batch_.model().kind == Kind::angular;
  for (std::size_t i = 0; i < share.targets.size(); i += loop.lanes) {
    results.targets = share.targets.data() + i;
    stage.evaluate(in.poses.data(), results.targets);
    scatter.residual[!angular](results);
    if (with_tangent) scatter.tangent[int(shape_)](results);
  }
}

}  // namespace halfway::assemble
