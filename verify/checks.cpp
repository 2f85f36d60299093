#include "verify/check.hpp"

namespace halfway::verify {

#define HALFWAY_CHECK(room, function) void function(Checks&);
#include "verify/checks.def"
#undef HALFWAY_CHECK

namespace {

void add(Checks& checks, const char* room, void (*function)(Checks&)) {
  const std::size_t before = checks.size();
  function(checks);
  for (std::size_t i = before; i < checks.size(); ++i) checks[i].label = room;
}

}  // namespace

Checks all_checks() {
  Checks checks;
#define HALFWAY_CHECK(room, function) add(checks, #room, function);
#include "verify/checks.def"
#undef HALFWAY_CHECK
  return checks;
}

}  // namespace halfway::verify
