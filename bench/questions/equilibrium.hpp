// The static problems that solvers are timed on.
#pragma once

#include "bench/harness/case.hpp"
#include "reference/scene/scene.hpp"

#include <string>

namespace halfway::bench {

struct Problem {
  reference::Scene scene;
  int steps;  ///< equally spaced load factors that are solved one after the other
  Vec3<double> moment;
  LinearLaw<double, 3> law;
};

/// The canonical scene of that name: one load step to its end, or its whole path.
Problem problem(const std::string& name, bool whole_path);

/// The rotation of node b at the end of the path at 50 digits, against that of the timed solver.
Checked compare_end(const Problem& p, const char* formulation, const Pose<double>& b, double limit);

}  // namespace halfway::bench
