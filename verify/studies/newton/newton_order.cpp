#include "verify/studies/newton/newton_order.hpp"

#include "reference/face/instantiations.hpp"
#include "reference/numbers/linear_algebra.hpp"
#include "reference/numbers/random.hpp"
#include "reference/record/worst.hpp"
#include "verify/once.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace halfway::reference {
namespace {

constexpr int kMostIterations = 1500;  // a linear factor of 0.93 from 1 to 1e-44
constexpr double kLeastError = 1e-44;

double spectral_radius(const Mat3<double>& m) {
  const auto values = eigenvalues(m);
  Extent size;
  for (const auto& value : values) size.include(std::abs(value));
  return size.high();
}

/// Angles from every iterate to the solution, rad, down to the last that the digits still show.
std::vector<double> errors(const std::vector<Pose<Real50>>& poses, const Mat3<Real50>& solution) {
  std::vector<double> out;
  for (const auto& pose : poses) {
    const double e(so3::log<Real50>(pose.R * solution.transpose()).norm());
    if (!(e > kLeastError)) break;
    out.push_back(e);
  }
  return out;
}

/// Logarithms of an error and of the next.
using Pairs = std::vector<std::array<double, 2>>;

Pairs pairs(const std::vector<double>& e, std::size_t first) {
  Pairs out;
  for (std::size_t k = first; k + 1 < e.size(); ++k) out.push_back({std::log(e[k]), std::log(e[k + 1])});
  return out;
}

void measure(const std::vector<double>& e, NewtonOrder& out) {
  if (e.size() < 3) {
    out.order = out.factor = std::nan("");
    return;
  }
  const std::size_t steps = e.size() - 1, first = steps - std::max<std::size_t>(2, steps / 3);
  out.order = slope_of(pairs(e, first));
  out.factor = std::pow(e.back() / e[first], 1 / double(steps - first));
}

}  // namespace

NewtonOrder newton_order(const Scene& scene, const Entry& entry, NewtonTangent tangent, double factor,
                         const Vec3<double>& start) {
  const EquilibriumProblem<Real50> problem(scene, entry, entry.probe_xi);
  Pose<Real50> b = problem.start();
  b.R = so3::exp<Real50>(start.cast<Real50>()) * b.R;
  const auto run = plain_newton(problem, tangent, b, Real50(factor), kMostIterations);
  NewtonOrder out;
  out.end = run.end;
  out.iterations = run.iterations;
  if (run.end != NewtonEnd::converged) {
    out.order = out.factor = out.predicted = out.asymmetry = std::nan("");
    return out;
  }
  const Pose<Real50>& solution = run.poses.back();  // its imbalance is 64 eps: 1e-47 rad in this block
  measure(errors(run.poses, solution.R), out);
  const NodeMatrix<Real50> J = newton_tangent(problem, NewtonTangent::analytic, solution, Real50(factor));
  const bool is_frozen = tangent == NewtonTangent::frozen;
  const NodeMatrix<Real50> M = newton_tangent(problem, tangent, is_frozen ? b : solution, Real50(factor));
  const Mat3<Real50> gain = lu_solve<Real50>(M, NodeMatrix<Real50>(M - J));
  out.predicted = spectral_radius(gain.cast<double>());
  out.asymmetry = double(NodeMatrix<Real50>(J - J.transpose()).norm() / J.norm());
  return out;
}

static double pooled(const Entry& entry) {
  constexpr double kNear = 1e-2;  // rad: beyond, the next order of the error shows
  const Scene scene = block_scene(kSmallResponse);
  const EquilibriumProblem<Real50> problem(scene, entry, entry.probe_xi);
  Generator random(31);
  Pairs all;
  for (int i = 0; i < kPooledRuns; ++i) {
    Pose<Real50> b = problem.start();
    b.R = so3::exp<Real50>((0.2 * random.direction()).cast<Real50>()) * b.R;
    const auto run = plain_newton(problem, NewtonTangent::analytic, b, Real50(1), kMostIterations);
    if (run.end != NewtonEnd::converged) return std::nan("");
    for (const auto& pair : pairs(errors(run.poses, run.poses.back().R), 0)) {
      if (pair[0] <= std::log(kNear)) all.push_back(pair);
    }
  }
  return slope_of(all);
}

double pooled_order(const Entry& entry) {
  static verify::Once<double> known;
  return known(entry, [&] { return pooled(entry); });
}

const NewtonOrder& block_order(const Entry& entry, NewtonTangent tangent) {
  static verify::Once<NewtonOrder, NewtonTangent> known;
  return known(entry, tangent, [&] {
    return newton_order(block_scene(kSmallResponse), entry, tangent, 1, {0.01, -0.015, 0.008});
  });
}

Scene block_scene(const Vec3<double>& linear_response) {
  Scene scene = read_scene(scenes_folder() / "c3_buckling.toml");
  const auto& law = std::get<LinearSpec>(scene.joint.law);
  if (!law.is_compliance) throw std::runtime_error("c3_buckling: a compliance is expected");
  scene.loads = {
      {LoadType::fixed_moment, law.matrix.diagonal().cwiseInverse().cwiseProduct(linear_response)}};
  scene.references.clear();
  return scene;
}

}  // namespace halfway::reference
