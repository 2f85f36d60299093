// CalculiX, another program, on the very same meshes: linear compliance, moments and forces at finite motion.
#include "reference/truth/fe/studies/calculix.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;
using fe::ElementKind;

constexpr const char* kDigits = "CalculiX prints seven digits: half a unit of the last, twice";
constexpr const char* kCoupling =
    "theta_2 is 1e-5 of theta_1: CalculiX stops at a residual of 1e-8, which leaves some 1e-13 rad";

struct Case {
  const char* name;
  fe::TaperedBlock size;
  std::array<int, 3> divisions;
  Vec3<double> reference;
  double factor;  ///< of the paper's load: both programs converge without cutting the step
};

/// Both programs solve the same mesh: a coarse one shows a difference as well as a fine one.
const Case kCases[] = {{"block", {5, {30, 5}, {30, 5}}, {3, 4, 3}, {5, 0, 0}, 1},
                       {"frustum", {20, {10, 5}, {30, 5}}, {4, 4, 3}, {20, 0, 0}, 0.02},
                       {"frustum_off_centre", {20, {10, 5}, {30, 5}}, {4, 4, 3}, {12, 1.5, -0.7}, 0.02}};

double off(const Vec3<double>& a, const Vec3<double>& b) { return (a - b).norm() / b.norm(); }

void compare_pose(std::vector<Finding>& out, const std::string& name, const fe::CalculixPose& theirs,
                  const fe::Equilibrium& ours) {
  const auto add = [&](const char* what, double value, double limit, const char* reason) {
    out.push_back(solid_finding("calculix/" + name + "/" + what)
                      .in("relative")
                      .measured(value)
                      .at_most(limit, reason)
                      .by(Oracle::other_program));
  };
  if (!ours.converged) throw std::runtime_error(name + ": " + ours.reason);
  add("d", off(theirs.d, ours.state.d), 1e-6, kDigits);
  add("theta", off(theirs.theta, tapped(ours.theta())), 1e-6, kDigits);
  add("theta_2", std::abs(theirs.theta[1] / ours.theta()[1] - 1), 5e-6, kCoupling);
}

std::vector<Finding> of_case(const Case& c, ElementKind element) {
  const std::string name = fmt::format("{}/{}", c.name, to_string(element));
  if (!fe::calculix_available()) {
    return {solid_finding("calculix/" + name)
                .left_out("the program ccx is not installed (package calculix-ccx)")};
  }
  const fe::Solid solid(tapered_block(element, c.size, c.divisions, 3), {1, 0.3}, c.reference);
  fe::Statics statics(solid);
  std::vector<Finding> out;
  const fe::Mat6 theirs = calculix_linear(solid.mesh(), solid.material(), c.reference).compliance;
  const fe::Mat6 ours = tapped(statics.linear().compliance);
  const fe::Vec6 size = ours.diagonal().cwiseSqrt();
  out.push_back(solid_finding("calculix/" + name + "/compliance")
                    .in("relative")
                    .measured(largest_entry<double>((theirs - ours).cwiseQuotient(size * size.transpose())),
                              "CalculiX " + fe::calculix_version())
                    .at_most(1e-6, kDigits)
                    .by(Oracle::other_program));
  const double a = std::atan(0.01);
  fe::Load moment, force;
  moment.m = c.factor * Vec3<double>(std::cos(a), 0, std::sin(a));
  force.f = c.factor * Vec3<double>(-1, 0, 1);
  for (const auto& [what, load] : {std::pair<const char*, fe::Load>{"moment", moment}, {"force", force}}) {
    compare_pose(out, name + "/" + what,
                 calculix_nonlinear(solid.mesh(), solid.material(), c.reference, load),
                 statics.solve(fe::SolidLaw::st_venant, load, solid.unloaded()));
  }
  return out;
}

}  // namespace

void fe_calculix(Checks& checks) {
  for (const Case& c : kCases) {
    for (ElementKind element : {ElementKind::hex20, ElementKind::hex20_full}) {
      checks.push_back({fmt::format("fe/calculix/{}/{}", c.name, to_string(element)), "external",
                        [&c, element] { return of_case(c, element); }});
    }
  }
}

}  // namespace halfway::verify
