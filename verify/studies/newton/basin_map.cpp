#include "verify/studies/newton/basin_map.hpp"

#include "reference/face/instantiations.hpp"
#include "reference/numbers/zeros.hpp"
#include "reference/record/effort.hpp"
#include "reference/solve/path.hpp"
#include "verify/once.hpp"
#include "verify/studies/newton/newton_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace halfway::reference {
namespace {

constexpr int kSubsteps = 4;    // of the branch between two magnitudes: it must not jump
constexpr int kBisections = 6;  // of the safe step, within one step of the grid

double apart(const Mat3<double>& A, const Mat3<double>& B) {
  return so3::log<double>(A * B.transpose()).norm();
}

BasinEnd failure(NewtonEnd end) {
  switch (end) {
    case NewtonEnd::singular_tangent:
      return BasinEnd::singular_tangent;
    case NewtonEnd::not_finite:
      return BasinEnd::not_finite;
    default:
      return BasinEnd::did_not_converge;
  }
}

/// The block's response to a grid, for one formulation.
class BasinMaps {
 public:
  BasinMaps(const LoadGrid& grid, const Entry& entry);
  LoadMap map(NewtonTangent tangent) const;

 private:
  using State = std::optional<Mat3<double>>;
  Vec3<double> moment(double angle, double magnitude) const;
  Scene loaded(double angle, double magnitude) const;
  BasinCell cell(double angle, double magnitude, const State& branch, NewtonTangent tangent) const;
  bool is_safe(double angle, double magnitude, NewtonTangent tangent) const;
  double safe_step(const std::vector<BasinCell>& cells, NewtonTangent tangent) const;

