// Where the blocks of many joints lie in a sparse matrix: found once, from the nodes that each joint
// connects.
//
//   const Pattern pattern({.layout = Layout::blocks}, rows_of(node_count, fixed_nodes), joints);
//
// A node has six unknowns, (x, w) as the loads are ordered, or three, its spin w, where all joints are
// angular. A joint between nodes a and b has four blocks, (a, a), (a, b), (b, a) and (b, b); those of a fixed
// node are left out, and so is, of an upper triangle, what lies below its diagonal blocks.
#pragma once

#include <span>
#include <vector>

namespace halfway::assemble {

/// The nodes that a joint connects; they may be the same one, and in any order.
struct Nodes {
  int a = 0, b = 0;
};

/// In place of a row: the node does not move, and has neither row nor column.
inline constexpr int kFixed = -1;

/// How the numbers of a matrix follow one another.
enum class Layout {
  blocks,  ///< block CSR: block after block of a row, each by rows
  rows,    ///< CSR, number after number of a row
  columns  ///< CSC, what an Eigen::SparseMatrix is by default
};

enum class Part {
  whole,
  upper  ///< blocks on the diagonal, in full and symmetric, and right of it: for joints that have a potential
};

struct Form {
  int unknowns = 6;  ///< of a node: 6, or 3 for angular joints alone
  Layout layout = Layout::blocks;
  Part part = Part::whole;
};

/// One joint: where its numbers go.
struct Place {
  int joint;
  int node[2];    ///< a and b
  int row[2];     ///< the first of their unknowns; -1: fixed
  int block[4];   ///< the first number of blocks aa, ab, ba, bb among the values; -1: none
  int stride[2];  ///< from one stored row of a's (b's) blocks to the next
};

class Pattern {
 public:
  /// The matrix of these joints alone. @param rows  of each node: its place among the unknowns, 0, 1, ..., or
  /// kFixed (rows_of). Throws std::invalid_argument that names the node or joint: a row twice or negative, a
  /// node that there is not, a number of unknowns that is neither 6 nor 3, more than 2^31 - 1 numbers.
  Pattern(const Form& form, std::span<const int> rows, std::span<const Nodes> joints);

  /// These joints within a larger matrix, of which nothing else is touched. @param start, index  as start()
  /// and index() of that matrix, indices ascending. Throws, besides, where a block of a joint is not in it,
  /// or where the rows (columns) of a node do not all have the same entries.
  Pattern(const Form& form, std::span<const int> rows, std::span<const Nodes> joints,
          std::span<const int> start, std::span<const int> index);

  const Form& form() const { return form_; }
  /// Where each row begins, and columns: of blocks, or of numbers; of a CSC matrix the same by columns.
  std::span<const int> start() const { return start_; }
  std::span<const int> index() const { return index_; }
  /// Numbers that the matrix holds.
  long value_count() const;
  /// Unknowns: the length of the residual.
  long unknown_count() const { return long(form_.unknowns) * row_count_; }
  long node_count() const { return node_count_; }
  /// One a joint, in the order given.
  std::span<const Place> places() const { return places_; }

 private:
  Form form_;
  long node_count_ = 0, row_count_ = 0;
  std::vector<int> start_, index_;
  std::vector<Place> places_;
};

/// Rows for Pattern: all nodes in order but the fixed ones. Throws std::invalid_argument: no such node.
std::vector<int> rows_of(int node_count, std::span<const int> fixed = {});

}  // namespace halfway::assemble
