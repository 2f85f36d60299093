#include "bench/questions/methods/groups.hpp"

#include <iterator>

namespace halfway::bench {

Cases tangent_method_cases();

/// Every way to the tangent, one line each.
Cases tangent_method_cases() {
  Cases all;
  for (Cases (*const cases)() : {analytic_cases, dual_cases, autodiff_cases,
#ifdef HALFWAY_CERES
                                 ceres_jet_cases,
#endif
                                 complex_step_cases, forward_cases, central_cases}) {
    std::ranges::move(cases(), std::back_inserter(all));
  }
  return all;
}

}  // namespace halfway::bench
