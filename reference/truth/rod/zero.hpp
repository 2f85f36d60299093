// Where a smooth function of one number vanishes.
#pragma once

#include <functional>

namespace halfway::reference::rod {

/// Where a function changes its sign first, scanned from `low` to `high` in `samples` steps and then
/// bracketed down to rounding. Throws std::runtime_error where it does not.
double first_zero(const std::function<double(double)>& f, double low, double high, int samples);

}  // namespace halfway::reference::rod
