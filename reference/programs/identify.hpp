// Which joint is it? Answers of an unknown program against every law known here, in every convention that
// people have.
#pragma once

#include "reference/programs/convention.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

struct Candidate {
  std::string name;
  Answerer answer;
  bool is_isotropic = false;  ///< it takes one stiffness
  bool couples = false;       ///< it takes springs that couple moves and turns
};

/// The catalog's formulations (those with a free xi at none) and the joints of programs.
std::vector<Candidate> known_joints();

struct Identity {
  std::string name;  ///< of the nearest joint
  Convention convention;
  double distance = NAN;             ///< root mean square over the questions, relative; NaN: nothing answered
  std::vector<std::string> as_well;  ///< others that answer the same
};

/// The nearest joint in its convention; of those equally near the one with the fewest oddities, first in the
/// list.
/// @param tolerance  relative, of the program's digits: nearer is as good
Identity identify(const std::vector<Answered>& answers, const std::vector<Candidate>& candidates,
                  double tolerance);

}  // namespace halfway::reference
