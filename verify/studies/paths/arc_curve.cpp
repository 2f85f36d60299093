// What `run --arc` writes: the same end as load stepping where that arrives, and a fold where it does not.
#include "reference/solve/paths/arc_curve.hpp"

#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

/// Largest difference of the two curves' last rows.
Finding same_end(const reference::Curve& arc, const reference::Curve& steps, Draft f) {
  Measurement worst;
  for (std::size_t i = 0; i < steps.columns.size(); ++i) {
    const double difference = std::abs(arc.rows.back()[i] - steps.rows.back()[i]);
    worst.include(difference / larger(1., std::abs(steps.rows.back()[i])), steps.columns[i]);
  }
  return f.measured(worst).at_most(
      1e-12, "two roads to the same equilibrium, each to some eps of a tangent whose condition is 1e2");
}

/// Where load stepping stops, the path by arc length has a fold at that load, and says so.
Finding fold_there(const reference::Curve& arc, const reference::Curve& steps, Draft f) {
  Extent load;
  for (const auto& row : arc.rows) load.include(row.front());
  return f.measured(arc.outcome.find("fold at load factor") == std::string::npos ? std::nan("") : load.high())
      .in("N m")
      .equal(steps.rows.back().front(), 10, "load stepping tells the fold to its spacing of 10 N m");
}

std::vector<Finding> against_load_steps(const reference::Choice& choice) {
  const reference::Scene& c3 = scene("c3_buckling");
  const auto arc = reference::follow_by_arc(c3, choice), steps = reference::solve_scene(c3, choice);
  const bool arrive = steps.converged && arc.converged;
  const std::string name(choice.entry->name);
  const Draft f = finding("arc_curve/" + name + (arrive ? "/end" : "/fold"))
                      .of(name)
                      .about("arc_curve")
                      .by(Oracle::independent);
  return {arrive ? same_end(arc, steps, f) : fold_there(arc, steps, f)};
}

}  // namespace

void arc_curve(Checks& checks) {
  for (const char* name : {"attached_a", "attached_b", "invariant", "conformal", "jointc"}) {
    const reference::Choice choice{reference::find_formulation(name), 0.5};
    checks.push_back(
        {std::string("arc_curve/") + name, "stability", [=] { return against_load_steps(choice); }});
  }
}

}  // namespace halfway::verify
