// A joint that no list has: which of a family would answer as it does?
#pragma once

#include "reference/programs/ask.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

/// Forces along the axes of exp(xi theta), a measure h(phi) n, moments along the axes of another xi, forces
/// at p_a + s d: what an unknown joint of that family is. NaN where the questions do not tell.
struct FamilyFit {
  double force_xi = NAN, moment_xi = NAN, force_at = NAN;
  bool is_conjugate =
      false;  ///< the force acts where virtual work on its frame puts it, and not at p_a + force_at d
  std::string measure = "none known";
  double distance = NAN;
  std::string words() const;  ///< "frame xi = 0.37, measure sin, force at b"
};
/// @param answers  in our words, to questions without springs of rotation and to others without springs of
/// translation
FamilyFit fit_family(const std::vector<Answered>& answers);

}  // namespace halfway::reference
