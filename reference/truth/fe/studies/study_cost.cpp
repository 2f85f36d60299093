// What the 3D truth costs: nonlinear solves (Newton, factors kept while they gain a digit) over meshes, and
// CalculiX on the same meshes.
#include "reference/truth/fe/studies/calculix.hpp"
#include "reference/truth/fe/studies/study_makers.hpp"

#include <chrono>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

const std::vector<int> kNewtonLevels = {4, 6, 9, 12, 13};
const std::vector<int> kCalculixLevels = {3, 4, 5, 6};
constexpr double kCalculixFactor = 0.02;  ///< of the paper's moment: the second order alone is left

/// Peak resident memory of this process since the last reset, MB. Linux only, as is the reset.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) / 1024;
  }
  return std::nan("");
}
void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

nlohmann::json newton(int level) {
  reset_peak();
  const auto begin = std::chrono::steady_clock::now();
  const Body& body = body_named("block");
  const Solid solid(body.mesh(ElementKind::hex20, level), body.material, body.face);
  const Equilibrium e =
      Statics(solid).solve(SolidLaw::hencky, scene_load("c2_parallelepiped_small"), solid.unloaded());
  if (!e.converged) throw std::runtime_error(e.reason);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return {{"body", "block"},
          {"element", "hex20"},
          {"level", level},
          {"unknowns", solid.unknowns()},
          {"seconds", seconds},
          {"iterations", e.iterations},
          {"megabytes", peak_megabytes()}};
}

/// xi of St. Venant-Kirchhoff from CalculiX alone: its compliance and its theta_2.
nlohmann::json calculix(int level) {
  const Body& body = body_named("frustum_top");
  const Mesh mesh = body.mesh(ElementKind::hex20, level);
  const CalculixLinear linear = calculix_linear(mesh, body.material, body.face);
  const double a = std::atan(0.01);
  Load load;
  load.m = kCalculixFactor * Vec3<double>(std::cos(a), 0, std::sin(a));
  const CalculixPose pose = calculix_nonlinear(mesh, body.material, body.face, load);
  const Vec3<double> F = linear.compliance.diagonal().tail<3>();
  const double xi = pose.theta[1] / (F[1] * (F[0] - F[2]) * load.m[0] * load.m[2]);
  return {{"body", body.name},
          {"element", "hex20"},
          {"level", level},
          {"unknowns", Solid(mesh, body.material, body.face).unknowns()},
          {"seconds", linear.cost.cpu + pose.cost.cpu},
          {"runs", linear.cost.runs + pose.cost.runs},
          {"xi", xi},
          {"version", calculix_version()}};
}

Study over_levels(const std::string& name, const std::string& what, const std::vector<int>& levels,
                  nlohmann::json (*one)(int)) {
  Study study;
  study.name = name;
  study.what = what;
  study.inputs = {{"version", kGeneratorVersion}, {"levels", levels}};
  study.compute = [=](const Report& report) {
    nlohmann::json out = nlohmann::json::array();
    for (int level : levels) {
      out.push_back(one(level));
      report(int(out.size()), int(levels.size()), "level " + std::to_string(level));
    }
    return out;
  };
  return study;
}

}  // namespace

Study newton_cost_study() {
  return over_levels("cost_newton", "Time and memory of a nonlinear solve, parallelepiped, hex20",
                     kNewtonLevels, newton);
}

Study calculix_study() {
  return over_levels("cost_calculix", "xi and time of CalculiX, frustum, top clamped, St. Venant-Kirchhoff",
                     kCalculixLevels, calculix);
}

}  // namespace halfway::reference::fe
