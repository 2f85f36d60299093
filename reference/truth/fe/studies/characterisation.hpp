// A body's compliance and second-order couplings over elements and meshes.
#pragma once

#include "reference/truth/fe/richardson.hpp"
#include "reference/truth/fe/second_order.hpp"
#include "reference/truth/fe/studies/bodies.hpp"

namespace halfway::reference::fe {

/// One mesh.
struct MeshRun {
  ElementKind element;
  int level;
  int unknowns;
  double seconds;      ///< CPU, linear analysis and couplings of all laws
  SecondOrder result;  ///< at the joint point
};

struct Characterisation {
  std::string body;
  Vec3<double> joint_point;  ///< from the face's centre, m
  std::vector<MeshRun> runs;
};

/// Which meshes a characterisation takes.
struct MeshPlan {
  ElementKind element;
  std::vector<int> levels;  ///< ascending
};

/// The joint point that decouples forces from moments best (nearest skew part of A), from a coarse mesh
/// of a body along axis 1, from the face's centre, rounded to 1e-4 of the body's length so that it is the
/// same for every mesh.
Vec3<double> joint_point(const Body& body);

MeshRun characterise(const Body& body, const Vec3<double>& joint_point, ElementKind element, int level);

/// Extrapolates any number of a mesh's result over the meshes of one element.
using Figure = std::function<double(const SecondOrder&)>;
Estimate converged(const Characterisation& c, ElementKind element, const Figure& figure);

/// The xi at which a frame-xi law has the coupling of the solid: theta_k under the moments i and j
/// (i, j, k different), from theta_k = xi F_k (F_i - F_j) m_i m_j with k = i + 2 (cyclic).
double xi_of_moments(const SecondOrder& s, SolidLaw law, int i, int j);
/// The same under forces at the joint point: theta = xi F_psi (F_u f) x f.
double xi_of_forces(const SecondOrder& s, SolidLaw law, int i, int j);

void to_json(nlohmann::json& json, const Characterisation& c);
void from_json(const nlohmann::json& json, Characterisation& c);

}  // namespace halfway::reference::fe
