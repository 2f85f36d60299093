// What a caller means by BASE and HEAD, as programs that can be timed.
#pragma once

#include "reports/history/gate/times.hpp"

#include <optional>

namespace halfway::gate {

struct Places {
  std::filesystem::path source;  ///< the top of the project, a git work tree
  std::filesystem::path out;     ///< what is built and measured goes below
  int layouts = 3;               ///< programs of each commit
};

/// A program; a folder with bin/halfway_bench, or with layouts 1/halfway_bench, 2/halfway_bench, ...; a
/// commit, built below out/COMMIT, which takes minutes once; "" for the tree as it is. Throws
/// reports::BadInput of anything else, reports::FailedRun where building fails.
Side find_side(const std::string& text, const Places& places);

/// The tree's commit, or the one of a name; empty: there is none.
std::string commit_of(const std::string& name, const std::filesystem::path& source);

/// Instructions of one evaluation of the figure, counted by valgrind; nothing where that is not possible.
std::optional<double> instructions(const Side& side, const std::string& figure,
                                   const std::filesystem::path& folder);

}  // namespace halfway::gate
