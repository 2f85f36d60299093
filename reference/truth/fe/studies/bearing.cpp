#include "reference/truth/fe/studies/bearing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr double kPi = std::numbers::pi;
/// Half the edge of the square around the pole, as a part of the polar angle of the rim: leaves corners
/// (at 0.64) and sides (0.45) room for graded elements.
constexpr double kSquare = 0.45;
/// Thinnest ring between hole and rim that is meshed, rad.
constexpr double kThinnest = 1e-3;

using Disc = Eigen::Vector2d;

/// Point of the body; rho in [0, 1] from hole to rim, direction unit: components along axes 3 and 1, in this
/// order, so that (inward radius, direction) is right-handed.
Vec3<double> place(const Bearing& b, double t_radial, double rho, const Disc& direction) {
  const double radius = b.outer + t_radial * (b.inner - b.outer);
  const double hole = b.hole_edge(radius);
  const double polar = hole + rho * (b.rim(radius) - hole);
  const double off_axis = radius * std::sin(polar);
  return {off_axis * direction[1], -radius * std::cos(polar), off_axis * direction[0]};
}

/// Of the unit disc, which is the cap without hole.
Vec3<double> place(const Bearing& b, double t_radial, const Disc& at) {
  const double rho = at.norm();
  return place(b, t_radial, rho, rho > 0 ? Disc(at / rho) : Disc(1, 0));
}

/// Counter-clockwise by q quarter turns: exact, so that the patches' nodes coincide.
Disc turned(Disc v, int q) {
  for (int i = 0; i < q; ++i) v = Disc(-v[1], v[0]);
  return v;
}

Disc arc(double t) { return {std::cos(kPi / 2 * (t - 0.5)), std::sin(kPi / 2 * (t - 0.5))}; }

std::vector<Patch> cap(const Bearing& b, const BearingDivisions& n, double grading) {
  std::vector<Patch> patches;
  patches.push_back({{n.radial, n.quarter, n.quarter}, {grading, 1, 1}, {}, [b](const Vec3<double>& t) {
                       return place(b, t[0], Disc(2 * t[1] - 1, 2 * t[2] - 1) * kSquare);
                     }});
  for (int q = 0; q < 4; ++q) {
    patches.push_back({{n.radial, n.meridional, n.quarter},
                       {grading, grading, 1},
                       {false, true, false},
                       [b, q](const Vec3<double>& t) {
                         const Disc side = Disc(1, 2 * t[2] - 1) * kSquare;
                         const Disc at = (1 - t[1]) * side + t[1] * arc(t[2]);
                         // The rim itself to the last digit: it bounds the domain of acos.
                         return t[1] == 1 ? place(b, t[0], 1, turned(arc(t[2]), q))
                                          : place(b, t[0], turned(at, q));
                       }});
  }
  return patches;
}

std::vector<Patch> ring(const Bearing& b, const BearingDivisions& n, double grading) {
  std::vector<Patch> patches;
  for (int q = 0; q < 4; ++q) {
    patches.push_back(
        {{n.radial, n.meridional, n.quarter}, {grading, grading, 1}, {}, [b, q](const Vec3<double>& t) {
           return place(b, t[0], t[1], turned(arc(t[2]), q));
         }});
  }
  return patches;
}

void require(bool holds, const char* field, double value, const std::string& allowed) {
  if (!holds)
    throw std::invalid_argument(fmt::format("bearing: {} is {:.9g}; allowed: {}", field, value, allowed));
}

/// Of the full sphere of this radius, cut and pierced like the bearing: the bearing is the difference of two.
double volume_inside(const Bearing& b, double radius) {
  const double cubed = std::pow(radius, 3);
  double volume = 2 * kPi / 3 * cubed * (1 - std::cos(b.extent));
  if (b.cut == Cut::plane) {
    const double height = radius - (b.outer - b.extent);
    volume = kPi / 3 * height * height * (3 * radius - height);
  }
  if (b.hole == Hole::cone) volume -= 2 * kPi / 3 * cubed * (1 - std::cos(b.width));
  // The cylinder down from the plane of the centre: what the plane cuts off is the same for both spheres.
  if (b.hole == Hole::cylinder)
    volume -= 2 * kPi / 3 * (cubed - std::pow(radius * radius - b.width * b.width, 1.5));
  return volume;
}

}  // namespace

const char* to_string(Cut cut) { return cut == Cut::plane ? "plane" : "cone"; }

const char* to_string(Hole hole) {
  if (hole == Hole::none) return "none";
  return hole == Hole::cone ? "cone" : "cylinder";
}

Cut cut_named(const std::string& name) {
  for (const Cut cut : {Cut::plane, Cut::cone}) {
    if (name == to_string(cut)) return cut;
  }
  throw std::invalid_argument("cut is \"" + name + "\"; allowed: plane, cone");
}

Hole hole_named(const std::string& name) {
  for (const Hole hole : {Hole::none, Hole::cone, Hole::cylinder}) {
    if (name == to_string(hole)) return hole;
  }
  throw std::invalid_argument("hole is \"" + name + "\"; allowed: none, cone, cylinder");
}

double Bearing::rim(double radius) const {
  return cut == Cut::cone ? extent : std::acos((outer - extent) / radius);
}

double Bearing::hole_edge(double radius) const {
  if (hole == Hole::none) return 0;
  return hole == Hole::cone ? width : std::asin(width / radius);
}

double Bearing::volume() const { return volume_inside(*this, outer) - volume_inside(*this, inner); }

void Bearing::check() const {
  require(inner > 0, "inner", inner, "positive");
  require(outer > inner, "outer", outer, fmt::format("larger than inner ({:.9g})", inner));
  if (cut == Cut::plane)
    require(extent > outer - inner && extent < outer + inner, "extent (plane)", extent,
            fmt::format("({:.9g}, {:.9g}), so that it cuts both bowls", outer - inner, outer + inner));
  else
    require(extent > 0 && extent < kPi, "extent (cone)", extent, "(0, pi)");
  if (hole == Hole::none) require(width == 0, "width", width, "0 without hole");
  if (hole == Hole::cone) require(width > 0 && width < kPi, "width (cone)", width, "(0, pi)");
  if (hole == Hole::cylinder)
    require(width > 0 && width < inner, "width (cylinder)", width, fmt::format("(0, {:.9g})", inner));
  for (const double radius : {inner, outer})
    require(rim(radius) > hole_edge(radius) + kThinnest, "extent", extent,
            fmt::format("a rim (on radius {:.9g} at {:.9g} rad) outside the hole (there at {:.9g} rad)",
                        radius, rim(radius), hole_edge(radius)));
}

BearingDivisions bearing_divisions(const Bearing& bearing, int level) {
  return {level, bearing.hole == Hole::none ? level : 2 * level, std::max(2, (level + 1) / 2)};
}

Mesh bearing_mesh(ElementKind element, const Bearing& bearing, const BearingDivisions& divisions,
                  double grading) {
  bearing.check();
  return structured(element, bearing.hole != Hole::none ? ring(bearing, divisions, grading)
                                                        : cap(bearing, divisions, grading));
}

}  // namespace halfway::reference::fe
