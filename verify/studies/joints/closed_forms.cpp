// Loads of the registry against the formulas of their sources, transcribed in reference/closed_forms.
#include "reference/truth/closed_forms_peers.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/twins.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

namespace closed = reference::closed;

template <class Form>
void compare(Checks& checks, const char* formulation, double xi, const std::string& suffix = "") {
  for (Kind kind : kKinds) {
    const std::string name =
        fmt::format("identities/closed_form/{}{}/{}", formulation, suffix, to_string(kind));
    checks.push_back(
        {name, "identities", [=]() -> std::vector<Finding> {
           const Entry* entry = reference::find_formulation(formulation);
           if (!entry)
             return {at_most(name, "closed_form", {NAN, "not in the catalog"}, 0, "", Oracle::none, "")};
           std::vector<Probe> set = probes(*entry, kind, 6, 2.4);
           for (Probe& probe : set) probe.spec.xi = xi;
           Finding f = at_most(name, "closed_form", load_difference(under_test(*entry), twin<Form>(), set),
                               kRounding, "", Oracle::closed_form, kRoundingReason);
           f.formulation = formulation;
           f.kind = to_string(kind);
           return {f};
         }});
  }
}

}  // namespace

void closed_forms(Checks& checks) {
  compare<closed::Intrinsic>(checks, "attached_a", 0);
  compare<closed::Intrinsic>(checks, "attached_b", 1);
  compare<closed::Intrinsic>(checks, "invariant", 0.5);
  for (double xi : {-0.435917, 0.0, 0.3, 0.5, 0.55, 1.0, 1.7}) {
    compare<closed::Intrinsic>(checks, "intrinsic", xi, fmt::format("_xi_{}", xi));
  }
  compare<closed::Conformal>(checks, "conformal", 0.5);
  compare<closed::Fasse>(checks, "fasse", 0.5);
  compare<closed::Jointc>(checks, "jointc", 0);
  compare<closed::DrakeRpy>(checks, "drake_rpy", 0.5);
  compare<closed::ChronoBody>(checks, "chrono_body", 1);
  compare<closed::ExudynIntrinsic>(checks, "exudyn_intrinsic", 0.5);
  compare<closed::MbdynJointInv>(checks, "mbdyn_joint_inv", 0.5);
}

}  // namespace halfway::verify
