#include "verify/studies/joints/defects.hpp"

#include "verify/oracle/measures.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

/// 1e-4 to 3 rad, where the defects of order one and more are far above nothing.
std::vector<double> rotations() {
  std::vector<double> out;
  for (double phi = 1e-4; phi < 1.5; phi *= std::sqrt(10.)) out.push_back(phi);
  out.push_back(3);
  return out;
}

DefectSeries series(const reference::Entry& entry, const char* what,
                    Measurement (*measure)(const JointUnderTest&, const std::vector<Probe>&)) {
  DefectSeries out{what, std::string(entry.name), rotations(), {}};
  for (const double phi : out.phi)
    out.error.push_back(measure(under_test(entry), probes(entry, Kind::linear_angular, 2, phi)).value());
  return out;
}

}  // namespace

std::vector<DefectSeries> defect_series() {
  std::vector<DefectSeries> out;
  for (const auto& entry : reference::formulations()) {
    out.push_back(series(entry, "node_order", node_swap));
    out.push_back(series(entry, "moment_balance", moment_balance));
  }
  return out;
}

}  // namespace halfway::verify
