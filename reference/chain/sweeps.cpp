#include "reference/chain/sweeps.hpp"

namespace halfway::reference::chain::detail {

extern const Sweeps kSweeps_Sse2;
#ifdef __x86_64__
extern const Sweeps kSweeps_Avx2, kSweeps_Avx512;
#endif

const Sweeps& sweeps([[maybe_unused]] batch::Isa isa) {
#ifdef __x86_64__
  if (isa == batch::Isa::avx512) return kSweeps_Avx512;
  if (isa != batch::Isa::sse2) return kSweeps_Avx2;
#endif
  return kSweeps_Sse2;
}

}  // namespace halfway::reference::chain::detail
