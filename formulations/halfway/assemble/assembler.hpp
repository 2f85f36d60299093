// From poses to a sparse matrix: loads and tangents of many joints, evaluated by packs and put where they
// belong.
//
//   const Pattern pattern({.layout = Layout::blocks}, rows_of(node_count, fixed), joints);
//   const Assembler assembler({.formulation = "invariant", .kind = Kind::linear_angular}, pattern);
//   assembler.assign(input, residual, values);
//
// residual: q = dU/dx of all joints, internal loads; values: their tangent. To solve: tangent * step =
// -(residual - loads applied), and turn nodes by the spins of the step, in global axes. SI units, radians.
// Whatever the number of threads, the results are the same to the last bit.
#pragma once

#include "halfway/assemble/shares.hpp"
#include "halfway/batch/batch.hpp"

#include <optional>
#include <span>
#include <vector>

namespace halfway::assemble {

/// What an assembly reads. A column of `law` for each joint (law_rows of them), or one for all.
struct Input {
  std::span<const NodePose> poses;  ///< of all nodes, the fixed ones too
  batch::Columns<const double> law{};
  bool law_per_joint = false;
  const batch::BatchEnd<double>*a = nullptr,
        *b = nullptr;  ///< of all joints; none: the joint frames are the nodes
};

struct Options {
  int threads = 1;
  std::optional<batch::Isa> isa{};  ///< the widest to be used; none: HALFWAY_ISA or what the machine has
  /// The joints of the pattern that are of this model, from `first` on; -1: all that follow. Several
  /// assemblers, one a model, fill one matrix: the first assigns, or all of them add to zeros.
  long first = 0, count = -1;
};

class Assembler {
 public:
  /// Throws std::invalid_argument: as Batch does; joints that are not in the pattern; no threads; a model
  /// without a potential, whose tangent is not symmetric, for an upper triangle; other than angular joints
  /// with three unknowns a node.
  Assembler(const batch::Model& model, const Pattern& pattern, const Options& options = {});

  /// Loads (N, N m) and tangent of these joints take the place of what is there: of the whole residual, and
  /// of the entries of the matrix that these joints have; the others are left alone. @param values  of the
  /// pattern's matrix; empty: the residual alone. Throws std::invalid_argument where an array is too short or
  /// missing; of what is in them nothing is checked: validate().
  void assign(const Input& input, std::span<double> residual, std::span<double> values) const;
  /// The same, added to what is there.
  void add(const Input& input, std::span<double> residual, std::span<double> values) const;

  const batch::Model& model() const { return batch_.model(); }
  /// How many it has: columns of Input::law.
  long joint_count() const { return joint_count_; }
  long node_count() const { return node_count_; }

 private:
  struct Call;
  void check(const Call& call) const;
  void run(const Call& call) const;
  void run_share(const Call& call, const detail::Share& share) const;

  batch::Batch batch_;
  detail::Shape shape_;
  bool symmetric_;
  long joint_count_, node_count_, unknown_count_, value_count_;
  std::vector<detail::Share> shares_;
};

/// The first thing that is wrong with what an assembly reads: a pose or law number that is not finite, a
/// quaternion that is not of unit length, an end of one node alone. Throws std::invalid_argument that names
/// the node or joint, and the number found there.
void validate(const Assembler& assembler, const Input& input);

}  // namespace halfway::assemble
