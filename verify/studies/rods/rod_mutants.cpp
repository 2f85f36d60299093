// Wrong twins of what is derived of rods.
#include "reference/truth/closed_forms.hpp"
#include "reference/truth/rod/closed/loads.hpp"
#include "reference/truth/rod/closed/third_order.hpp"
#include "verify/oracle/mutants/verdicts.hpp"
#include "verify/studies/rods/rod_access.hpp"

namespace halfway::verify {
namespace {

namespace rod = reference::rod;
using V = Vec3<double>;

/// The half-way moment of a rod less a law of third order, over what is of third order. Without its last term
/// the law is that of the potential of the rotation vector.
Measurement third_order_defect(bool has_stiffness_term) {
  const Mat3<double> K = V(1, 2, 3).asDiagonal();
  const V m(0.02, -0.02, 0.05);
  const V theta = rotation_of(rod::end_rotation(K, m)), w = K * theta;
  const V mbar = reference::closed::rotation(V(-theta / 2)) * m;
  const V law = has_stiffness_term ? rod::closed::third_order_moment(K, theta)
                                   : V(w - theta.cross(theta.cross(w)) / 24);
  return {(mbar - law).norm() / (m.norm() * theta.squaredNorm()), "stiffness 1, 2, 3"};
}

/// xi that the rod's own second order shows, about its second component, less that of the law.
Measurement taper_defect(bool has_one_xi) {
  rod::Rod r;
  r.taper = [](double s) {
    const double u = 1 - s / 3;
    return rod::Section{{1 / u, 2 / (u * u), 0.4 / (u * u * u)}};
  };
  constexpr double kSize = 1e-3;
  const V m(kSize, 0, kSize), Cb(3 * std::log(1.5), 3, 0.75);
  const double second =
      (rotation_of(tip_under_moment(r, m).R)[1] + rotation_of(tip_under_moment(r, -m).R)[1]) / 2;
  const double by_rod = second / (Cb[1] * (Cb[0] - Cb[2]) * kSize * kSize);
  const double law = has_one_xi ? 0.5 : rod::closed::xi_of_taper(r.taper, r.length)[1];
  return {std::abs(by_rod - law), fmt::format("xi = {:.6g}", by_rod)};
}

/// A cantilever under a dead force on its tip bends before it buckles; the factor of the strip between forks
/// does not tell by how much that helps.
Measurement tip_force_defect(bool by_fork_factor) {
  const rod::Rod r = straight_rod(1, {0.65, 1, 10});
  const double found = critical_tip_force(r, 6).load;
  const double factor = 1 / std::sqrt((1 - 1 / 10.) * (1 - 0.65 / 10));
  const double kept = std::stod(kept_rods().at("tip_force").at("rows").at(1).at(1).get<std::string>());
  const double law = by_fork_factor ? factor * rod::closed::tip_force(1, 0.65, 1) : kept;
  return {std::abs(found / law - 1), fmt::format("force {:.6g}", found)};
}

}  // namespace

void rod_mutants(Checks& checks) {
  add_mutant(checks, "third_order_without_stiffness_term", "rods/law/third_order", 1e-4, [] {
    return std::pair{third_order_defect(false), third_order_defect(true)};
  });
  add_mutant(checks, "one_xi_for_a_taper", "rods/law/taper_xi", 1e-4, [] {
    return std::pair{taper_defect(true), taper_defect(false)};
  });
  add_mutant(checks, "fork_factor_for_tip_force", "rods/critical/tip_force", 1e-9, [] {
    return std::pair{tip_force_defect(true), tip_force_defect(false)};
  });
}

}  // namespace halfway::verify
