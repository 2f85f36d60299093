// Names: those of the catalog, and what an unknown one may have meant.
#pragma once

#include "reference/face/registry.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

/// The purely linear analysis: it exists for scenes only and is no entry of the catalog.
inline constexpr const char* kLinearized = "linearized";

/// Names of all formulations of the catalog, in its order.
std::vector<std::string_view> formulation_names();

/// " (did you mean 'X'?)" of the allowed name that is most like `name`: up to a third of its letters
/// mistyped, or cut short. Empty when none is like it.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& allowed);

/// "unknown WHAT 'NAME' (did you mean 'X'?); allowed: A, B, C". Long names are cut.
std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& allowed);

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
