// Geometries of the elastomeric bearing that have the compliances of Table 4: the paper prints no dimension.
#pragma once

#include "reference/truth/fe/solid.hpp"
#include "reference/truth/fe/studies/bearing.hpp"

#include <array>
#include <string>
#include <vector>

namespace halfway::reference::fe {

/// What Table 4 and the text of section 4.2.2 say.
inline constexpr Material kBearingMaterial = {1e5, 0.4};
enum class Datum { linear_axial, linear_lateral, angular_lateral, angular_axial, joint_point };
inline constexpr std::array<const char*, 5> kDatumNames = {"linear 2", "linear 1, 3", "angular 1, 3",
                                                           "angular 2", "joint point"};
/// In the order of Datum: m/N, m/N, rad/(N m), rad/(N m), and the joint point's distance from the outer pole,
/// m.
using BearingData = std::array<double, 5>;
inline constexpr BearingData kTable4 = {3.4801e-8, 4.9357e-8, 6.3072e-10, 5.7187e-10, 14.7488};

/// The same five numbers of a meshed bearing, decoupled where forces and moments part.
struct BearingAnswer {
  BearingData data;
  int unknowns;
};
BearingAnswer bearing_data(const Bearing& bearing, ElementKind element, const BearingDivisions& divisions,
                           double grading);

struct BearingFit {
  Bearing bearing;
  BearingData data;      ///< of the fitted geometry
  BearingData residual;  ///< data / Table 4 - 1
  double rms;            ///< of the residuals that were fitted
  double largest;        ///< of them
  int unknowns;          ///< of the mesh
  int iterations;
  bool converged;
  std::string message;  ///< GSL's own words
};

/// The mesh, whether the joint point counts or only the compliances do, and whether the hole's width is free.
struct FitPlan {
  ElementKind element = ElementKind::hex20;
  int level = 4;  ///< 1.5k to 2.7k unknowns, data within 3e-3 of the finest meshes'
  double grading = 3;
  bool joint_point = true;
  bool width = false;  ///< of the hole: fitted as well; else that of the start
};

/// Radii, extent and, if the plan says so, the hole's width in the sense of least squares of the relative
/// residuals (Levenberg-Marquardt, GSL). `start` is where the search begins and gives cut and hole. Never
/// throws for what the search meets: `converged` and `message` say it. Throws std::invalid_argument as
/// Bearing::check for `start`, and when the hole is to be fitted and `start` has none.
BearingFit fit_bearing(const Bearing& start, const FitPlan& plan);

/// One fit per width of the hole, each from the one before: with the hole free there are nearly as many
/// unknowns as data, and the spread of what is admissible is seen along it. Stops at the first that does not
/// converge.
std::vector<BearingFit> scan_holes(const Bearing& start, const std::vector<double>& widths,
                                   const FitPlan& plan);

/// A geometry is admissible when no fitted datum is further off than this.
inline constexpr double kAdmissible = 0.02;

}  // namespace halfway::reference::fe
