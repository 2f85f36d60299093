#include "reference/face/deep.hpp"

#include <algorithm>
#include <stdexcept>

namespace halfway::reference {

void complete_catalog() {
  for (Entry& entry : catalogued()) {
    const auto parts = std::ranges::find(deep_parts(), entry.type, &DeepParts::type);
    if (parts == deep_parts().end()) throw std::logic_error("no duals of " + std::string(entry.type));
    entry.in_dual50 = parts->in_dual50;
    entry.kernel = parts->kernel;
  }
}

}  // namespace halfway::reference
