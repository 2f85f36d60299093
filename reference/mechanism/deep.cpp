// Mechanisms at 50 digits, for the checks.
#include "reference/mechanism/instances.hpp"

namespace halfway::reference::mechanism {
HALFWAY_MECHANISM(Real50)
}
