// The block of Table 2 under a moment of fixed direction: up to what stops it, and past its limit.
#pragma once

#include "reference/truth/fe/statics.hpp"
#include "reference/truth/fe/studies/bodies.hpp"

namespace halfway::reference::fe {

/// Divisions along axes 1, 2, 3: level, 3 level, level. grading as of tapered_block: 1 is even.
struct BlockMesh {
  SolidLaw law;
  ElementKind element;
  int level;
  double grading;
};

struct BlockPoint {
  double moment;           ///< N m
  Vec3<double> theta;      ///< of the loaded face, rad
  Vec3<double> d;          ///< of its middle, m
  double determinant;      ///< of the tangent K of the face's rotation, no force on it, (N m/rad)^3
  Vec3<double> stiffness;  ///< real parts of K's eigenvalues, ascending, N m/rad
};

struct BlockPath {
  BlockMesh mesh{};
  int unknowns = 0;
  double seconds = 0;              ///< CPU
  Vec3<double> compliance;         ///< diagonal, of the unloaded mesh's rotations, rad/(N m)
  std::vector<BlockPoint> rising;  ///< at given moments, and the last one reached
  std::string rising_end;          ///< "reached" or why it ended
  std::vector<BlockPoint> turned;  ///< from there on at given theta_1
  std::string turned_end;
};

/// Moments at which every path has its points, N m: 2.5, for what small loads do, then every 25 up to 1800.
std::vector<double> block_moments();

Mesh block_mesh(const BlockMesh& mesh);

/// direction: a unit vector.
BlockPath follow_block(const BlockMesh& mesh, const Vec3<double>& direction);

/// The largest moment of a path, N m, and theta_1 (rad) there, by the parabola through its three highest
/// neighbours; nothing where the path does not pass a maximum; NaN where a moment is.
struct BlockLimit {
  double moment, theta_1;
};
std::optional<BlockLimit> limit_of(const BlockPath& path);

void to_json(nlohmann::json& json, const BlockPath& path);
void from_json(const nlohmann::json& json, BlockPath& path);

}  // namespace halfway::reference::fe
