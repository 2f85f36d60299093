// What `compare` is given: a report, or a run of a history.
#pragma once

#include "reports/history/gate/record.hpp"

#include <utility>

namespace halfway::gate {

/// Each a folder of a report, its results.json, or FILE@RUN: a history (its SQLite file, or its exported
/// text) and the number or commit of a run. Without @RUN a history is its last run; BEFORE is its last run
/// that was made like AFTER, where there is one. @param newest  of those of its last commit alone: a change
/// that was accepted with that is not judged again where an older run was made like AFTER. Throws
/// reports::BadInput.
std::pair<Record, Record> read_both(const std::string& before, const std::string& after, bool newest = false);

}  // namespace halfway::gate
