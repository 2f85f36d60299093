// Paths by arc length where they have closed forms: one axis, through the fold and down again.
#include "reference/scene/joint/names.hpp"
#include "reference/solve/paths/branches.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace halfway::verify {
namespace {

using reference::Continuation;
using reference::ContinuationOptions;
using reference::EquilibriumPath;
using reference::PathEnd;
using reference::Singularity;

/// k = 1 N m/rad about the loaded axis; the others are stiff, so that nothing else buckles first.
reference::Scene one_axis() {
  reference::Scene s;
  s.name = "one_axis";
  s.joint.law = reference::LinearSpec{Eigen::Vector3d(1, 10, 100).asDiagonal(), false};
  s.loads = {{reference::LoadType::fixed_moment, {1, 0, 0}}};
  return s;
}

constexpr double kFarLoad = 4;  // N m: beyond k pi, the most that any law linear in phi takes below pi

ContinuationOptions far_away() {
  ContinuationOptions out;
  out.end_factor = kFarLoad;
  return out;
}

/// A law m(phi) with its fold.
struct OneAxisLaw {
  const char* formulation;
  double (*moment)(double phi);
  double fold;      ///< phi, rad
  double unloaded;  ///< phi at which the moment is zero again
  const char* says;
};
const OneAxisLaw kLaws[] = {
    {"jointc", [](double phi) { return std::sin(2 * phi) / 2; }, std::numbers::pi / 4, std::numbers::pi / 2,
     "strain sin(phi): m = k sin(phi) cos(phi), largest at pi/4, zero again at pi/2"},
    {"quaternion", [](double phi) { return std::sin(phi); }, std::numbers::pi / 2, std::numbers::pi,
     "strain 2 sin(phi/2): m = k sin(phi), largest at pi/2, zero again at pi"},
    {"fasse", [](double phi) { return std::sin(phi); }, std::numbers::pi / 2, std::numbers::pi,
     "potential k (1 - cos(phi)): m = k sin(phi), largest at pi/2, zero again at pi"}};

Finding named(const OneAxisLaw& law, const std::string& what, double value, double limit,
              const std::string& why) {
  return finding(std::string("continuation/one_axis/") + law.formulation + "/" + what)
      .of(law.formulation, to_string(Kind::angular))
      .about("continuation")
      .measured(value)
      .at_most(limit, std::string(law.says) + "; " + why)
      .by(Oracle::closed_form);
}

std::vector<Finding> closed_form(const OneAxisLaw& law) {
  const reference::Scene scene = one_axis();
  const Continuation continuation(scene, *reference::find_formulation(law.formulation), 0.5, far_away());
  const EquilibriumPath path = continuation.from_rest();
  double fold = std::nan(""), fold_moment = std::nan("");
  Measurement worst;
  for (const auto& p : path.points)
    worst.include(std::abs(p.state.factor - law.moment(p.phi)), fmt::format("phi = {:.4g} rad", p.phi));
  for (const auto& s : path.singular) {
    if (s.type != Singularity::fold) continue;
    fold = s.phi;
    fold_moment = s.state.factor;
  }
  const double end = path.points.back().phi;
  const std::string rounding = "located at 50 digits, handed over in double: 2 eps";
  return {named(law, "fold_angle", std::abs(fold - law.fold), 5e-16, rounding),
          named(law, "fold_moment", std::abs(fold_moment - law.moment(law.fold)), 5e-16, rounding),
          named(law, "moment", worst.value(), 4e-15,
                "N m, all points before and beyond the fold; a few eps of phi up to pi"),
          named(law, "unloaded", std::abs(end - law.unloaded), 2e-4,
                "at pi itself rotation vectors jump, and a path ends within 1e-4 of it")};
}

/// The largest moment about one axis that each formulation carries below pi.
Finding capacity(const Entry& entry, Draft f) {
  const reference::Scene scene = one_axis();
  const Continuation continuation(scene, entry, entry.probe_xi, far_away());
  const EquilibriumPath path = continuation.from_rest();
  std::string where = path.outcome;
  Extent moment;  // a path that never leaves the rest, its first point, carries nothing that was measured
  for (std::size_t i = 1; i < path.points.size(); ++i) moment.include(path.points[i].state.factor);
  for (const auto& s : path.singular) {
    if (s.type != Singularity::fold) continue;
    moment.include(s.state.factor);
    where = fmt::format("fold at phi = {:.6g} rad; ", s.phi) + where;
  }
  return f.measured(moment.high(), where).in("N m").reported("k = 1 N m/rad; loaded up to 4 N m");
}

/// A joint without stiffness about one axis: no path, and no number that is none. With it there is one.
std::vector<Finding> singular_start() {
  reference::Scene scene = one_axis();
  scene.joint.law = reference::LinearSpec{Eigen::Vector3d(0, 1, 2).asDiagonal(), false};
  const reference::Scene sound = one_axis();
  ContinuationOptions near;
  near.end_factor = 0.1;
  int wrong = 0;
  std::string outcome;
  for (const Entry& entry : reference::formulations()) {
    if (!accepts_law(entry, scene.joint)) continue;
    const EquilibriumPath path = Continuation(scene, entry, entry.probe_xi, far_away()).from_rest();
    outcome = path.outcome;
    wrong += path.end != PathEnd::singular_start || path.points.size() != 1;
    wrong += Continuation(sound, entry, entry.probe_xi, near).from_rest().points.size() < 2;
  }
  return {finding("continuation/singular_start")
              .about("continuation")
              .measured(wrong, outcome)
              .in("formulations")
              .at_most(0, "no stiffness about the loaded axis: each must end where it starts and say why")
              .by(Oracle::closed_form)};
}

}  // namespace

void continuation(Checks& checks) {
  for (const OneAxisLaw& law : kLaws) {
    checks.push_back({std::string("continuation/one_axis/") + law.formulation, "stability",
                      [&law] { return closed_form(law); }});
  }
  checks.push_back({"continuation/singular_start", "stability", singular_start});
  for (const Entry& entry : reference::formulations()) {
    const char* what = "one_axis_capacity";
    checks.push_back({property_name(entry, Kind::angular, what), "stability", [&entry, what] {
                        return std::vector{capacity(entry, property_finding(entry, Kind::angular, what))};
                      }});
  }
}

}  // namespace halfway::verify
