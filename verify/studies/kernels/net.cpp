#include "verify/studies/kernels/net.hpp"

#include <algorithm>

namespace halfway::verify {
namespace {

using assemble::Layout;

constexpr int kNodes = 13, kJoints = 29;
constexpr int kFixedNodes[] = {0, 5};

std::vector<assemble::Nodes> connections(reference::Generator& g) {
  const auto any = [&] { return int(g.uniform(0, kNodes)); };
  std::vector<assemble::Nodes> out;
  for (int i = 0; i < kJoints; ++i) {
    assemble::Nodes n{any(), any()};
    if (i % 5 == 0) n.a = 7;  // shared by many
    if (i == 7) n.b = n.a;
    if (i == 12) n = {0, 5};
    if (i == 8) n.b = 5;
    if (i % 6 == 3) n = out[i - 1];
    if (i % 6 == 4) n = {out[i - 2].b, out[i - 2].a};
    out.push_back(n);
  }
  return out;
}

}  // namespace

Net random_net(const Entry& entry, Kind kind) {
  reference::Generator g(1987);
  Net net{&entry, {}, assemble::rows_of(kNodes, kFixedNodes), connections(g), {}};
  for (int i = 0; i < kNodes; ++i) {
    const Vec3<double> x = g.vector(1);
    net.poses.push_back({x, reference::turned_pair(g, g.uniform(0, 3), false).b});
  }
  const auto laws = probes(entry, kind, 8, 1);
  for (const assemble::Nodes& nodes : net.nodes) {
    BatchJoint j{laws[net.joints.size() % laws.size()].spec, net.poses[nodes.a], net.poses[nodes.b]};
    j.spec.a = {{0.3, -0.2, 0.1}, reference::third_of_turn(1)};
    j.spec.b = {{-0.1, 0.4, 0.2}, reference::third_of_turn(-1)};
    net.joints.push_back(j);
  }
  return net;
}

Net solved_net(const Entry& entry, Kind kind) {
  Net net = random_net(entry, kind);
  for (BatchJoint& j : net.joints) solve(entry, j);
  return net;
}

Exact exact_sums(const Net& net, int unknowns) {
  const long size =
      unknowns * std::ranges::count_if(net.rows, [](int row) { return row != assemble::kFixed; });
  const int from = 6 - unknowns;  // the rotations alone are the last of a node's loads
  Exact out;
  out.loads.setZero(size), out.tangent.setZero(size, size);
  for (std::size_t i = 0; i < net.joints.size(); ++i) {
    const BatchJoint& j = net.joints[i];
    keep_largest(out.load_scale, j.scale);
    keep_largest(out.tangent_scale, double(largest_entry<Real50>(j.exact.tangent)));
    const int row[] = {net.rows[net.nodes[i].a], net.rows[net.nodes[i].b]};
    for (int n = 0; n < 2; ++n) {
      if (row[n] == assemble::kFixed) continue;
      out.loads.segment(unknowns * row[n], unknowns) += j.exact.q.segment(6 * n + from, unknowns);
      for (int m = 0; m < 2; ++m) {
        if (row[m] == assemble::kFixed) continue;
        out.tangent.block(unknowns * row[n], unknowns * row[m], unknowns, unknowns) +=
            j.exact.tangent.block(6 * n + from, 6 * m + from, unknowns, unknowns);
      }
    }
  }
  return out;
}

NetInput::NetInput(const Net& net) : tables_(*net.entry, net.joints, batch::LawForm::linear, true, 1) {
  for (const auto& p : net.poses) {
    poses.push_back({{p.x[0], p.x[1], p.x[2]}, {p.q[0], p.q[1], p.q[2], p.q[3]}});
  }
}

assemble::Input NetInput::input() const {
  const batch::Joints<double> j = tables_.joints();
  return {poses, j.law, true, j.a, j.b};
}

Assembled assembled(const assemble::Assembler& assembler, const assemble::Pattern& pattern,
                    const assemble::Input& input, bool assign, double before) {
  Assembled out{std::vector<double>(pattern.unknown_count(), before),
                std::vector<double>(pattern.value_count(), before)};
  if (assign)
    assembler.assign(input, out.residual, out.values);
  else
    assembler.add(input, out.residual, out.values);
  return out;
}

Eigen::MatrixXd full_matrix(const assemble::Pattern& pattern, const std::vector<double>& values) {
  const assemble::Form& form = pattern.form();
  const long size = pattern.unknown_count();
  const int n = form.layout == Layout::blocks ? form.unknowns : 1;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t row = 0; row + 1 < pattern.start().size(); ++row) {
    for (int k = pattern.start()[row]; k < pattern.start()[row + 1]; ++k) {
      for (int e = 0; e < n * n; ++e) {
        out(n * long(row) + e / n, n * pattern.index()[k] + e % n) += values[long(n) * n * k + e];
      }
    }
  }
  if (form.layout == Layout::columns) out.transposeInPlace();
  return out;
}

}  // namespace halfway::verify
