// How far each formulation's second-order couplings are from those of the 3D bodies, and the best xi.
#include "reference/coupling_fit.hpp"
#include "reference/solve.hpp"
#include "verify/fe_access.hpp"
#include "verify/property.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

namespace fe = reference::fe;
using reference::CouplingGroup;

/// The law whose truth the formulations are held against: what the paper's program documents.
constexpr fe::Law kLaw = fe::Law::cauchy_log;
constexpr const char* kBodies[] = {"block", "frustum_top"};

/// The finest mesh of the default element.
const fe::SecondOrder& finest(const std::string& body) {
  const fe::SecondOrder* out = nullptr;
  for (const fe::MeshRun& run : characterisation(body).runs) {
    if (run.element == fe::ElementKind::hex20) out = &run.result;
  }
  return *out;
}

Finding of_formulation(const Entry& entry, Finding f, const char* body, CouplingGroup group) {
  const fe::SecondOrder& truth = finest(body);
  reference::JointSpec spec;
  spec.kind = Kind::linear_angular;
  // A free xi is the best one for this body and group.
  const auto& couplings_3d = truth.couplings[std::size_t(kLaw)];
  spec.xi = entry.needs_xi ? best_xi(couplings_3d, truth.compliance, group).xi : entry.probe_xi;
  spec.law = reference::LinearSpec{without_rounding(truth.compliance), true};
  f.unit = "relative";
  f.comparison = Comparison::report;
  f.oracle = Oracle::independent;
  f.parameter = fmt::format("{}, {}", body, to_string(kLaw));
  if (entry.needs_xi) f.parameter += fmt::format(", xi = {:.4f}", spec.xi);
  if (!reference::accepts_law(entry, spec)) {
    f.verdict = Verdict::left_out;
    f.reason = "refuses a law that couples translation and rotation, which this body has at its joint point";
    return f;
  }
  f.value = coupling_error(couplings(entry, spec), couplings_3d, truth.compliance, group);
  f.reason = "second-order couplings against the 3D body's, compliance the same: reported, not judged";
  return judged(f);
}

std::vector<Finding> fitted(const std::string& body) {
  std::vector<Finding> out;
  const fe::SecondOrder& truth = finest(body);
  for (fe::Law law : fe::kLaws) {
    for (CouplingGroup group : reference::kCouplingGroups) {
      const auto best = best_xi(truth.couplings[std::size_t(law)], truth.compliance, group);
      Finding f = solid_finding(fmt::format("best_xi/{}/{}/{}", body, to_string(group), to_string(law)), "",
                                "least squares over the group; what it leaves no xi can represent");
      f.value = best.xi;
      f.parameter = fmt::format("leaves {:.2g} of the couplings", best.remainder);
      f.uncertainty = best.remainder;
      f.comparison = Comparison::report;
      out.push_back(judged(f));
    }
  }
  return out;
}

}  // namespace

void fe_formulations(Checks& checks) {
  for (const char* body : kBodies) {
    for (CouplingGroup group : reference::kCouplingGroups) {
      add_property(checks, fmt::format("fe_{}_{}", body, to_string(group)), {Kind::linear_angular},
                   [body, group](const Entry& entry, Kind, Finding f) {
                     return of_formulation(entry, std::move(f), body, group);
                   });
    }
    checks.push_back({std::string("fe/best_xi/") + body, "fe", [body] { return fitted(body); }});
  }
}

}  // namespace halfway::verify
