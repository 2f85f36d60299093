// Nodes on a torus, each joined to the next one of its row and of its column: two joints a node, five blocks
// a row.
#pragma once

#include "bench/harness/check.hpp"
#include "halfway/assemble/assembler.hpp"
#include "halfway/batch/table.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace halfway::bench {

/// Generic poses, any two neighbours turned by less than 2.8 rad: no formulation of the comparison is near a
/// pole.
struct Lattice {
  reference::JointSpec spec;  ///< linear law without coupling, the same for all; ends at the nodes
  std::vector<assemble::NodePose> poses;
  std::vector<Pose<double>> matrices;  ///< the same, rounded
  std::vector<int> rows;
  std::vector<assemble::Nodes> joints;
  batch::Table<double> law;  ///< of spec, as batches read it
};

Lattice lattice(Kind kind, int width, int height);

/// Loads and tangent of all unknowns at 50 digits, joint by joint, and their largest entries.
struct ExactAssembly {
  Eigen::Matrix<reference::Real50, Eigen::Dynamic, 1> loads;
  Eigen::Matrix<reference::Real50, Eigen::Dynamic, Eigen::Dynamic> tangent;
};
ExactAssembly exact_assembly(const std::string& formulation, const Lattice& lattice);

/// Residual and values into the pattern's arrays, which hold anything before.
using Assemble = std::function<void(std::span<double> residual, std::span<double> values)>;
/// One way to do it, ready for a lattice and its pattern, which outlive it.
using Way = std::function<Assemble(const Lattice&, const assemble::Pattern&)>;

/// Joint after joint in matrices, as one writes the paper down; as MBDyn codes it; by the kernel; a batch's
/// whole table first, then joint after joint. All zero the matrix and add.
Way textbook_way(Kind kind);
Way mbdyn_like_way(Kind kind);
Way kernel_way(Kind kind);
Way batch_way();
Way assemble_way(const std::string& formulation, int threads);

}  // namespace halfway::bench
