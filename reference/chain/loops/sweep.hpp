// What the units of the instruction sets see of a chain: plain pointers and numbers. No standard header.
//
// A link's frame lies at its rear end, at the joint towards the root: of the next joint frame a is its front
// end, an arc further. Unknowns of a link are the displacement of that point and the spin, both in global
// axes.
#pragma once

#include "halfway/batch/loops/job.hpp"

namespace halfway::reference::chain::detail {

using halfway::batch::Columns;

/// Joints that are evaluated and eliminated at a time; a multiple of every pack.
inline constexpr int kChunk = 8;
/// Of one link's increment: dx, w and what fills up a row.
inline constexpr int kIncrement = 8;
/// Of one link's factors: rows of [X | y], u_j = y - X u_(j+1).
inline constexpr int kFactors = 42;
/// Of one link's kept inverse: rows of [S^-1 | S^-1 A].
inline constexpr int kKept = 72;

struct Links {
  long count = 0;     ///< N; link 0 is clamped, joint j leads from link j-1 to link j
  double arm[3]{};    ///< from a link's rear end to its front end, link axes, m
  double turn[4]{};   ///< the front end's frame in link axes, quaternion w, x, y, z
  Columns<double> q;  ///< 4 rows: quaternions of the links 0 ... N, padded to whole chunks and one more link
  Columns<double> d;  ///< 3 rows: d of the joints in half-way axes, m; joint j at column j
  double* increment = nullptr;  ///< kIncrement numbers a link, links 0 ... N
  double* factors = nullptr;    ///< kFactors numbers a link
  double* kept = nullptr;       ///< kKept numbers a link; nullptr: not kept
};

/// Which numbers of a tangent a loop writes (Batch::compressed_rows): all 81, or those from which balance and
/// objectivity tell the rest, 33, or 21 where there is a potential.
enum class Kept { all, general, conservative };

/// Of joints that see a rod's strains.
struct Rod {
  double length = 0;      ///< of a link, m; 0: they see d
  double stiffness[6]{};  ///< diagonal, translation first
};

/// How joints are evaluated.
struct Evaluation {
  batch::detail::Job<double> job{};                   ///< law and parameters; tables are the unit's
  batch::detail::Evaluate<double> loads = nullptr;    ///< loads alone
  batch::detail::Evaluate<double> tangent = nullptr;  ///< loads and tangent
  Kept kept = Kept::all;                              ///< of the tangent; all where tip_first
  bool foreign = false;  ///< the tangent is another formulation's: loads are evaluated after it
  bool symmetrised = false;
  bool tip_first = false;
  Rod rod{};
};

/// What a sweep from the root to the tip leaves.
struct AtTip {
  double S[36]{}, residual[6]{};  ///< of the last link, all others eliminated, without loads on it
  double x[3]{};                  ///< from the first link's rear end to the last one's, global axes, m
  double growth = 0;              ///< sum of squares of the factors X
  double imbalance[6]{};          ///< largest |sum of loads| on a link, by direction
  double largest[6]{};            ///< largest |load| of a joint, by direction
};

/// Each moves the links by `scale` of the increments first.
struct Sweeps {
  /// The quickest: not symmetrised, nothing kept.
  void (*eliminate)(const Links&, const Evaluation&, double scale, AtTip&);
  void (*eliminate_any)(const Links&, const Evaluation&, double scale, AtTip&);
  /// With pivots within blocks.
  void (*eliminate_pivoted)(const Links&, const Evaluation&, double scale, AtTip&);
  /// With the kept inverses of an earlier one; S is not set.
  void (*reduce)(const Links&, const Evaluation&, double scale, AtTip&);
  /// imbalance and largest alone.
  void (*balance)(const Links&, const Evaluation&, double scale, AtTip&);
  /// Increments of all links from the last one's; largest |entry| of each direction.
  void (*substitute)(const Links&, const double (&last)[6], double (&largest)[6]);
};

}  // namespace halfway::reference::chain::detail
