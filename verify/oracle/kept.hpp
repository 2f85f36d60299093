// Numbers of each formulation that are kept from this code, in a table with a row for each.
#pragma once

#include "reference/face/registry.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::verify {

/// The row whose `name` is the formulation's; null for one that the table does not know.
template <class Rows>
const auto* kept_of(const Rows& rows, const reference::Entry& entry) {
  const auto row = std::ranges::find(rows, entry.name, [](const auto& r) { return r.name; });
  return row == std::end(rows) ? nullptr : &*row;
}

}  // namespace halfway::verify
