// CalculiX (ccx), the independent program: driven through its input files, read through its tables.
//
// Nothing of it is linked or copied: it is started as a process of one thread in a temporary folder of
// its own, which is removed again. It prints seven digits: no figure below is finer than 5e-7 relative.
#pragma once

#include "reference/truth/fe/statics.hpp"

#include <string>

namespace halfway::reference::fe {

/// Whether ccx is on PATH: without it the functions below throw.
bool calculix_available();
/// As ccx states it ("2.20"). Throws std::runtime_error without ccx.
std::string calculix_version();

/// What the processes used.
struct CalculixCost {
  double cpu = 0;  ///< user and system, s
  int runs = 0;
};

struct CalculixLinear {
  Mat6 compliance;    ///< (d, theta) per (f, m) at the reference point; not made symmetric
  CalculixCost cost;  ///< of one run that factorizes six times, once for each unit load
};

struct CalculixPose {
  Vec3<double> d;      ///< of the reference point, m
  Vec3<double> theta;  ///< rotation vector of the face, rad
  CalculixCost cost;   ///< of all runs: one without a moment, about four with one
};

/// hex20 becomes C3D20R, hex20_full C3D20. The reference point (m) need not lie on the face. All throw
/// std::invalid_argument for another element or an empty face and std::runtime_error, with ccx's last lines,
/// where ccx is missing, fails, or prints anything but finite numbers.
CalculixLinear calculix_linear(const Mesh& mesh, const Material& material,
                               const Vec3<double>& reference_point);

/// One run with force f (N) and ccx's own moment m (N m), which works on the rotation vector. Large strains.
CalculixPose calculix_as_coded(const Mesh& mesh, const Material& material,
                               const Vec3<double>& reference_point, const Vec3<double>& f,
                               const Vec3<double>& m);

/// Large strains under Law::st_venant, which is what *ELASTIC with NLGEOM means in ccx; the load as in
/// Statics::solve. ccx's moment works on the rotation vector, not on the spin: Gamma(theta)^T m is
/// applied and found by iteration.
CalculixPose calculix_nonlinear(const Mesh& mesh, const Material& material,
                                const Vec3<double>& reference_point, const Load& load);

}  // namespace halfway::reference::fe
