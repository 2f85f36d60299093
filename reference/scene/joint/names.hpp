// Names of the catalog, and what each has against a law.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/scene/text/likeness.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

/// The purely linear analysis: it exists for scenes only and is no entry of the catalog.
inline constexpr const char* kLinearized = "linearized";

/// Names of all formulations of the catalog, in its order.
std::vector<std::string_view> formulation_names();

/// What a formulation has against a law.
struct LawRefusal {
  const char* what;  ///< as "which takes no coupling of translation and rotation" goes on
  const char* allowed;
  const char* code;
};

/// nullptr: nothing. drake_rpy refuses coupling, rod4 and rod34 what they cannot invert and what has no one
/// stiffness to make a series of.
const LawRefusal* law_refusal(const Entry& entry, const JointSpec& spec);

inline const char* law_refused(const Entry& entry, const JointSpec& spec) {
  const LawRefusal* refusal = law_refusal(entry, spec);
  return refusal ? refusal->what : nullptr;
}
inline bool accepts_law(const Entry& entry, const JointSpec& spec) {
  return law_refusal(entry, spec) == nullptr;
}

}  // namespace halfway::reference
