// Mechanisms whose joints are far stiffer along some strains than along others: how accurate they are in
// double, against 50 digits, and what they say of it.
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::MechanismScene;
namespace mechanism = reference::mechanism;

/// Two bodies, one after the other, on coupled joints in turned frames, stiff against translations: bushings
/// that are nearly pins. Everything is loaded as the rotations can carry.
MechanismScene stiffened(const Entry& entry, double ratio) {
  MechanismScene out = generic_loop(entry, false);
  out.joints.pop_back();
  out.bodies[2].pose.reset();
  for (auto& joint : out.joints) {
    auto& K = std::get<reference::LinearSpec>(joint.spec.law).matrix;
    const double root = std::sqrt(ratio);  // keeps the matrix definite
    K.topRows(3) *= root, K.leftCols(3) *= root;
  }
  for (auto& load : out.loads) load.value *= 0.3;
  return out;
}

/// Of the bodies' nodes: largest distance from those of 50 digits, m and rad, and that over what is told.
struct Accuracy {
  double error = std::nan(""), over_told = std::nan("");
  std::string outcome{};
};

Accuracy accuracy(const Entry& entry, double ratio) {
  const MechanismScene scene = stiffened(entry, ratio);
  const mechanism::Model<double> model(scene, entry, entry.probe_xi);
  const mechanism::Model<Real50> exact_model(scene, entry, entry.probe_xi);
  mechanism::Follower<double> path(model);
  mechanism::Follower<Real50> exact(exact_model);
  const Status status = path.advance(1).status;
  // Below 1e-13 of a body's largest stiffness, a lever's among them, a direction counts as free, also for 50
  // digits: refused by name, and not before.
  if (!path.floats().empty()) {
    const double found = ratio > 1e10 ? tapped(0.0) : std::nan("");
    return {found, found, "refused: " + path.floats()};
  }
  if (!is_equilibrium(status)) return {};
  if (exact.advance(Real50(1)).status != Status::converged) return {};
  Accuracy out{0, std::nan(""), status == Status::converged ? "converged" : "beyond what double resolves"};
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const Pose<double>& at = path.reached().state.at[i];
    const Pose<Real50>& true_at = exact.reached().state.at[i];
    const Vec3<Real50> shift = tapped(at.x).cast<Real50>() - true_at.x;
    const Mat3<Real50> turn = tapped(at.R).cast<Real50>() - true_at.R;
    reference::keep_largest(out.error, double(reference::largest_entry<Real50>(shift)));
    reference::keep_largest(out.error, double(reference::largest_entry<Real50>(turn)));
  }
  out.over_told = out.error / mechanism::motion_error(path);
  return out;
}

std::vector<Finding> ratios(const Entry& entry) {
  std::vector<Finding> out;
  for (const double ratio : {1.0, 1e3, 1e6, 1e9, 1e10, 1e12}) {
    const Accuracy found = accuracy(entry, ratio);
    const std::string name = fmt::format("{}/mechanism_ratios/{:.0e}/", entry.name, ratio);
    const std::string said = fmt::format("{}; {:.1e} of what is told", found.outcome, found.over_told);
    out.push_back(
        finding(name + "error")
            .of(std::string(entry.name))
            .about("mechanisms")
            .measured(found.error, said)
            .in("m, rad")
            .at_most(1e-14 + 1e-18 * ratio,
                     "some tens of roundings of motions of a tenth, and a stiff force's, a hundredth of "
                     "eps, over the soft stiffness; none where it is refused")
            .by(Oracle::fifty_digits));
    out.push_back(finding(name + "told")
                      .of(std::string(entry.name))
                      .about("mechanisms")
                      .measured(found.over_told, found.outcome)
                      .in("of the error that is told")
                      .at_most(1, "an estimate from above")
                      .by(Oracle::fifty_digits));
  }
  return out;
}

}  // namespace

void mechanism_ratios(Checks& checks) {
  for (const char* name : {"invariant", "conformal", "attached_a"}) {
    const Entry* entry = reference::find_formulation(name);
    if (entry)
      checks.push_back(
          {std::string(name) + "/mechanism_ratios", "mechanisms", [entry] { return ratios(*entry); }});
  }
}

}  // namespace halfway::verify