  LoadGrid grid_;
  const Entry& entry_;
  Scene block_;
  std::vector<State> branches_;
};

BasinMaps::BasinMaps(const LoadGrid& grid, const Entry& entry)
    : grid_(grid), entry_(entry), block_(block_scene(Vec3<double>::Zero())) {
  for (int i = 0; i < grid_.angles; ++i) {
    const Scene scene = loaded(grid_.angle(i), grid_.largest);
    Path<double> path(scene, entry_, entry_.probe_xi);
    for (int k = 0; k < grid_.steps * kSubsteps; ++k) {
      if (path.state().status == Status::converged) path.advance(double(k + 1) / (grid_.steps * kSubsteps));
      if (k % kSubsteps != kSubsteps - 1) continue;
      branches_.push_back(path.state().status == Status::converged ? State(path.state().joint.R)
                                                                   : std::nullopt);
    }
  }
}

Vec3<double> BasinMaps::moment(double angle, double magnitude) const {
  Vec3<double> m = Vec3<double>::Zero();
  m[grid_.axes[0]] = std::cos(angle);
  m[grid_.axes[1]] = std::sin(angle);
  if (!grid_.is_response) return magnitude * m;
  const Vec3<double> response = std::get<LinearSpec>(block_.joint.law).matrix * m;
  return magnitude / response.norm() * m;
}

Scene BasinMaps::loaded(double angle, double magnitude) const {
  Scene scene = block_;
  scene.loads.front().value = moment(angle, magnitude);
  return scene;
}

BasinCell BasinMaps::cell(double angle, double magnitude, const State& branch, NewtonTangent tangent) const {
  const Scene scene = loaded(angle, magnitude);
  const EquilibriumProblem<double> problem(scene, entry_, entry_.probe_xi);
  const auto run = plain_newton(problem, tangent, problem.start(), 1.0, kMostBasinIterations);
  BasinCell out{failure(run.end), run.iterations, run.has_wrapped};
  if (run.end == NewtonEnd::converged) {
    const bool is_branch = branch && apart(run.poses.back().R, *branch) <= kSameState;
    out.end = is_branch ? BasinEnd::continuous_branch : BasinEnd::other_equilibrium;
  }
  return out;
}

bool BasinMaps::is_safe(double angle, double magnitude, NewtonTangent tangent) const {
  const Scene scene = loaded(angle, magnitude);
  Path<double> path(scene, entry_, entry_.probe_xi);
  if (path.advance(1).status != Status::converged) return false;
  return cell(angle, magnitude, path.state().joint.R, tangent).end == BasinEnd::continuous_branch;
}

double BasinMaps::safe_step(const std::vector<BasinCell>& cells, NewtonTangent tangent) const {
  const auto fails = [&](int i, int k) {
    return cells[std::size_t(i * grid_.steps + k)].end != BasinEnd::continuous_branch;
  };
  const auto first_failure = [&](int i) {
    int k = 0;
    while (k < grid_.steps && !fails(i, k)) ++k;
    return k;
  };
  int first = grid_.steps;
  for (int i = 0; i < grid_.angles; ++i) first = std::min(first, first_failure(i));
  if (first == grid_.steps) return grid_.largest;
  double safe = grid_.magnitude(first);
  for (int i = 0; i < grid_.angles; ++i) {
    if (first_failure(i) != first) continue;
    const auto holds = [&](double magnitude) { return is_safe(grid_.angle(i), magnitude, tangent); };
    safe = std::min(safe, last_where(holds, grid_.magnitude(first - 1), grid_.magnitude(first), kBisections));
  }
  return safe;
}

LoadMap BasinMaps::map(NewtonTangent tangent) const {
  LoadMap out;
  int on_branch = 0;
  for (int i = 0; i < grid_.angles; ++i) {
    for (int k = 0; k < grid_.steps; ++k) {
      const State& branch = branches_[out.cells.size()];
      out.cells.push_back(cell(grid_.angle(i), grid_.magnitude(k), branch, tangent));
      on_branch += out.cells.back().end == BasinEnd::continuous_branch;
    }
  }
  out.share = on_branch / double(out.cells.size());
  out.safe_step = safe_step(out.cells, tangent);
  return out;
}

StartMap starts(const Entry& entry, double moment, int resolution) {
  Scene scene = read_scene(scenes_folder() / "c3_buckling.toml");
  const EquilibriumProblem<double> problem(scene, entry, entry.probe_xi);
  StartMap out;
  out.moment = moment;
  out.resolution = resolution;
  const auto index_of = [&](const Pose<double>& b) {
    for (std::size_t i = 0; i < out.equilibria.size(); ++i) {
      if (apart(b.R, so3::exp<double>(out.equilibria[i].theta)) <= kSameState) return int(i);
    }
    out.equilibria.push_back({so3::log<double>(b.R), 0});
    return int(out.equilibria.size()) - 1;
  };
  Path<double> path(scene, entry, entry.probe_xi);
  for (int k = 1; k <= scene.points && path.state().status == Status::converged; ++k)
    path.advance(moment * k / scene.points);
  out.has_branch = path.state().status == Status::converged;
  if (out.has_branch) index_of(path.state().joint);
  const auto component = [&](int i) { return std::numbers::pi * (2.0 * i / (resolution - 1) - 1); };
  for (int i = 0; i < resolution; ++i) {
    for (int j = 0; j < resolution; ++j) {
      Pose<double> start = problem.start();
      start.R = so3::exp<double>({component(i), component(j), 0}) * start.R;
      const auto run = plain_newton(problem, NewtonTangent::analytic, start, moment, kMostBasinIterations);
      const int index = run.end == NewtonEnd::converged ? index_of(run.poses.back()) : -1;
      if (index >= 0) ++out.equilibria[std::size_t(index)].cells;
      out.cells.push_back(index);
    }
  }
  return out;
}

}  // namespace

double LoadGrid::angle(int i) const { return std::numbers::pi / 2 * i / (angles - 1); }

const std::vector<LoadGrid>& load_grids() {
  static const int resolution = reference::by_effort(31, 7);
  static const std::vector<LoadGrid> grids = {{"axes_13", {0, 2}, false, 1800, resolution, resolution},
                                              {"axes_12", {0, 1}, true, 3, resolution, resolution}};
  return grids;
}

const LoadMap& load_map(const Entry& entry, const LoadGrid& grid, NewtonTangent tangent) {
  static verify::Once<BasinMaps, std::string> maps;
  static verify::Once<LoadMap, std::string, NewtonTangent> known;
  return known(entry, grid.name, tangent,
               [&] { return maps(entry, grid.name, [&] { return BasinMaps(grid, entry); }).map(tangent); });
}

const StartMap& start_map(const Entry& entry, double moment) {
  static verify::Once<StartMap, double> known;
  return known(entry, moment, [&] { return starts(entry, moment, reference::by_effort(41, 9)); });
}

}  // namespace halfway::reference
