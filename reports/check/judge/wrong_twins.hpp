// Mistakes that people make, as joints of their own: so that a check can name them.
#pragma once

#include "reference/programs/identify.hpp"

namespace halfway::check {

std::vector<reference::Candidate> wrong_twins();

}  // namespace halfway::check
