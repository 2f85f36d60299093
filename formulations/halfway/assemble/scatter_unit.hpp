// Packs of results into a matrix: transposed in registers, added as vectors; included by the units alone.
//
// The loops of a batch leave a pack's results in the nearest cache, [row][lane]. Four lanes (two with SSE2)
// of as many rows are turned into that many consecutive numbers of each joint's block.
//
// Levers that brought nothing (ns a joint, full invariant joints on a lattice, AVX-512, shared Zen 4; each
// line is of one run, 1e5 joints from memory unless it says otherwise):
//
//   results put from the loops' registers     81 do not fit in 32: compilers spill them to the same cache
//   lanes one by one, 36 numbers each         241 against 141 (another run)
//   block CSR by rows of six                  as fast as 36 in a row; CSR, whose rows are apart: 1.3 times
//   512-bit transposes                        one 512-bit shuffle a cycle against two of 256 bits
//   prefetching blocks 1, 2 or 3 packs ahead  139, 139, 140 against 139; in cache 95, 91, 92 against 92
//   16 or 32 joints between loop and matrix   188 and 195 against 182: they leave L1
//   streaming the blocks of one joint         147 against 142; in cache 110 against 100
//   zeroing a row when it is met              137 (rep stosb), 176 (clzero) against 131
//   adding to a matrix zeroed before          177 against 131
#pragma once

#include "halfway/assemble/scatter.hpp"
#include "halfway/batch/loops/pack.hpp"

#include <utility>

namespace halfway::assemble::detail {

/// `size` doubles wherever they lie, for code of one instruction set.
template <class Isa, int size>
struct Vector {
  typedef double V __attribute__((vector_size(8 * size)));
  typedef double Anywhere __attribute__((vector_size(8 * size), aligned(8), may_alias));
  typedef long long Bits __attribute__((vector_size(8 * size)));

