// The sweeps of an instruction set; AVX-512VL has those of AVX2.
#pragma once

#include "halfway/batch/isa.hpp"
#include "reference/chain/loops/sweep.hpp"

namespace halfway::reference::chain::detail {

/// Of a set that this machine has.
const Sweeps& sweeps(batch::Isa isa);

}  // namespace halfway::reference::chain::detail
