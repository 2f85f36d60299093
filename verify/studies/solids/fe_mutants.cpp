// Wrong twins of the solids' second-order theory and of the coupling to CalculiX.
#include "reference/truth/fe/studies/calculix.hpp"
#include "reference/truth/fe/studies/characterisation.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/mutants/verdicts.hpp"

namespace halfway::verify {
namespace {

namespace fe = reference::fe;

/// |xi - 1/2| of the parallelepiped, the worst of the laws. Without the rotations of the first-order fields
/// the face neither turns by a finite angle nor turns its arms: add_face adds nothing.
Measurement asymmetry(bool face_turns) {
  const fe::Body& body = fe::body_named("block");
  const fe::Solid solid(body.mesh(fe::ElementKind::hex20, 4), body.material, body.face + joint_point(body));
  fe::Statics statics(solid);
  fe::Statics::Linear linear = statics.linear();
  const fe::Mat6 compliance = linear.compliance;
  if (!face_turns) linear.compliance.bottomRows<3>().setZero();
  fe::SecondOrder s = second_order(solid, linear);
  s.compliance = compliance;
  Measurement worst;
  for (fe::SolidLaw law : fe::kLaws) {
    worst.include(std::abs(xi_of_moments(s, law, 0, 2) - 0.5), std::string("law ") + to_string(law));
  }
  return worst;
}

/// theta_2 of the block under the paper's moment: CalculiX against ours, relative.
Measurement theta_2_of_calculix(bool by_rotation_vector) {
  const Vec3<double> reference(5, 0, 0);
  const fe::Solid solid(tapered_block(fe::ElementKind::hex20, {5, {30, 5}, {30, 5}}, {4, 6, 4}, 3), {1, 0.3},
                        reference);
  const double a = std::atan(0.01);
  fe::Load load;
  load.m = {std::cos(a), 0, std::sin(a)};
  fe::Statics statics(solid);
  const fe::Equilibrium ours = statics.solve(fe::SolidLaw::st_venant, load, solid.unloaded());
  if (!ours.converged) throw std::runtime_error(ours.reason);
  const fe::CalculixPose theirs =
      by_rotation_vector ? calculix_nonlinear(solid.mesh(), solid.material(), reference, load)
                         : calculix_as_coded(solid.mesh(), solid.material(), reference, load.f, load.m);
  return {std::abs(theirs.theta[1] / ours.theta()[1] - 1), fmt::format("theta_2 = {:.6g}", theirs.theta[1])};
}

std::vector<Finding> moment_on_rotation_vector(const std::string& name) {
  if (!fe::calculix_available()) {
    return {finding(name).about("fe").left_out("the program ccx is not installed (package calculix-ccx)")};
  }
  return verdicts(name, "fe/calculix theta_2", theta_2_of_calculix(false), theta_2_of_calculix(true), 5e-6);
}

}  // namespace

void fe_mutants(Checks& checks) {
  add_mutant(checks, "second_order_without_turning_face", "fe/symmetric_body", 1e-9, [] {
    return std::pair{asymmetry(false), asymmetry(true)};
  });
  const std::string name = "mutants/calculix_moment_without_gamma";
  checks.push_back({name, "external", [name] { return moment_on_rotation_vector(name); }});
}

}  // namespace halfway::verify
