// Published figures of other programs: shown beside this run's, never in a ratio with them.
#pragma once

#include <string>
#include <vector>

namespace halfway::bench {

struct Published {
  std::string program, version;
  std::string what;  ///< exp, log, residual or residual_tangent and of which joint
  double ns = 0;     ///< per evaluation
  std::string machine, date, source;
};

/// Measured on another machine on another day.
std::vector<Published> published();

}  // namespace halfway::bench
