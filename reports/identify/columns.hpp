// Names and units at the head of a column.
#pragma once

#include "reference/identify/data.hpp"
#include "reference/numbers/units.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace halfway::reports {

/// "f_x [kN]": a load or a motion, its component and what its numbers are in SI.
struct Column {
  bool is_load = false;
  int component = 0;
  reference::Unit unit{};
  std::string name{};
};

/// Component and sort of a name such as theta_x, Fx, "u x"; none where it is no such name.
std::optional<Column> named_column(std::string_view name);

/// A head with its unit in brackets; none where the name is no load and no motion. Throws reference::Refusal
/// at `line` where the unit is missing, unknown or of another dimension.
std::optional<Column> read_column(std::string_view head, int line);

/// A unit of loads or motions, checked likewise.
reference::Unit read_component_unit(std::string_view unit, bool is_load, int component,
                                    const std::string& key, int line);

/// "f_x, ..., theta_z".
std::string column_names();

std::string_view trimmed_cell(std::string_view text);

/// "KEY: what; allowed: ...", a reference::Refusal.
[[noreturn]] void refuse_at(int line, const std::string& key, const std::string& what,
                            const std::string& allowed);

}  // namespace halfway::reports
