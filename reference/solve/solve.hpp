// Scenes solved: the curve of each formulation, with an honest outcome.
#pragma once

#include "reference/scene/joint/names.hpp"
#include "reference/scene/scene.hpp"
#include "reference/solve/buckling.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace halfway::reference {

/// The path of one formulation through one scene.
struct Curve {
  std::string scene;
  std::string formulation;
  double xi = 0.5;
  std::vector<std::string> columns;       ///< "factor" or "time", then the scene's outputs
  std::vector<std::vector<double>> rows;  ///< of equilibria, the last where the path stopped; NaN never
  std::vector<double> errors;             ///< estimated, of each row's worst output, rad or m
  bool converged = false;                 ///< up to the scene's last load factor
  bool is_inaccurate = false;             ///< up to there, but beyond what double precision resolves
  std::string outcome;                    ///< for people: "converged" or why not, and where
  std::string cause{};                    ///< of an early end, in words, without the place; else empty
  int iterations = 0;                     ///< Newton iterations of the whole path
  double residual = 0;                    ///< at the last point, relative to the load
  std::optional<Buckling> critical{};     ///< about Scene::critical_axis, see critical_state
  /// At each row the poses of the loaded node, node a at the identity; of a mechanism's bodies, global axes.
  std::vector<std::vector<Pose<double>>> poses{};
  /// Of a mechanism, at each row and joint: what it exerts on the bodies, (f_a, m_a, f_b, m_b), moments about
  /// the nodes, global axes, N and N m.
  std::vector<std::vector<Eigen::Matrix<double, 12, 1>>> reactions{};
  /// Of a motion, at each row, J: kinetic, strain, dissipated by dampers, work of the loads.
  std::vector<std::array<double, 4>> energies{};
};

/// A formulation and its xi, where it has one; no entry stands for kLinearized.
struct Choice {
  const Entry* entry;
  double xi;
};

/// Of the formulations that a scene of either sort asks for those that `accepts` lets pass, in the catalog's
/// order, one with a free xi at each of the scene's.
std::vector<Choice> choices(const SceneHead& scene, const std::function<bool(const Entry&)>& accepts);

/// What a scene of a joint asks for: the linear analysis last; formulations that refuse its law
/// (accepts_law), or need a length that it does not say, are left out.
std::vector<Choice> choices(const Scene& scene);

/// Who is told of each point of a path as it is reached: (points reached, points asked for).
using Told = std::function<void(int done, int total)>;

/// Solves `scene` with one choice. Never throws for a path that ends early: the outcome says so.
Curve solve_scene(const Scene& scene, const Choice& choice, const Told& told = {});

/// The first critical state of a choice about the scene's critical_axis; nothing where the scene does not
/// ask, and where there is none below pi or none where its energy is convex.
std::optional<Buckling> critical_state(const Scene& scene, const Choice& choice);

/// The loaded node of a scene without load, node a at the identity.
Pose<double> rest_pose(const Scene& scene);

/// The curve of a choice before it is solved: names and columns, no rows.
Curve empty_curve(const SceneHead& scene, const Choice& choice);

}  // namespace halfway::reference
