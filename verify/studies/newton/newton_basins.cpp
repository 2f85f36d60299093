// Plain Newton in one load step on the block of C3: its order against theory, its basins as measured.
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/newton/basin_map.hpp"
#include "verify/studies/newton/newton_order.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace halfway::verify {
namespace {

using reference::BasinEnd;
using reference::Entry;
using reference::NewtonOrder;
using reference::NewtonTangent;

constexpr double kLinearOrder = 0.02, kDifferenceOrder = 0.2;
constexpr const char* kLinearOrderReason =
    "a linear rate, since M is not J at the solution; the slope over the last third of the steps still turns "
    "with the error's direction, most where a difference step leaves only two of them";
constexpr double kLinearFactor = 0.06;  // relative
constexpr double kDifferenceFactor =
    0.8;  // a factor of 2.2: two steps, whose errors have different directions

Draft of_newton(const Entry& entry, const std::string& what) {
  return finding(fmt::format("{}/angular/newton_{}", entry.name, what))
      .of(std::string(entry.name), to_string(Kind::angular))
      .about("newton_basins");
}

Finding analytic_order(const Entry& entry) {
  return of_newton(entry, "order_analytic")
      .measured(pooled_order(entry))
      .in("order")
      .equal(2, 0.1,
             fmt::format("Newton's order; over the errors 1e-2 ... 1e-44 of {} runs, whose constants differ "
                         "by up to ten",
                         reference::kPooledRuns))
      .by(Oracle::closed_form);
}

std::vector<Finding> linear_order(const Entry& entry, NewtonTangent tangent) {
  const NewtonOrder& o = block_order(entry, tangent);
  const bool by_differences = tangent == NewtonTangent::forward_difference;
  return {of_newton(entry, fmt::format("order_{}", to_string(tangent)))
              .measured(o.order, fmt::format("{} iterations to 50 digits", o.iterations))
              .in("order")
              .equal(1, by_differences ? kDifferenceOrder : kLinearOrder, kLinearOrderReason)
              .by(Oracle::closed_form),
          of_newton(entry, fmt::format("factor_{}", to_string(tangent)))
              .measured(std::abs(std::log(o.factor / o.predicted)),
                        fmt::format("measured {:.4g}, predicted {:.4g}", o.factor, o.predicted))
              .in("|ln(measured/predicted)|")
              .at_most(
                  by_differences ? kDifferenceFactor : kLinearFactor,
                  "predicted: spectral radius of 1 - M^-1 J at the solution; the mean over the last third of "
                  "the steps still turns with the error's direction")
              .by(Oracle::independent)};
}

/// Without load a tangent is symmetric, and symmetrising it changes nothing to first order.
Finding unloaded(const Entry& entry) {
  const Vec3<double>& start = reference::kSmallResponse;
  return of_newton(entry, "factor_unloaded")
      .measured(
          newton_order(reference::block_scene(start), entry, NewtonTangent::symmetrised, 0, start).predicted)
      .in("linear factor of the symmetrised tangent")
      .at_most(1e-40,
               "J = K at the unstrained pose, symmetric: the factor vanishes to the rounding of 50 digits")
      .by(Oracle::closed_form);
}

std::vector<Finding> orders(const Entry& entry) {
  std::vector<Finding> out = {analytic_order(entry), unloaded(entry)};
  for (NewtonTangent t :
       {NewtonTangent::symmetrised, NewtonTangent::frozen, NewtonTangent::forward_difference}) {
    for (Finding& f : linear_order(entry, t)) out.push_back(std::move(f));
  }
  return out;
}

/// What a single step reaches is data: shown, for the tangent that a solver should use. A map on which no
/// step reaches the branch has measured nothing: the smallest are a thirty-first of the grid.
std::vector<Finding> maps(const Entry& entry) {
  std::vector<Finding> out;
  for (const auto& grid : reference::load_grids()) {
    const auto& map = load_map(entry, grid, NewtonTangent::analytic);
    out.push_back(
        of_newton(entry, fmt::format("safe_step_{}", grid.name))
            .measured(map.share > 0 ? map.safe_step : std::nan(""),
                      fmt::format("{:.1f} % of {} single steps up to {:g} reach the continuous branch",
                                  100 * map.share, map.cells.size(), grid.largest))
            .in(grid.is_response ? "rad of linear response" : "N m")
            .reported("the largest step up to which every smaller one of the grid does, in every direction"));
  }
  return out;
}

/// Under a moment that the formulation carries.
const reference::StartMap& carried(const Entry& entry) {
  const auto& map = start_map(entry, reference::kStartMoment);
  return map.equilibria.empty() && !map.has_branch ? start_map(entry, reference::kStartMoment / 10) : map;
}

/// Whatever plain Newton calls converged is in equilibrium, by the formulation's own loads.
Finding equilibria(const Entry& entry) {
  const auto& map = carried(entry);
  const reference::Scene& c3 = scene("c3_buckling");
  reference::JointSpec spec = c3.joint;
  spec.xi = entry.probe_xi;
  Measurement worst;
  for (const auto& e : map.equilibria) {
    const Pose<double> b{Vec3<double>::Zero(), so3::exp<double>(e.theta)};
    const Vec3<double> m = entry.in_double.angular(spec, {}, b, false).m_b;
    worst.include((m / map.moment - c3.loads.front().value).norm(),
                  fmt::format("{:.4f} {:.4f} {:.4f} rad", e.theta[0], e.theta[1], e.theta[2]));
  }
  return of_newton(entry, "start_imbalance")
      .measured(worst.value(),
                fmt::format("{} equilibria at {} N m; {}", map.equilibria.size(), map.moment, worst.where()))
      .in("relative to the load")
      .at_most(1e-10 / map.moment,
               "64 eps of the load and of the unstrained tangent, 2600 N m/rad, over the load")
      .by(Oracle::independent);
}

/// One rotation about one axis of an isotropic joint: Newton on the scalar function itself.
struct Scalar {
  const char* formulation;
  double (*moment)(double);  ///< of a unit stiffness, at 0 < phi < pi
  double (*slope)(double);
};
const Scalar kScalars[] = {
    {"attached_b", [](double x) { return x; }, [](double) { return 1.0; }},
    {"jointc", [](double x) { return std::sin(2 * x) / 2; }, [](double x) { return std::cos(2 * x); }},
    {"quaternion", [](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }},
    {"fasse", [](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }},
    {"conformal",
     [](double x) {
       const double t = std::tan(x / 4);
       return 4 * t * (1 + t * t);
     },
     [](double x) {
       const double t = std::tan(x / 4), c = 1 + t * t;
       return c * (c + 2 * t * t);
     }}};

/// Steps until x stands, 0 where an iterate leaves (-pi, pi): there the joint's angle wraps.
int scalar_newton(const Scalar& f, double moment, double& x) {
  x = 0;
  for (int i = 1; i <= reference::kMostBasinIterations; ++i) {
    const double step = (moment - f.moment(x)) / f.slope(x);
    x += step;
    if (std::abs(x) >= std::numbers::pi) return 0;
    if (std::abs(step) <= 1e-13) return i;
  }
  return 0;
}

/// Largest difference of angle where the scalar Newton converges, for moments of 0.02 ... 3 k rad.
std::vector<Finding> scalars() {
  std::vector<Finding> out;
  constexpr double kLeastSlope =
      0.1;  // of k: a limit moment itself is a double root, which no Newton finds sharply
  for (const Scalar& scalar : kScalars) {
    reference::Scene scene;
    scene.joint.law = reference::LinearSpec{Eigen::Vector3d(1, 1, 1).asDiagonal(), false};
    scene.loads = {{reference::LoadType::fixed_moment, {0.36, 0.48, 0.8}}};
    const Entry& entry = *reference::find_formulation(scalar.formulation);
    const reference::EquilibriumProblem<double> problem(scene, entry, entry.probe_xi);
    Measurement worst;
    int compared = 0;
    for (int k = 1; k <= 150; ++k) {
      double x;
      const int steps = scalar_newton(scalar, 0.02 * k, x);
      const auto run = plain_newton(problem, NewtonTangent::analytic, problem.start(), 0.02 * k,
                                    reference::kMostBasinIterations);
      if (steps == 0 || std::abs(scalar.slope(x)) < kLeastSlope) continue;
      ++compared;
      const double angle = so3::log<double>(run.poses.back().R).dot(scene.loads.front().value);
      const bool same_count = std::abs(run.iterations - steps) <= 1;
      worst.include(
          run.end == reference::NewtonEnd::converged && same_count ? std::abs(angle - x) : std::nan(""),
          fmt::format("{:g} k rad", 0.02 * k));
    }
    out.push_back(
        of_newton(entry, "scalar")
            .measured(worst.value(), fmt::format("{} of 150 moments compared; {}", compared, worst.where()))
            .in("rad")
            .at_most(1e-12,
                     "the same iterates of a scalar equation, in the same number of steps give or take the "
                     "last; 64 "
                     "eps over a slope of 0.1 at least")
            .by(Oracle::closed_form));
  }
  return out;
}

}  // namespace

void newton_basins(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    const auto add = [&](const char* what, auto run) {
      checks.push_back({fmt::format("{}/angular/newton_{}", entry.name, what), "stability",
                        [&entry, run] { return run(entry); }});
    };
    add("orders", orders);
    add("maps", maps);
    add("starts", [](const Entry& e) { return std::vector{equilibria(e)}; });
  }
  checks.push_back({"newton/scalar_equations", "stability", scalars});
}

}  // namespace halfway::verify
