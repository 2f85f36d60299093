// What candidates cost on this machine, measured.
#pragma once

#include "reports/advise/model/candidate.hpp"

#include <map>
#include <string>
#include <vector>

namespace halfway::advise {

struct Cost {
  double ns = 0;      ///< of loads and tangent of one joint, data in cache; median of rounds, CPU time
  double spread = 0;  ///< half the distance of the quartiles over it
  double error = 0;   ///< of loads and tangent, against 50 digits, over the timed poses
  double flops = 0;   ///< counted; 0: not
};

/// Of each Candidate::timing() that the kernels' benchmarks have: checked against 50 digits first, then timed
/// in rounds, all in turn. A benchmark whose check fails has none. Of a law that no kernel takes, see
/// face_costs.
std::map<std::string, Cost> kernel_costs(const std::vector<Candidate>& candidates);

/// Of transcriptions through the run-time face, at the poses of their own paths: for laws that are not
/// linear.
std::map<std::string, Cost> face_costs(const reference::Scene& scene,
                                       const std::vector<Candidate>& candidates);

/// The flops that are kept of each (bench/flops.json) in the place of nanoseconds: the same on every machine.
std::map<std::string, Cost> counted_costs(const std::vector<Candidate>& candidates);

/// Loads of the linear analysis: its tangent is one matrix, once and for all.
Cost linear_cost(Kind kind);

/// Median and half the distance of the quartiles over it.
Cost of_rounds(std::vector<double> ns);

/// Nanoseconds of CPU time of this thread.
double thread_ns();

}  // namespace halfway::advise
