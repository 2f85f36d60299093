// What the 3D truth costs: full Newton solves over meshes, and CalculiX on the same meshes.
#include "reference/fe/calculix.hpp"
#include "reference/fe/study_makers.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr const char* kScene = "c2_parallelepiped_small";
const std::vector<int> kNewtonLevels = {4, 6, 9, 12, 13};
const std::vector<int> kCalculixLevels = {3, 4, 5, 6};
constexpr double kCalculixFactor = 0.02;  ///< of the paper's moment: the second order alone is left

struct Cost {
  double seconds;
  int unknowns, iterations;
};

Cost newton(int level) {
  const auto begin = std::chrono::steady_clock::now();
  const Body& body = body_named("block");
  const Solid solid(body.mesh(ElementKind::hex20, level), body.material, body.face);
  const Equilibrium e = Statics(solid).solve(Law::hencky, scene_load(kScene), solid.unloaded());
  if (!e.converged) throw std::runtime_error(e.reason);
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), solid.unknowns(),
          e.iterations};
}

/// In a process of its own, so that its peak memory is its own.
nlohmann::json newton_apart(int level) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe for the cost of a solve");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for the cost of a solve");
  if (child == 0) {
    Cost cost{-1, 0, 0};
    try {
      cost = newton(level);
    } catch (const std::exception&) {
    }
    const bool sent = write(ends[1], &cost, sizeof cost) == ssize_t(sizeof cost);
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  Cost cost{-1, 0, 0};
  const bool received = read(ends[0], &cost, sizeof cost) == ssize_t(sizeof cost);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!received || cost.seconds < 0)
    throw std::runtime_error("the solve at level " + std::to_string(level) + " failed");
  return {{"body", "block"},
          {"element", "hex20"},
          {"level", level},
          {"unknowns", cost.unknowns},
          {"seconds", cost.seconds},
          {"iterations", cost.iterations},
          {"megabytes", double(usage.ru_maxrss) / 1024}};
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
  return over_levels("cost_newton", "Time and memory of a full Newton solve, parallelepiped, hex20",
                     kNewtonLevels, newton_apart);
}

Study calculix_study() {
  return over_levels("cost_calculix", "xi and time of CalculiX, frustum, top clamped, St. Venant-Kirchhoff",
                     kCalculixLevels, calculix);
}

}  // namespace halfway::reference::fe
