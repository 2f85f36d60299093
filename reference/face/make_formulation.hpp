// A formulation as a value, with its xi where it has one.
#pragma once

namespace halfway::reference {

template <class F>
F make_formulation(double xi) {
  if constexpr (requires { F::kProbeXi; })
    return F(xi);
  else
    return F{};
}

}  // namespace halfway::reference
