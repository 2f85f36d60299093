// Mechanisms in double: what `halfway run` solves.
#include "reference/mechanism/instances.hpp"

namespace halfway::reference::mechanism {
HALFWAY_MECHANISM(double)
}
