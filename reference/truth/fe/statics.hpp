// Equilibrium of a solid under a load on its rigid face, and its linear characterisation.
#pragma once

#include "reference/truth/fe/cholesky.hpp"
#include "reference/truth/fe/solid.hpp"

#include <optional>
#include <string>

namespace halfway::reference::fe {

/// Force at the reference point (N) and moment (N m), of fixed global direction; a follower moment turns
/// with the face instead.
struct Load {
  Vec3<double> f = Vec3<double>::Zero();
  Vec3<double> m = Vec3<double>::Zero();
  bool follower = false;
};

struct Equilibrium {
  State state;
  double factor = 1;  ///< of the load
  bool converged = false;
  int iterations = 0;
  double update = 0;           ///< last relative change
  std::string reason;          ///< why not converged
  Vec3<double> theta() const;  ///< log(R), rad
};

/// The interior by CHOLMOD, the face by a dense 6x6. One symbolic analysis per mesh.
class Statics {
 public:
  explicit Statics(const Solid& solid) : solid_(solid) {}

  const Solid& solid() const { return solid_; }
  /// Newton from `start` until the update no longer shrinks; refuses a result coarser than 1e-8. The tangent
  /// is factored again only where the last one gains less than a digit per iteration.
  Equilibrium solve(SolidLaw law, const Load& load, const State& start);
  /// The same where the face's theta_1 is given (rad, in (-pi, pi)) and the factor of the load is sought: it
  /// passes limits of the load. start: the state and the factor of the load that Newton begins at.
  Equilibrium turn(SolidLaw law, const Load& load, double theta_1, const Equilibrium& start);

  /// What the load on the face has to change by per (dx, dw) of the face, the interior in equilibrium and the
  /// load's own change taken off: N/m, N, N m/rad. Singular where the load is critical; none where the
  /// interior's stiffness is not positive definite.
  std::optional<Mat6> condensed(SolidLaw law, const Load& load, const State& state);

  /// The six first-order fields: the face's compliance and every node's displacement for a unit load each.
  struct Linear {
    Mat6 compliance;                    ///< (d, theta) per (f, m) at the reference point
    std::array<Eigen::Matrix3Xd, 6> u;  ///< m per N or per N m
  };
  /// Throws std::domain_error where the interior's stiffness is not positive definite.
  Linear linear();

 private:
  Equilibrium iterate(SolidLaw law, const Load& load, const Equilibrium& start,
                      std::optional<double> theta_1);

  const Solid& solid_;
  Cholesky cholesky_;
};

}  // namespace halfway::reference::fe
