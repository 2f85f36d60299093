// The cases of MBDyn's data: its keys, and what they are here.
#pragma once

namespace halfway::verify {

/// attached or invariant, ground first (gn) or node first (ng).
struct MbdynOrder {
  const char* key;
  const char* formulation;
  bool exchanged;
};
inline constexpr MbdynOrder kMbdynOrders[] = {{"att_gn", "attached_a", false},
                                              {"att_ng", "attached_a", true},
                                              {"inv_gn", "invariant", false},
                                              {"inv_ng", "invariant", true}};

}  // namespace halfway::verify
