// Maps of plain Newton on the block of c3_buckling: which single load step, and which start, converge
// to what. An equilibrium has no unique solution once loads are large.
#pragma once

#include "verify/studies/limits/newton.hpp"

#include <optional>
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

/// Moments up to 1800 N m in the plane of C3, and responses up to 3 rad in that of its soft axis.
/// @param resolution  angles, and steps, of each grid
std::vector<LoadGrid> load_grids(int resolution);

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

/// The block's response to a grid, for one formulation.
class BasinMaps {
 public:
  BasinMaps(const LoadGrid& grid, const Entry& entry);
  LoadMap map(NewtonTangent tangent) const;
  /// How many of the grid's states the continuous branch does not reach.
  int unreached() const;

 private:
  using State = std::optional<Mat3<double>>;
  Vec3<double> moment(double angle, double magnitude) const;
  Scene loaded(double angle, double magnitude) const;
  BasinCell cell(double angle, double magnitude, const State& branch, NewtonTangent tangent) const;
  bool is_safe(double angle, double magnitude, NewtonTangent tangent) const;
  double safe_step(const std::vector<BasinCell>& cells, NewtonTangent tangent) const;

  LoadGrid grid_;
  const Entry& entry_;
  Scene block_;
  std::vector<State> branches_;
};

/// What starts in the plane of the rotation components 1 and 2, each from -pi to pi, converge to.
struct StartMap {
  struct Equilibrium {
    Vec3<double> theta;  ///< rotation vector of node b, rad
    int cells = 0;       ///< that converge to it
  };
  int resolution = 0;
  std::vector<int> cells;               ///< index of the equilibrium, or -1; by component 1, then 2
  std::vector<Equilibrium> equilibria;  ///< the continuous branch first, where there is one
  bool has_branch = false;
};

/// @param moment  N m, along C3's load
StartMap start_map(const Entry& entry, NewtonTangent tangent, double moment, int resolution);

}  // namespace halfway::reference
