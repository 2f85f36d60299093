// Maps of plain Newton on the block of c3_buckling: which single load step, and which start, converge
// to what. An equilibrium has no unique solution once loads are large.
#pragma once

#include "verify/studies/newton/newton.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

enum class BasinEnd {
  continuous_branch,  ///< the state that adaptive load steps (Path) reach from rest
  other_equilibrium,  ///< in equilibrium to rounding, more than kSameState from there; or no branch goes so
                      ///< far
  did_not_converge,   ///< kMostBasinIterations were not enough
  singular_tangent,
  not_finite
};
inline constexpr double kSameState = 1e-6;  ///< rad; converged states agree to 1e-12, others differ by 1e-2
inline constexpr int kMostBasinIterations = 50;

/// A fixed moment in a plane of two axes of the block. The stiffness is diagonal, so a quarter of the
/// plane stands for all of it.
struct LoadGrid {
  std::string name;
  std::array<int, 2> axes{};  ///< 0, 1, 2
  bool is_response = false;   ///< magnitude: the angle of the linear response, rad; else the moment, N m
  double largest = 0;         ///< magnitude; the grid has steps of them, 0 left out
  int steps = 0;
  int angles = 0;  ///< directions from the first axis (0) to the second (pi/2), both included

  double angle(int i) const;
  double magnitude(int k) const { return largest * (k + 1) / steps; }
};

/// Moments up to 1800 N m in the plane of C3, and responses up to 3 rad in that of its soft axis. 31 steps in
/// 31 directions: with 13 a third of the safe steps come out too large.
const std::vector<LoadGrid>& load_grids();

struct BasinCell {
  BasinEnd end = BasinEnd::did_not_converge;
  int iterations = 0;
  bool has_wrapped = false;  ///< a step was longer than pi
};

/// By angle, then magnitude.
struct LoadMap {
  std::vector<BasinCell> cells;
  double share = 0;      ///< of cells on the continuous branch
  double safe_step = 0;  ///< every smaller magnitude of the grid, bisected to 1/64 step, is on the branch
};

/// The block's response to one of load_grids(). Computed once.
const LoadMap& load_map(const Entry& entry, const LoadGrid& grid, NewtonTangent tangent);

/// What starts in the plane of the rotation components 1 and 2, each from -pi to pi, converge to.
struct StartMap {
  struct Equilibrium {
    Vec3<double> theta;  ///< rotation vector of node b, rad
    int cells = 0;       ///< that converge to it
  };
  double moment = 0;  ///< N m
  int resolution = 0;
  std::vector<int> cells;               ///< index of the equilibrium, or -1; by component 1, then 2
  std::vector<Equilibrium> equilibria;  ///< the continuous branch first, where there is one
  bool has_branch = false;
};

/// N m, along C3's load: beyond the critical moment of most laws of the block.
inline constexpr double kStartMoment = 1000;

/// With the analytic tangent, under a moment (N m); 41 starts each way. Computed once.
const StartMap& start_map(const Entry& entry, double moment);

}  // namespace halfway::reference
