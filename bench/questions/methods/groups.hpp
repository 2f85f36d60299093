// The methods of the tangent, one function each: every one has its own unit.
#pragma once

#include "bench/harness/case.hpp"

namespace halfway::bench {

Cases analytic_cases();
Cases dual_cases();
Cases autodiff_cases();
Cases ceres_jet_cases();  ///< only where Ceres is found
Cases complex_step_cases();
Cases forward_cases();
Cases central_cases();

}  // namespace halfway::bench
