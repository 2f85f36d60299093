// How far each formulation's second-order couplings are from those of the 3D bodies, and the best xi.
#include "reference/solve/solve.hpp"
#include "reference/truth/coupling_fit.hpp"
#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;
using reference::CouplingGroup;

/// The law whose truth the formulations are held against: what the paper's program documents.
constexpr const char* kBodies[] = {"block", "frustum_top", "bearing_plane_cone"};

/// The mesh `before` places before the finest one of the default element.
const fe::SecondOrder& finest(const std::string& body, std::size_t before = 0) {
  std::vector<const fe::SecondOrder*> meshes;
  for (const fe::MeshRun& run : characterisation(body).runs) {
    if (run.element == fe::ElementKind::hex20) meshes.push_back(&run.result);
  }
  return *meshes.at(meshes.size() - 1 - before);
}

/// A free xi is the best one for this body and group.
reference::JointSpec joint_of(const Entry& entry, const fe::SecondOrder& truth, CouplingGroup group) {
  reference::JointSpec spec;
  spec.kind = Kind::linear_angular;
  spec.law = reference::LinearSpec{without_rounding(truth.compliance), true};
  spec.xi = entry.needs_xi ? best_xi(truth.couplings[std::size_t(kPaperLaw)], truth.compliance, group).xi
                           : entry.probe_xi;
  return spec;
}

double error_of(const Entry& entry, const fe::SecondOrder& truth, CouplingGroup group) {
  return coupling_error(couplings(entry, joint_of(entry, truth, group)),
                        truth.couplings[std::size_t(kPaperLaw)], truth.compliance, group);
}

/// What the solver's rounding leaves of a coupling, relative.
constexpr double kSolverRounding = 1e-9;

Finding of_formulation(const Entry& entry, Draft f, const char* body, CouplingGroup group) {
  const reference::JointSpec spec = joint_of(entry, finest(body), group);
  if (!reference::accepts_law(entry, spec))
    return f.left_out(
        "refuses a law that couples translation and rotation, which this body has at its joint point");
  const double error = error_of(entry, finest(body), group);
  const double moved = std::abs(error - error_of(entry, finest(body, 1), group));
  const std::string xi = entry.needs_xi ? fmt::format(", xi = {:.4f}", spec.xi) : "";
  return f.measured(error, fmt::format("{}, {}{}", body, to_string(kPaperLaw), xi))
      .in("relative")
      .reported(
          "second-order couplings against the 3D body's, compliance the same: reported, not judged; known to "
          "the change from the last mesh but one")
      .by(Oracle::independent, kSolverRounding + moved);
}

std::vector<Finding> fitted(const std::string& body) {
  std::vector<Finding> out;
  const fe::SecondOrder& truth = finest(body);
  for (fe::SolidLaw law : fe::kLaws) {
    for (CouplingGroup group : reference::kCouplingGroups) {
      const auto best = best_xi(truth.couplings[std::size_t(law)], truth.compliance, group);
      out.push_back(solid_finding(fmt::format("best_xi/{}/{}/{}", body, to_string(group), to_string(law)))
                        .measured(best.xi, fmt::format("leaves {:.2g} of the couplings", best.remainder))
                        .reported("least squares over the group; what it leaves no xi can represent")
                        .by(Oracle::none, best.remainder));
    }
  }
  return out;
}

}  // namespace

void fe_formulations(Checks& checks) {
  for (const char* body : kBodies) {
    for (CouplingGroup group : reference::kCouplingGroups) {
      add_property(checks, fmt::format("fe_{}_{}", body, to_string(group)), {Kind::linear_angular},
                   [body, group](const Entry& entry, Kind, Draft f) {
                     return of_formulation(entry, std::move(f), body, group);
                   });
    }
    checks.push_back({std::string("fe/best_xi/") + body, "fe", [body] { return fitted(body); }});
  }
}

}  // namespace halfway::verify
