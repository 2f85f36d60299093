// A dead force on a slender rod and on one joint at its middle: at the tip, and at the special point of the
// paper [47-50], where the joint is and force and rotation decouple.
#pragma once

#include "reference/face/registry.hpp"

#include <array>
#include <vector>

namespace halfway::verify {

enum class Where { tip, middle };
inline constexpr Where kWhere[] = {Where::tip, Where::middle};
const char* to_string(Where where);

/// Loads of both studies, as shares of a force of EI/L^2 in size; the same direction for all.
inline constexpr std::array<double, 5> kForces = {0.4, 0.2, 0.1, 0.05, 0.025};

/// |theta_joint - theta_rod| / |theta_rod| at each of kForces; NaN without an equilibrium.
using ForceErrors = std::array<double, kForces.size()>;
const ForceErrors& force_errors(const reference::Entry& entry, Where where);

/// The power of the load with which the error grows, between the two smallest ones.
double growth(const ForceErrors& errors);

}  // namespace halfway::verify
