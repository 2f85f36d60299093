// What is wrong with an assembly is said by name; and assemblies that are wrong on purpose are seen.
#include "halfway/assemble/eigen.hpp"
#include "verify/oracle/mutants/verdicts.hpp"
#include "verify/studies/kernels/net.hpp"

#include <limits>
#include <stdexcept>

namespace halfway::verify {
namespace {

using assemble::Assembler, assemble::Form, assemble::Layout, assemble::Nodes, assemble::Part,
    assemble::Pattern;

int refused_patterns() {
  const std::vector<int> rows{0, 1, 2};
  const std::vector<Nodes> joints{{0, 1}, {1, 2}};
  const std::vector<int> start{0, 2, 4, 5}, index{0, 1, 0, 1, 2};  // no (1, 2), no (2, 1)
  const auto pattern = [&](const Form& form, std::span<const int> r, std::span<const Nodes> j) {
    return [=] { Pattern(form, r, j); };
  };
  const std::vector<Nodes> beyond{{0, 1}, {1, 3}}, negative{{0, 1}, {-2, 1}};
  const std::vector<int> twice{0, 2, 2}, below{0, -3, 1};
  int wrong = 1 - silent(pattern({}, rows, joints), {});
  wrong += silent(pattern({}, rows, beyond), {"joint 1", "node b", "3"});
  wrong += silent(pattern({}, rows, negative), {"joint 1", "node a", "-2"});
  wrong += silent(pattern({}, twice, joints), {"nodes 1 and 2", "same row", "2"});
  wrong += silent(pattern({}, below, joints), {"node 1", "-3"});
  wrong += silent(pattern({.unknowns = 4}, rows, joints), {"6", "3", "4"});
  wrong += silent([] { assemble::rows_of(3, std::vector<int>{3}); }, {"fixed node 3", "3 nodes"});
  const auto within = [&](std::span<const int> s, std::span<const int> i) {
    return [=] { Pattern({}, rows, joints, s, i); };
  };
  wrong += silent(within(start, index), {"joint 1", "no block", "row 1", "column 2"});
  wrong += silent(within(std::span(start).first(3), index), {"2 rows", "need 3"});
  const std::vector<int> unsorted{1, 0, 0, 1, 2}, backward{0, 2, 1, 5};
  wrong += silent(within(start, unsorted), {"row 0", "ascend"});
  wrong += silent(within(backward, index), {"row 1", "from 2 to 1"});
  Eigen::SparseMatrix<double> loose(18, 18);
  loose.reserve(Eigen::VectorXi::Constant(18, 4));
  wrong += silent([&] { assemble::pattern_within(loose, 6, rows, joints); }, {"makeCompressed"});
  wrong += silent([&] { assemble::matrix_of(Pattern({}, rows, joints)); }, {"layout"});
  return wrong;
}

int refused_assemblies() {
  const Net net = random_net(invariant(), Kind::linear_angular);
  const Pattern pattern({}, net.rows, net.nodes), upper({.part = Part::upper}, net.rows, net.nodes),
      turning({.unknowns = 3}, net.rows, net.nodes);
  const batch::Model model = NetInput(net).model();
  int wrong = 0;
  wrong += silent([&] { Assembler(model, upper); }, {"invariant", "no potential", "Part::whole"});
  wrong += silent([&] { Assembler(model, turning); }, {"3 unknowns", "linear_angular"});
  wrong += silent([&] { Assembler(model, pattern, {.threads = 0}); }, {"threads", "0"});
  wrong += silent([&] { Assembler(model, pattern, {.first = 20, .count = 20}); }, {"20 to 39", "29"});
  wrong += silent([&] { Assembler({.formulation = "invarient"}, pattern); }, {"invarient", "invariant"});
  const Assembler assembler(model, pattern);
  std::vector<double> residual(pattern.unknown_count()), values(pattern.value_count());
  const auto spoilt = [&](auto&& spoil, std::initializer_list<const char*> words) {
    NetInput in(net);
    assemble::Input input = in.input();
    std::span<double> r = residual, v = values;
    spoil(in, input, r, v);
    return silent([&] { assemble::validate(assembler, input), assembler.assign(input, r, v); }, words);
  };
  using In = assemble::Input;
  using Numbers = std::span<double>;
  wrong += 1 - spoilt([](NetInput&, In&, Numbers&, Numbers&) {}, {});
  wrong += spoilt([](NetInput& n, In&, Numbers&, Numbers&) { n.poses[4].q[2] *= 1.5; }, {"node 4", "length"});
  wrong += spoilt([](NetInput& n, In&, Numbers&, Numbers&) { n.poses[6].x[1] = std::nan(""); },
                  {"node 6", "x[1]", "nan"});
  wrong += spoilt([](NetInput& n, In&, Numbers&, Numbers&) { n.tables().law(4, 19) = HUGE_VAL; },
                  {"joint 19", "law[4]", "inf"});
  wrong += spoilt([](NetInput&, In& in, Numbers&, Numbers&) { in.b = nullptr; }, {"one node alone"});
  wrong +=
      spoilt([](NetInput&, In& in, Numbers&, Numbers&) { in.poses = in.poses.first(5); }, {"5 poses", "13"});
  wrong += spoilt([](NetInput&, In&, Numbers& r, Numbers&) { r = r.first(7); }, {"residual", "7"});
  wrong += spoilt([](NetInput&, In&, Numbers&, Numbers& v) { v = v.first(8); }, {"matrix", "8"});
  wrong += spoilt([](NetInput&, In& in, Numbers&, Numbers&) { in.law = {}; }, {"law", "missing"});
  return wrong;
}

Finding assembly_refused() {
  return counted("assembly_refusals", refused_patterns() + refused_assemblies(),
                 "each spoilt input is refused, joint, node and value named");
}

/// Distance of a full matrix from that of single joints, of the largest joint's scale.
Measurement matrix_distance(const Eigen::MatrixXd& value, const Exact& exact) {
  Measurement worst;
  for (long i = 0; i < value.size(); ++i) {
    worst.include(std::abs(double(Real50(value(i)) - exact.tangent(i))) / exact.tangent_scale, "");
  }
  return worst;
}

Eigen::MatrixXd assembled_matrix(const Net& net) {
  const NetInput in(net);
  const Pattern pattern({}, net.rows, net.nodes);
  return full_matrix(pattern, assembled(Assembler(in.model(), pattern), pattern, in.input(), true, 0).values);
}

void add_net_mutant(Checks& checks, const char* name, Eigen::MatrixXd (*wrong)(const Net&)) {
  add_mutant(checks, name, "assembly", 5e-15, [wrong] {
    const Net net = solved_net(invariant(), Kind::linear_angular);
    const Exact exact = exact_sums(net, 6);
    return std::pair{matrix_distance(wrong(net), exact), matrix_distance(assembled_matrix(net), exact)};
  });
}

/// The block by which the first joint of two free nodes couples them, transposed.
Eigen::MatrixXd transposed_block(const Net& net) {
  Eigen::MatrixXd K = assembled_matrix(net);
  for (const Nodes& n : net.nodes) {
    if (n.a == n.b || net.rows[n.a] < 0 || net.rows[n.b] < 0) continue;
    auto block = K.block<6, 6>(6 * net.rows[n.a], 6 * net.rows[n.b]);
    block = block.transpose().eval();
    break;
  }
  return K;
}

/// One joint's loads do not reach its node b.
Eigen::MatrixXd lost_end(const Net& net) {
  Eigen::MatrixXd K = assembled_matrix(net);
  Net alone = net;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    if (net.rows[net.nodes[i].b] < 0) continue;
    alone.nodes = {net.nodes[i]}, alone.joints = {net.joints[i]};
    const int row = 6 * net.rows[net.nodes[i].b];
    K.middleRows<6>(row) -= exact_sums(alone, 6).tangent.middleRows<6>(row).cast<double>();
    break;
  }
  return K;
}

Eigen::MatrixXd doubled_joint(const Net& net) {
  Net more = net;
  more.nodes.push_back(net.nodes[9]), more.joints.push_back(net.joints[9]);
  return assembled_matrix(more);
}

}  // namespace

void assembly_refusals(Checks& checks) {
  checks.push_back({"batch/assembly_refusals", "batch", [] { return std::vector{assembly_refused()}; }});
  add_net_mutant(checks, "assembly_transposed_block", transposed_block);
  add_net_mutant(checks, "assembly_lost_end", lost_end);
  add_net_mutant(checks, "assembly_doubled_joint", doubled_joint);
}

}  // namespace halfway::verify
