// Nodes and joints between them, assembled at 50 digits joint by joint: what an assembly has to agree with.
#pragma once

#include "halfway/assemble/assembler.hpp"
#include "verify/studies/kernels/batch.hpp"

#include <vector>

namespace halfway::verify {

/// Joints of one model between turned and moved nodes: nodes that many share, two fixed ones, joints from a
/// node to itself and between the fixed ones, pairs of joints between the same two nodes, one of them the
/// other way round. Ends: third turns and offsets of order one.
struct Net {
  const Entry* entry;
  std::vector<reference::QuaternionPose<double>> poses;
  std::vector<int> rows;
  std::vector<assemble::Nodes> nodes;  ///< of each joint
  std::vector<BatchJoint> joints;
};

Net random_net(const Entry& entry, Kind kind);
/// The same, its joints solved at 50 digits.
Net solved_net(const Entry& entry, Kind kind);

/// Loads and tangent of all unknowns, and what their errors are relative to: the largest scale of a joint.
struct Exact {
  Eigen::Matrix<Real50, Eigen::Dynamic, 1> loads;
  Eigen::Matrix<Real50, Eigen::Dynamic, Eigen::Dynamic> tangent;
  double load_scale = 0, tangent_scale = 0;
};

/// Each joint of a solved net added by its nodes' rows. @param unknowns  of a node, 6 or 3
Exact exact_sums(const Net& net, int unknowns);

/// A net as an assembly reads it; it lives as long as the net.
class NetInput {
 public:
  explicit NetInput(const Net& net);
  assemble::Input input() const;
  const batch::Model& model() const { return tables_.model; }
  std::vector<assemble::NodePose> poses;  ///< to be spoilt by who wants to
  BatchTables<double>& tables() { return tables_; }

 private:
  BatchTables<double> tables_;
};

/// What an assembly wrote.
struct Assembled {
  std::vector<double> residual, values;
};

/// Into memory that is full of `before`.
Assembled assembled(const assemble::Assembler& assembler, const assemble::Pattern& pattern,
                    const assemble::Input& input, bool assign, double before);

/// The matrix of `values` as a full one.
Eigen::MatrixXd full_matrix(const assemble::Pattern& pattern, const std::vector<double>& values);

}  // namespace halfway::verify
