#include "bench/questions/assembly/lattice.hpp"

#include "reference/numbers/random.hpp"

namespace halfway::bench {
namespace {

using reference::Real50;

/// Turned about a random axis by less than 1.4 rad.
reference::QuaternionPose<double> random_pose(reference::Generator& g) {
  const Vec3<double> axis = g.direction().normalized();
  const double half = g.uniform(0, 0.7);
  reference::QuaternionPose<double> p;
  p.x = g.vector(1);
  p.q << std::cos(half), std::sin(half) * axis;
  return p;
}

batch::Table<double> law_table(const Eigen::MatrixXd& K) {
  batch::Table<double> law(int(K.rows() * (K.rows() + 1)) / 2, 1);
  int row = 0;
  for (int r = 0; r < K.rows(); ++r) {
    for (int c = r; c < K.cols(); ++c) law(row++, 0) = K(r, c);
  }
  return law;
}

}  // namespace

Lattice lattice(Kind kind, int width, int height) {
  const Inputs in = inputs(kind, {}, true, false);
  const int count = width * height;
  Lattice out{in.spec, {},
              {},      assemble::rows_of(count),
              {},      law_table(std::get<reference::LinearSpec>(in.spec.law).matrix)};
  reference::Generator g(1743);
  for (int i = 0; i < count; ++i) {
    const auto p = random_pose(g);
    out.poses.push_back({{p.x[0], p.x[1], p.x[2]}, {p.q[0], p.q[1], p.q[2], p.q[3]}});
    out.matrices.push_back(reference::matrix_pose(p));
    out.joints.push_back({i, i / width * width + (i + 1) % width});
    out.joints.push_back({i, (i + width) % count});
  }
  return out;
}

ExactAssembly exact_assembly(const std::string& formulation, const Lattice& lattice) {
  const reference::Entry& entry = *reference::find_formulation(formulation);
  const int n = lattice.spec.kind == Kind::angular ? 3 : 6;
  const long size = n * long(lattice.poses.size());
  ExactAssembly out;
  out.loads.setZero(size), out.tangent.setZero(size, size);
  const auto pose = [&](int node) {
    const assemble::NodePose& p = lattice.poses[node];
    return reference::exact_pose({{p.x[0], p.x[1], p.x[2]}, {p.q[0], p.q[1], p.q[2], p.q[3]}});
  };
  for (const assemble::Nodes& joint : lattice.joints) {
    const auto one = reference::node_loads<Real50>(entry, lattice.spec, pose(joint.a), pose(joint.b), true);
    const int node[] = {joint.a, joint.b};
    for (int i = 0; i < 2; ++i) {
      out.loads.segment(n * node[i], n) += one.q.segment(6 * i + 6 - n, n);
      for (int j = 0; j < 2; ++j) {
        out.tangent.block(n * node[i], n * node[j], n, n) +=
            one.tangent.block(6 * i + 6 - n, 6 * j + 6 - n, n, n);
      }
    }
  }
  return out;
}

}  // namespace halfway::bench
