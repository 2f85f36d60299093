// A formulation as a value, with its parameters where it has some.
#pragma once

#include "halfway/joint/parameters.hpp"

namespace halfway::reference {

template <class F>
F make_formulation(const Parameters& parameters) {
  if constexpr (requires { F::kProbeXi; })
    return F(parameters.xi);
  else if constexpr (requires { F::kProbeLength; })
    return F(parameters.length, parameters.axis);
  else
    return F{};
}

/// Those at which verify and bench probe it.
template <class F>
constexpr Parameters probe_parameters() {
  Parameters out;
  if constexpr (requires { F::kProbeXi; }) out.xi = F::kProbeXi;
  if constexpr (requires { F::kProbeLength; }) out.length = F::kProbeLength, out.axis = F::kProbeAxis;
  return out;
}

}  // namespace halfway::reference