  static HALFWAY_INLINE V load(const double* from) { return *reinterpret_cast<const Anywhere*>(from); }
  static HALFWAY_INLINE void store(double* to, V v) { *reinterpret_cast<Anywhere*>(to) = v; }
};
/// One number as a vector of one.
template <class Isa>
struct Vector<Isa, 1> {
  typedef double V __attribute__((vector_size(8)));
  typedef long long Bits __attribute__((vector_size(8)));
  static HALFWAY_INLINE V load(const double* from) { return V{*from}; }
  static HALFWAY_INLINE void store(double* to, V v) { *to = v[0]; }
};

/// Rows p of lanes 0 .. size: out[l] = the numbers of lane l.
template <class Isa>
HALFWAY_INLINE void transpose(const double* const (&p)[1], typename Vector<Isa, 1>::V (&out)[1]) {
  out[0] = Vector<Isa, 1>::load(p[0]);
}
template <class Isa>
HALFWAY_INLINE void transpose(const double* const (&p)[2], typename Vector<Isa, 2>::V (&out)[2]) {
  const auto a = Vector<Isa, 2>::load(p[0]), b = Vector<Isa, 2>::load(p[1]);
  out[0] = __builtin_shufflevector(a, b, 0, 2), out[1] = __builtin_shufflevector(a, b, 1, 3);
}
template <class Isa>
HALFWAY_INLINE void transpose(const double* const (&p)[4], typename Vector<Isa, 4>::V (&out)[4]) {
  using V2 = Vector<Isa, 2>;
  // Halves are joined as they are loaded: two shuffles of 256 bits a cycle, none across halves.
  const auto halves = [&p](int upper, int lane) HALFWAY_INLINE_LAMBDA {
    return __builtin_shufflevector(V2::load(p[upper] + lane), V2::load(p[upper + 2] + lane), 0, 1, 2, 3);
  };
  for (int l = 0; l < 4; l += 2) {
    const auto a = halves(0, l), b = halves(1, l);
    out[l] = __builtin_shufflevector(a, b, 0, 4, 2, 6),
    out[l + 1] = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  }
}

/// A row of the batch's table, and the sign with which it enters.
struct Source {
  int row;
  bool negative;
};

/// Entry (r, c) of the block by node j (0: a, 1: b) of the loads on node i: of m_b, rows by w_a, w_b; or of
/// f_b, m_a, m_b, rows by x_b, w_a, w_b. By x_a the opposite of by x_b; f_a and m_a of an angular joint are
/// the opposite of f_b and m_b.
constexpr Source tangent_source(int n, int i, int j, int r, int c) {
  if (n == 3) return {9 * j + 3 * r + c, i == 0};
  const int load = r < 3 ? 0 : 27 * (2 - (i == 0));
  const int by = c < 3 ? 0 : 9 * (1 + j);
  return {load + by + 3 * (r % 3) + c % 3, (r < 3 && i == 0) != (c < 3 && j == 0)};
}
/// Number r of the loads on node i.
constexpr Source load_source(int n, int i, int r) {
  if (n == 3) return {r, i == 0};
  return {r < 3 ? r : r + 3 * i, r < 3 && i == 0};
}

/// Where nothing was before, or lane by lane: there or onto what is there.
enum class Put { assign, some };

/// `keep`: all ones, or zero where nothing was there before. A sum, always: -0 comes out as 0 by each road.
template <Put put, class Vec>
HALFWAY_INLINE void put_at(double* to, typename Vec::V v, long long keep) {
  using V = typename Vec::V;
  if constexpr (put == Put::assign) {
    Vec::store(to, v + V{});
  } else {
    using Bits = typename Vec::Bits;
    Vec::store(to, V(Bits(Vec::load(to)) & (Bits{} + keep)) + v);
  }
}

/// Targets of as many lanes as are transposed at a time.
template <int lanes>
struct Lanes {
  double* to[lanes];
  long stride[lanes];
  long long keep[lanes];
};

template <int size>
struct SourceList {
  Source at[size];
  bool negative;
};
/// Numbers first .. first + size, Sources::of(k) each: found when this is compiled, so that no function
/// without a set of instructions in its name is called.
template <class Sources, int first, int size>
inline constexpr SourceList<size> kSources = [] {
  SourceList<size> list{};
  for (int k = 0; k < size; ++k) {
    list.at[k] = Sources::of(first + k);
    list.negative |= list.at[k].negative;
  }
  return list;
}();

/// Those numbers, of all lanes.
template <class Isa, Put put, class Sources, int first, int size, int lanes, class Address>
HALFWAY_INLINE void put_group(const double* rows, long row_length, const Lanes<lanes>& targets,
                              const Address& address) {
  using Vec = Vector<Isa, size>;
  constexpr const SourceList<size>& sources = kSources<Sources, first, size>;
  typename Vec::Bits signs{};
  for (int k = 0; k < size; ++k) signs[k] = sources.at[k].negative ? -0x7fffffffffffffffLL - 1 : 0;
  for (int lane = 0; lane < lanes; lane += size) {
    const double* p[size];
    for (int k = 0; k < size; ++k) p[k] = rows + sources.at[k].row * row_length + lane;
    typename Vec::V numbers[size];
    transpose<Isa>(p, numbers);
    for (int l = 0; l < size; ++l) {
      typename Vec::V v = numbers[l];
      if constexpr (sources.negative) v = typename Vec::V(typename Vec::Bits(v) ^ signs);
      put_at<put, Vec>(address(targets, lane + l), v, targets.keep[lane + l]);
    }
  }
}

/// Numbers first .. last, that follow one another in memory: by fours, then twos, then ones.
template <class Isa, Put put, class Sources, int first, int last, int lanes, class Address>
HALFWAY_INLINE void put_run(const double* rows, long row_length, const Lanes<lanes>& targets,
                            const Address& address, int done = 0) {
  constexpr int left = last - first;
  if constexpr (left > 0) {
    constexpr int size = left >= 4 && lanes == 4 ? 4 : left >= 2 ? 2 : 1;
    put_group<Isa, put, Sources, first, size>(rows, row_length, targets,
                                              [&address, done](const Lanes<lanes>& t, int lane)
                                                  HALFWAY_INLINE_LAMBDA { return address(t, lane) + done; });
    put_run<Isa, put, Sources, first + size, last>(rows, row_length, targets, address, done + size);
  }
}

constexpr int size_of(Shape s) {
  return s == Shape::whole3 || s == Shape::rows3 || s == Shape::columns3 ? 3 : 6;
}
constexpr bool transposed(Shape s) { return s == Shape::columns3 || s == Shape::columns6; }
constexpr bool whole(Shape s) { return s == Shape::whole3 || s == Shape::whole6; }

/// Number k of block (i, j) in the order in which it is stored.
template <Shape shape, int i, int j>
struct BlockSources {
  static constexpr Source of(int k) {
    constexpr int n = size_of(shape);
    return transposed(shape) ? tangent_source(n, i, j, k % n, k / n) : tangent_source(n, i, j, k / n, k % n);
  }
};
template <int n, int i>
struct LoadSources {
  static constexpr Source of(int k) { return load_source(n, i, k); }
};

template <class Isa, Put put, Shape shape, int i, int j, int lanes, int... r>
HALFWAY_INLINE void put_block(const double* rows, long row_length, const Lanes<lanes>& targets,
                              std::integer_sequence<int, r...>) {
  using Sources = BlockSources<shape, i, j>;
  constexpr int n = size_of(shape);
  if constexpr (whole(shape)) {
    put_run<Isa, put, Sources, 0, n * n>(rows, row_length, targets,
                                         [](const Lanes<lanes>& t, int l)
                                             HALFWAY_INLINE_LAMBDA { return t.to[l]; });
  } else {
    (put_run<Isa, put, Sources, n * r, n * r + n>(
         rows, row_length, targets,
         [](const Lanes<lanes>& t, int l) HALFWAY_INLINE_LAMBDA { return t.to[l] + r * t.stride[l]; }),
     ...);
  }
}

/// Block (i, j) of the joints of `lanes` lanes from `lane` on.
template <class Isa, Shape shape, int i, int j, int lanes>
HALFWAY_INLINE void put_blocks(const PackResults& pack, int lane) {
  constexpr int k = 2 * i + j, stored = transposed(shape) ? j : i;
  Lanes<lanes> targets;
  bool some = false, all_first = true;
  for (int l = 0; l < lanes; ++l) {
    const Target& p = pack.targets[lane + l];
    const bool is_there = p.block[k] >= 0, first = (p.first & pack.firsts) >> k & 1;
    some |= is_there, all_first &= first;
    targets.to[l] = is_there ? pack.values + p.block[k] : pack.nowhere;
    targets.stride[l] = is_there ? p.stride[stored] : 0;
    targets.keep[l] = first ? 0 : -1;
  }
  if (!some) return;
  const double* const rows = pack.tangent + lane;
  constexpr auto each_row = std::make_integer_sequence<int, size_of(shape)>{};
  if (all_first)
    put_block<Isa, Put::assign, shape, i, j>(rows, pack.lanes, targets, each_row);
  else
    put_block<Isa, Put::some, shape, i, j>(rows, pack.lanes, targets, each_row);
}

template <class Isa>
inline constexpr int kLanesAtOnce = Isa::kBytes / int(sizeof(double));

template <class Isa, int n, int i, int lanes>
HALFWAY_INLINE void put_loads(const PackResults& pack, int lane) {
  Lanes<lanes> targets;
  for (int l = 0; l < lanes; ++l) {
    const int row = pack.targets[lane + l].row[i];
    targets.to[l] = row >= 0 ? pack.residual + row : pack.nowhere;
    targets.keep[l] = -1;
  }
  put_run<Isa, Put::some, LoadSources<n, i>, 0, n>(pack.loads + lane, pack.lanes, targets,
                                                   [](const Lanes<lanes>& t, int l)
                                                       HALFWAY_INLINE_LAMBDA { return t.to[l]; });
}

template <class Isa, int n>
void put_residual(const PackResults& pack) {
  constexpr int lanes = kLanesAtOnce<Isa>;
  for (int lane = 0; lane < pack.lanes; lane += lanes) {
    put_loads<Isa, n, 0, lanes>(pack, lane), put_loads<Isa, n, 1, lanes>(pack, lane);
  }
}

/// The 3 x 3 matrix from `row` on, of some lanes, becomes its symmetric part.
template <class Isa>
HALFWAY_INLINE void symmetrize(double* tangent, long lanes, int row) {
  using Vec = Vector<Isa, kLanesAtOnce<Isa>>;
  constexpr int pairs[3][2] = {{1, 3}, {2, 6}, {5, 7}};
  for (const auto& [upper, lower] : pairs) {
    double *const x = tangent + (row + upper) * lanes, *const y = tangent + (row + lower) * lanes;
    const typename Vec::V mean = 0.5 * (Vec::load(x) + Vec::load(y));
    Vec::store(x, mean), Vec::store(y, mean);
  }
}

template <class Isa, Shape shape, int... k>
HALFWAY_INLINE void put_in_order(const PackResults& pack, int lane, std::integer_sequence<int, k...>) {
  constexpr bool angular = size_of(shape) == 3;
  constexpr const int(&order)[4] = angular ? kOrder3 : kOrder6;
  const auto symmetric_part = [&] {
    // Of the moment on each node by its own spin.
    symmetrize<Isa>(pack.tangent + lane, pack.lanes, angular ? 0 : 27 + 9);
    symmetrize<Isa>(pack.tangent + lane, pack.lanes, angular ? 9 : 54 + 18);
  };
  const auto put = [&]<int at>(std::integral_constant<int, at>) HALFWAY_INLINE_LAMBDA {
    if (pack.symmetric && at == (angular ? 2 : 0)) symmetric_part();
    put_blocks<Isa, shape, order[at] / 2, order[at] % 2, kLanesAtOnce<Isa>>(pack, lane);
  };
  (put(std::integral_constant<int, k>{}), ...);
}

/// Some lanes with all their blocks (measured: block after block of a whole pack takes 163 ns instead of
/// 137).
template <class Isa, Shape shape>
void put_tangent(const PackResults& pack) {
  for (int lane = 0; lane < pack.lanes; lane += kLanesAtOnce<Isa>) {
    put_in_order<Isa, shape>(pack, lane, std::make_integer_sequence<int, 4>{});
  }
}

/// Four numbers from `first` on of the poses of four lanes.
template <class Isa>
HALFWAY_INLINE void gather_four(const double* const (&poses)[4], double* const (&rows)[4], int lane) {
  typename Vector<Isa, 4>::V out[4];
  transpose<Isa>(poses, out);
  for (int k = 0; k < 4; ++k) Vector<Isa, 4>::store(rows[k] + lane, out[k]);
}

template <class Isa>
HALFWAY_INLINE void gather_node(const NodePose* nodes, const Target* targets, int n, long lanes, double* x,
                                double* q) {
  static_assert(sizeof(NodePose) == 7 * sizeof(double));
  if constexpr (kLanesAtOnce<Isa> == 4) {
    for (int lane = 0; lane < lanes; lane += 4) {
      const double *at_x[4], *at_q[4];
      for (int l = 0; l < 4; ++l) {
        at_x[l] = nodes[targets[lane + l].node[n]].x, at_q[l] = nodes[targets[lane + l].node[n]].q;
      }
      // x and the first of q, which is written again.
      gather_four<Isa>(at_x, {x, x + lanes, x + 2 * lanes, q}, lane);
      gather_four<Isa>(at_q, {q, q + lanes, q + 2 * lanes, q + 3 * lanes}, lane);
    }
  } else {
    for (int lane = 0; lane < lanes; ++lane) {
      const NodePose& pose = nodes[targets[lane].node[n]];
      for (int c = 0; c < 3; ++c) x[c * lanes + lane] = pose.x[c];
      for (int c = 0; c < 4; ++c) q[c * lanes + lane] = pose.q[c];
    }
  }
}

template <class Isa>
void gather(const NodePose* nodes, const Target* targets, long lanes, const PackPoses& to) {
  gather_node<Isa>(nodes, targets, 0, lanes, to.x_a, to.q_a);
  gather_node<Isa>(nodes, targets, 1, lanes, to.x_b, to.q_b);
}

template <class Isa>
constexpr void set_shapes(Scatter::Put (&put)[kShapes]) {
  put[int(Shape::whole3)] = put_tangent<Isa, Shape::whole3>;
  put[int(Shape::whole6)] = put_tangent<Isa, Shape::whole6>;
  put[int(Shape::rows3)] = put_tangent<Isa, Shape::rows3>;
  put[int(Shape::rows6)] = put_tangent<Isa, Shape::rows6>;
  put[int(Shape::columns3)] = put_tangent<Isa, Shape::columns3>;
  put[int(Shape::columns6)] = put_tangent<Isa, Shape::columns6>;
}

template <class Isa>
constexpr Scatter make_scatter() {
  Scatter s{};
  s.gather = gather<Isa>;
  s.residual[0] = put_residual<Isa, 3>, s.residual[1] = put_residual<Isa, 6>;
  set_shapes<Isa>(s.tangent);
  s.lanes = kLanesAtOnce<Isa>;
  return s;
}

}  // namespace halfway::assemble::detail
