// Elastomeric bearing: what lies between two concentric rigid spherical bowls, cut to a cap or a ring.
#pragma once

#include "reference/truth/fe/mesh.hpp"

namespace halfway::reference::fe {

/// What ends the bowl: a plane normal to the axis, or a cone from the centre (rim normal to both bowls).
enum class Cut { plane, cone };
/// Around the axis: a cone from the centre, or a cylinder.
enum class Hole { none, cone, cylinder };

const char* to_string(Cut cut);
const char* to_string(Hole hole);
/// Both throw std::invalid_argument naming the value and what is allowed.
Cut cut_named(const std::string& name);
Hole hole_named(const std::string& name);

/// Axis 2 is the axis of symmetry, the centre of the spheres the origin; the bowl opens toward +2, so that
/// the outer pole is (0, -outer, 0). The outer bowl is clamped (node a), the inner one moves (node b).
struct Bearing {
  double inner;  ///< radius of the moving bowl, m
  double outer;  ///< radius of the clamped bowl, m
  Cut cut;
  double extent;  ///< plane: its distance from the outer pole, m; cone: its angle from the axis, rad
  Hole hole = Hole::none;
  double width = 0;  ///< of the hole; cone: its angle from the axis, rad; cylinder: its radius, m

  /// Angles from the axis at which the sphere of this radius (m) meets the rim and the hole (0 without), rad.
  double rim(double radius) const;
  double hole_edge(double radius) const;
  /// m^3, in closed form.
  double volume() const;
  /// Throws std::invalid_argument naming the field, its value and what is allowed.
  void check() const;
};

/// Without hole: a square of quarter x quarter elements around the pole and four patches of
/// meridional x quarter around it. With hole: four patches. Each radial elements thick.
struct BearingDivisions {
  int radial;      ///< bowl to bowl
  int meridional;  ///< square (or hole) to rim
  int quarter;     ///< along a quarter of the circumference
};

/// In proportion to the level, which is the number between the bowls; between hole and rim twice as many, as
/// both ends are singular: fewer there is what first limits the second-order couplings.
BearingDivisions bearing_divisions(const Bearing& bearing, int level);

/// grading: exponent toward both bowls and the free rims (Patch::grading). A multiple of four elements
/// around makes the compliance isotropic normal to axis 2, whatever the mesh. Throws as Bearing::check.
Mesh bearing_mesh(ElementKind element, const Bearing& bearing, const BearingDivisions& divisions,
                  double grading);

}  // namespace halfway::reference::fe
