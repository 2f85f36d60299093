// What complete_catalog() adds to an entry; generated units make it.
#pragma once

#include "reference/face/registry.hpp"

namespace halfway::reference {

struct DeepParts {
  std::string_view type;  ///< of the entry that they belong to
  Evaluators<Dual<Real50>> in_dual50;
  KernelEntry kernel;
};

/// Of every formulation of the catalog.
std::span<const DeepParts> deep_parts();

}  // namespace halfway::reference
