// What the clamp carries under given loads.
#pragma once

#include "reference/truth/rod/rod.hpp"

namespace halfway::reference::rod {

struct Clamp {
  Vec3<double> n, m;  ///< global axes, N and N m
};

/// As solve(), which see.
Clamp at_clamp(const Rod& rod, const Loads& loads);

}  // namespace halfway::reference::rod
