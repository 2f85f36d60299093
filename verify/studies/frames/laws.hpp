// Which formulation answers for which: in the other order of the nodes, and with a turned law.
#pragma once

#include "verify/studies/frames/answers.hpp"

#include <optional>

namespace halfway::verify {

/// The axes (0, 1, 2) of a law on angles about axes in turn, R = R_i R_j R_k.
struct TurnSequence {
  std::string_view formulation;
  int i, j, k;
  bool conjugate;  ///< the moment is that of the energy; else K e in a node's frame
};
/// Nothing for a tensorial law, to which no axes are special.
const TurnSequence* turn_sequence(std::string_view formulation);

/// Has the law no axes of its own? Of a program's joint, what is known of it says so.
bool is_tensorial(const reference::Entry& entry);

/// The formulation at the xi of its probes.
std::optional<LawUnderTest> own(const reference::Entry& entry);

/// Who answers the same when the nodes are listed in the other order; nothing where nobody does.
std::optional<LawUnderTest> exchange_partner(const reference::Entry& entry, Kind kind);

}  // namespace halfway::verify
