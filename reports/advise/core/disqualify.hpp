// What no error excuses: a law that answers otherwise when nothing has changed, or that ends on the way.
#pragma once

#include "reports/advise/core/question.hpp"
#include "reports/advise/model/candidate.hpp"

namespace halfway::advise {

/// Relative, at the poses of the candidate's own path within the envelope.
struct Defects {
  double node_order =
      0;  ///< change of the answers, and of the loads, when the nodes are listed the other way round
  double balance = 0;  ///< of the moments, over those at the nodes
  double energy = 0;   ///< made or lost in Question::periods, over what goes round
  double spin = 0;     ///< change of the moment while the node turns freely about an axis without stiffness
};
Defects defects_of(const Question& question, const Candidate& candidate, const Answers& answers,
                   std::size_t rows);

/// Change of the answers at each row when the nodes are listed the other way round, in the norm; nothing of a
/// law of which that is known to change none, and of one that is not odd in its strains, which that turns
/// over.
std::vector<double> node_order_errors(const reference::Scene& scene, const Candidate& candidate,
                                      const Answers& answers);

/// Axis (0, 1, 2) of the joint about which nothing holds it, if the law has one such and the question sets
/// the rotation no bound: a shaft that spins.
std::optional<int> free_shaft(const Question& question);

/// Why it is out whatever its error; "" where nothing is. The limit of each defect is the tolerance: less is
/// not seen.
std::string disqualified(const Question& question, const Candidate& candidate, const Answers& answers,
                         const Envelope& envelope, const Defects& defects);

}  // namespace halfway::advise
