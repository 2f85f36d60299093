// What checks do not claim to see. Without a line here a check has to fail for everything that it asks for.
#pragma once

#include "verify/oracle/saboteurs/saboteur.hpp"

#include <string>

namespace halfway::verify {

/// What a check asks for and does not judge.
Parts overlooked(const std::string& check);

}  // namespace halfway::verify
