// A joint as another program's file says it, in our terms, and from which line each number came.
#pragma once

#include "halfway/joint.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace halfway::imports {

/// What stands in the file: KEY = TEXT, at a line (from 1).
struct Source {
  int line = 1;
  std::string key{}, text{};
};

/// Of one strain: a stiffness, or where there is a table its rows.
struct AxisLaw {
  double stiffness = 0;          ///< N/m or N m/rad
  std::vector<double> x{}, y{};  ///< m or rad, ascending; N or N m
};

/// Points that Akima's interpolation needs; fewer are joined by straight lines.
inline constexpr std::size_t kFewestAkima = 5;

struct ImportedJoint {
  std::string name{};         ///< of the bushing in its file
  std::string program{};      ///< whose file it is
  int line = 1;               ///< where it begins
  std::string formulation{};  ///< what its program computes; empty: the file holds no law of rotation
  Kind kind = Kind::linear_angular;
  Eigen::MatrixXd K{};          ///< n x n, translation first; SI, rad
  std::vector<AxisLaw> axes{};  ///< n, instead of K where there are tables
  Eigen::VectorXd preload{};    ///< n stresses at no strain, or none
  JointEnd<double> a{}, b{};
  std::vector<Source> law_from{}, preload_from{}, a_from{}, b_from{};
  std::vector<std::string> lost{};   ///< "WHAT (line N): why"
  std::vector<std::string> notes{};  ///< what was assumed
};

/// Strains of a kind.
inline int strains_of(Kind kind) { return kind == Kind::linear_angular ? 6 : 3; }

/// What the command line says where a file does not.
struct ImportOptions {
  std::string units{};       ///< "m" or "mm" of a file without units; empty: not said
  std::string joint_type{};  ///< of a Chrono bushing whose file names none
};

}  // namespace halfway::imports
