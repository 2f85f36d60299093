// Which formulation of the catalog the data follow.
#pragma once

#include "reference/identify/identification.hpp"

namespace halfway::reference::identify {

/// Fits every formulation with the noise that is found; sets catalog, best and best_conservative.
void fit_catalog(const Data& data, Identification& out);

}  // namespace halfway::reference::identify
