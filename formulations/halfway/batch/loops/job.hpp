// What the units of the instruction sets see of a batch: plain pointers and numbers, and what they
// give back: plain functions. No standard header.
#pragma once

#include "halfway/joint/parameters.hpp"
#include "halfway/rotations/cpp20.hpp"

namespace halfway::batch {

/// A table of numbers, one row of joints per component: component c of joint i at first[c * stride + i].
/// Rows that begin at the same place in a page fight for the same few lines of the cache: a stride
/// that is an odd number of cache lines is the quickest (padded_stride).
template <class T>
struct Columns {
  T* first = nullptr;
  long stride = 0;
  long size = 0;  ///< numbers that the array holds; read by validate() alone
};

/// Joint point o (m, node axes) and joint frame H (unit quaternion w, x, y, z, joint -> node axes).
template <class T>
struct BatchEnd {
  T o[3]{0, 0, 0};
  T H[4]{1, 0, 0, 0};
};

namespace detail {

/// Where results go: number c of joint i at at(i)[c * stride]. Rows of a table (rows = 1), or blocks of
/// `block` joints, a power of two, with so many rows each.
template <class T>
struct Place {
  T* first = nullptr;
  long stride = 0;
  long rows = 1, block = 1;

  constexpr T* at(long i) const { return first + (i & -block) * rows + (i & (block - 1)); }
};

/// One call of a kernel: joints 0 .. count, a multiple of the pack's lanes.
template <class T>
struct Job {
  long count = 0;
  Columns<const T> q_a{}, q_b{}, x_a{}, x_b{}, law{}, direction{};
  long law_step = 0;  ///< joints' law numbers follow one another: 1; shared, one pack of copies: 0
  bool polynomial = false;
  const BatchEnd<T>*a = nullptr, *b = nullptr;  ///< read by the loops for any joints: both
  Parameters parameters{};
  Place<T> loads{}, tangent{};
};

template <class T>
using Evaluate = void (*)(const Job<T>&);

/// nullptr: not built. Joints without ends and with a linear law, the most frequent, may have lean loops
/// (Loop, unit.hpp).
template <class T>
struct Functions {
  Evaluate<T> residual = nullptr, tangent = nullptr, lean_residual = nullptr, lean_tangent = nullptr,
              lean_compressed = nullptr, product = nullptr;
};

/// Some packs of results, [pack][row][lane], loads before the tangent, and where the first of them goes.
template <class T>
struct Block {
  const T* first;
  long packs;
  int load_rows, tangent_rows;
  Place<T> loads, tangent;
};

/// Joints' compressed tangents with their loads, and what is made of them.
struct Unpacking {
  long count;
  Columns<const double> x_a, x_b, direction;
  Place<const double> loads, tangent;
  Place<double> out;
};

/// What becomes of blocks whose tables a loop does not write itself.
template <class T>
using Spread = void (*)(const Block<T>&);
template <class T>
struct Spreading {
  Spread<T> streamed, all_entries, all_entries_streamed;
};
/// Of one form of compressed tangents.
struct Compressing {
  Spread<double> compress;
  void (*expand)(const Unpacking&);
  void (*expand_all)(const Unpacking&);
  void (*multiply)(const Unpacking&);
};
struct Spreadings {
  Spreading<double> in_double;
  Spreading<float> in_float;
  Compressing angular, general, conservative;

  constexpr const Compressing& compressing(int rows) const {
    return rows == 9 ? angular : rows == 33 ? general : conservative;
  }
};

/// A loop and how many joints it takes at a time.
struct PackLoop {
  Evaluate<double> evaluate;
  int lanes;
};

/// One formulation in one instruction set, by kind. Constant data: asking for it runs no instruction
/// of that set.
struct Unit {
  Functions<double> in_double[3];
  Functions<float> in_float[3];
};

}  // namespace detail
}  // namespace halfway::batch
