// What the page of a chain's run is drawn from.
#pragma once

#include "reference/chain/scenes/solve_chain_scene.hpp"
#include "reports/cli/run/page_data.hpp"

namespace halfway::reports {

/// Nodes of long chains are left out, evenly and the same ones in each shape: the drawing is no smoother with
/// them, and a page stays below some 3 MB. @param ran  its curves are those of `answers`, in their order
Json chain_page_data(const reference::ChainScene& scene, const Ran& ran,
                     const std::vector<reference::ChainAnswer>& answers);

}  // namespace halfway::reports
