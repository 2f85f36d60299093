// Errors of verify: those of reference/record/worst.hpp.
#pragma once

#include "reference/record/worst.hpp"

namespace halfway::verify {

using reference::Extent;
using reference::keep_largest;
using reference::larger;
using reference::largest_entry;
using reference::Measurement;

}  // namespace halfway::verify
