// What the units of the instruction sets offer: poses into packs, and packs of results into a matrix.
#pragma once

#include "halfway/assemble/pattern.hpp"

namespace halfway::assemble {

/// Position x (m, global axes) and orientation q (unit quaternion w, x, y, z, node axes -> global axes).
struct NodePose {
  double x[3]{0, 0, 0};
  double q[4]{1, 0, 0, 0};
};

namespace detail {

/// Joints of one pack: component c of lane l at [c * lanes + l].
struct PackPoses {
  double *q_a, *q_b, *x_a, *x_b;
};

/// Where a lane's numbers go, and what of it is the first to come there: bit k, block k.
struct Target : Place {
  int first;
};

/// The results of one pack, rows as in a batch's tables, and where they go.
struct PackResults {
  const double* loads;
  double* tangent;
  long lanes;
  int firsts;             ///< 15: what comes first replaces what is there; 0: all is added
  bool symmetric;         ///< blocks on the diagonal become their symmetric part
  const Target* targets;  ///< one a lane
  double *residual, *values;
  double* nowhere;  ///< 36 numbers: what has no row goes here
};

/// Numbers of a joint's block: 3 x 3 or 6 x 6, one after the other or row by row, of the block or of its
/// transpose.
enum class Shape { whole3, whole6, rows3, rows6, columns3, columns6 };
inline constexpr int kShapes = 6;

struct Scatter {
  using Gather = void (*)(const NodePose*, const Target*, long lanes, const PackPoses&);
  using Put = void (*)(const PackResults&);

  Gather gather;
  Put residual[2];  ///< of 3 loads a node, of 6
  Put tangent[kShapes];
  int lanes;  ///< that are put at a time
};

/// The order in which blocks aa, ab, ba, bb of `lanes` lanes are put: as they lie; of three unknowns those
/// off the diagonal first, since a symmetric part would change them.
inline constexpr int kOrder3[4] = {1, 2, 0, 3}, kOrder6[4] = {0, 1, 2, 3};

extern const Scatter kScatter_Sse2;
#ifdef __x86_64__
extern const Scatter kScatter_Avx2;
#endif

}  // namespace detail
}  // namespace halfway::assemble
