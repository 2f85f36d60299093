// Is the tangent that a program gives the derivative of the loads that it gives?
#pragma once

#include "reports/check/judge/examine.hpp"

namespace halfway::check {

/// By central differences of its own loads, at four poses. Left out where its convention is more than a sign.
Result check_tangent(Program& program, const Hello& hello, const reference::Convention& convention);

}  // namespace halfway::check
