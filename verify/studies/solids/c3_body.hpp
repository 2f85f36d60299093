// The body of C3 beside the joints that stand for it: kept 3D paths, extrapolated, and each formulation's way
// from them. Judged by fe_buckling.cpp, drawn by the report.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/truth/fe/richardson.hpp"
#include "reference/truth/fe/studies/block_path.hpp"
#include "verify/check.hpp"

namespace halfway::verify {

/// All kept paths. Throws std::runtime_error saying how to make them.
const std::vector<reference::fe::BlockPath>& block_paths();

/// Those of one law and element on one kind of mesh, ascending levels.
std::vector<const reference::fe::BlockPath*> block_family(reference::fe::SolidLaw law,
                                                          reference::fe::ElementKind element, double grading);

/// The finest even mesh of a law.
const reference::fe::BlockPath& finest_block(reference::fe::SolidLaw law);

struct BodyPoint {
  double moment;                                 ///< N m, fixed in direction
  std::array<reference::fe::Estimate, 3> theta;  ///< of the loaded face, rad, extrapolated over three meshes
  double determinant;  ///< of the finest mesh's tangent over that of the first point
  double lowest;       ///< the smallest of its eigenvalues, N m/rad

  double phi() const;    ///< |theta|, rad
  double error() const;  ///< |error bars| / |theta|
};

/// Up to the last moment that all three meshes reach, and while the error bars are below 5 % of |theta|.
/// Throws std::runtime_error where no point is left.
std::vector<BodyPoint> body_curve(reference::fe::SolidLaw law, reference::fe::ElementKind element);

/// How far a joint is from the body.
struct Departure {
  double moment;       ///< N m
  Vec3<double> joint;  ///< rotation of the joint, rad
  double theta;        ///< |theta_joint - theta_body| / |theta_body|
  double theta_2;      ///< |theta_2 of the joint / that of the body - 1|
};

/// The joint of C3 with the compliance of the law's finest mesh, so that its discretisation is in neither
/// side, and from that mesh, at its moments. Ends where either path ends. Once in a process.
const std::vector<Departure>& departures(const reference::Entry& entry, reference::fe::SolidLaw law);

/// The moment (N m) at which `what` first exceeds `limit`, by linear interpolation; the last one where it
/// never does; NaN without a point or where a departure is none.
double moment_within(const std::vector<Departure>& list, double Departure::*what, double limit);

}  // namespace halfway::verify
