// One line in, one line out: the whole of `halfway eval` but for the loop.
#pragma once

#include <string>
#include <string_view>

namespace halfway::reports {

/// Answers a request, {"id", "strain", "loads", "tangent", "energy"}, or {"id", "error"}: one line of
/// strict JSON without the line end. Numbers have the fewest digits that give them back. "errors" name poses
/// of many that have no result; "notes" say what was normalised, where anything was. Never throws for any
/// text.
std::string eval_line(std::string_view line);

/// The answer to what could not even be read as a line.
std::string eval_refusal(std::string_view code, std::string_view message);

}  // namespace halfway::reports
