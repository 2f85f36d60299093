// What `run --arc` writes: the same end as load stepping where that arrives, and a fold where it does not.
#include "reference/solve/paths/arc_curve.hpp"

#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

Finding finding(const std::string& name, const reference::Choice& choice) {
  Finding f;
  f.formulation = choice.entry->name;
  f.name = "arc_curve/" + f.formulation + "/" + name;
  f.subject = "arc_curve";
  f.oracle = Oracle::independent;
  return f;
}

/// Largest difference of the two curves' last rows.
Finding same_end(const reference::Curve& arc, const reference::Curve& steps, Finding f) {
  Measurement worst;
  for (std::size_t i = 0; i < steps.columns.size(); ++i) {
    const double difference = std::abs(arc.rows.back()[i] - steps.rows.back()[i]);
    worst.include(difference / std::max(1., std::abs(steps.rows.back()[i])), steps.columns[i]);
  }
  f.value = worst.value;
  f.parameter = worst.where;
  f.high = 1e-12;
  f.reason = "two roads to the same equilibrium, each to some eps of a tangent whose condition is 1e2";
  return judged(f);
}

/// Where load stepping stops, the path by arc length has a fold at that load, and says so.
Finding fold_there(const reference::Curve& arc, const reference::Curve& steps, Finding f) {
  double largest = 0;
  for (const auto& row : arc.rows) largest = std::max(largest, row.front());
  f.value = arc.outcome.find("fold at load factor") == std::string::npos ? std::nan("") : largest;
  f.comparison = Comparison::equal;
  f.expected = steps.rows.back().front();
  f.high = 10;
  f.unit = "N m";
  f.reason = "load stepping tells the fold to its spacing of 10 N m";
  return judged(f);
}

std::vector<Finding> against_load_steps(const reference::Choice& choice) {
  const reference::Scene& c3 = scene("c3_buckling");
  const auto arc = reference::follow_by_arc(c3, choice), steps = reference::solve_scene(c3, choice);
  if (steps.converged && arc.converged) return {same_end(arc, steps, finding("end", choice))};
  return {fold_there(arc, steps, finding("fold", choice))};
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
