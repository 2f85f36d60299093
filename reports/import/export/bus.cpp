#include "reports/import/export/export.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

bool is_placed(const JointEnd<double>& end) { return !end.o.isZero(0) || end.H != Mat3<double>::Identity(); }

/// Left out on request, else refused.
void leave_out(const ExportRequest& request, Exported& out, const std::string& what) {
  if (!request.law_only)
    throw CannotSay(fmt::format("{}: {}; allowed: a scene without, or --law-only, which leaves it out",
                                request.scene.name, what));
  out.left_out.push_back(what);
}

}  // namespace

Exported bus_of(const ExportRequest& request) {
  const auto& scene = request.scene;
  demand_kind(scene, Kind::linear_angular, "a .bus file");
  const Eigen::MatrixXd& K = stiffness_of_scene(scene, "a .bus file");
  demand_diagonal(K, "a .bus file");
  Exported out;
  if (is_placed(scene.joint.a) || is_placed(scene.joint.b))
    leave_out(request, out, "offsets and frames: a .bus file has none, the assembly places it");
  if (!request.formulation.empty() || !scene.formulations.empty())
    leave_out(request, out,
              fmt::format("formulation {}: a .bus file holds no law of rotation, who reads it decides",
                          request.formulation.empty() ? scene.formulations.front() : request.formulation));
  out.text =
      "[MDI_HEADER]\nFILE_TYPE = 'bus'\nFILE_VERSION = 4.0\nFILE_FORMAT = 'ASCII'\n"
      "[UNITS]\nLENGTH = 'meter'\nFORCE = 'newton'\nANGLE = 'radians'\nMASS = 'kg'\nTIME = 'second'\n"
      "[DAMPING]\n";
  for (const char* axis : {"FX", "FY", "FZ", "TX", "TY", "TZ"})
    out.text += fmt::format("{}_DAMPING = 0\n", axis);
  int i = 0;
  for (const char* axis : {"FX", "FY", "FZ", "TX", "TY", "TZ"}) {
    const double k = K(i, i);
    out.text += fmt::format("[{}_CURVE]\n{}\n-1 {}\n0 0\n1 {}\n", axis, i < 3 ? "{x fx}" : "{ax tx}",
                            digits_of(-k), digits_of(k));
    ++i;
  }
  return out;
}

}  // namespace halfway::imports
