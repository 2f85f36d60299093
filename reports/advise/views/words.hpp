// An advice in words.
#pragma once

#include "reports/advise/core/advice.hpp"

#include <string>

namespace halfway::advise {

/// About ten lines for the terminal.
std::string summary_text(const Advice& advice);

/// What the truth itself is known to, relative to its rotation at the end of the envelope; nothing where that
/// is not known.
std::optional<double> known_to(const Advice& advice);

/// Why it is this one, in one sentence.
std::string reason(const Advice& advice);

inline constexpr double kDegree = 0.017453292519943295;  ///< rad

/// "1.2 %", or "0.03 %"; "3e-07 %".
std::string percent(double share);

/// What is compared: "in the norm of theta", "in each of theta_x, theta_y, theta_z".
std::string measured_in(const Advice& advice);

/// Where none suffices: what would.
std::string instead_of_none(const Advice& advice);

/// "distance" where there is no truth, else "error".
const char* word_for_error(const Advice& advice);

/// Of a candidate by its index: "cheapest", or what else is to be said of it in a table.
std::string remark(const Advice& advice, std::size_t i);

}  // namespace halfway::advise
