#include "verify/check.hpp"

namespace halfway::verify {

#define HALFWAY_CHECK(function) void function(Checks&);
#include "verify/checks.def"
#undef HALFWAY_CHECK

Checks all_checks() {
  Checks checks;
#define HALFWAY_CHECK(function) function(checks);
#include "verify/checks.def"
#undef HALFWAY_CHECK
  return checks;
}

}  // namespace halfway::verify
