#include "reports/views/stability/defects.hpp"

#include "verify/oracle/measures.hpp"

#include <cmath>

namespace halfway::reports {
namespace {

using nlohmann::json;
using verify::JointUnderTest;
using verify::Measurement;
using verify::Probe;

struct Defect {
  const char* what;
  Measurement (*measure)(const JointUnderTest&, const std::vector<Probe>&);
};
constexpr Defect kDefects[] = {{"node_order", verify::node_swap}, {"moment_balance", verify::moment_balance}};

/// 1e-4 to 3 rad, where the defects of order one and more are far above nothing.
std::vector<double> rotations() {
  std::vector<double> out;
  for (double phi = 1e-4; phi < 1.5; phi *= std::sqrt(10.)) out.push_back(phi);
  out.push_back(3);
  return out;
}

json defect_series(const reference::Entry& entry, const Defect& defect) {
  json x = json::array(), error = json::array();
  for (const double phi : rotations()) {
    const double value =
        defect.measure(verify::of(entry), verify::probes(entry, Kind::linear_angular, 2, phi)).value();
    x.push_back(phi);
    error.push_back(std::isfinite(value) ? json(value) : json());
  }
  return {{"what", defect.what}, {"formulation", entry.name}, {"x", x}, {"error", error}};
}

}  // namespace

json stability_defects_record() {
  json out = json::array();
  for (const auto& entry : reference::formulations()) {
    for (const Defect& defect : kDefects) out.push_back(defect_series(entry, defect));
  }
  return out;
}

}  // namespace halfway::reports
