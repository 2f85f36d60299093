// What of an imperfection is rounding, and what makes a path of its own: the block of C3 under a moment about
// its axis 1 that is skewed by a little, written in axes that no binary number has exactly.
#include "verify/studies/frames/frames.hpp"

#include "reference/solve/paths/arc_curve.hpp"
#include "reference/solve/paths/branches.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/frames/laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::Singularity;

struct Skew {
  double angle;    ///< rad: the load across the axis over the load
  int branchings;  ///< that are to be named
  const char* what;
};
constexpr Skew kSkews[] = {
    {0, 1, "none but that of the turned axes, some 1e-16"},
    {1e-14, 1, "some tens of eps: no digit of the load is meant by it"},
    {1e-12, 0, "the smallest that double can follow: the path turns off 1e-4 rad before"},
    {1e-9, 0, "a thousandth of a radian before the branching the path turns off"},
    {1e-6, 0, "a hundredth of a radian before"},
    {1e-3, 0, "a tenth of a radian before"}};

Written skewed(double angle) {
  reference::Scene s = reference::without_skew(scene("c3_buckling"), 0);
  s.loads.front().value = Vec3<double>(std::cos(angle), 0, std::sin(angle));
  return in_other_axes(s, so3::exp<double>(kTurns[1]));
}

/// The path has to come out somewhere: over the branching, along its axis, or off it.
std::vector<Finding> named_branchings(const reference::Entry& entry, const Skew& skew) {
  const LawUnderTest law = *own(entry);
  const Written written = skewed(skew.angle);
  const auto path = arc_answers(law, written);
  const auto is_branching = [](const auto& s) { return s.type == Singularity::branching; };
  const Vec3<double> theta = written.scene.joint.a.H * so3::log<double>(path.points.back().state.b.R);
  const double off_axis = (written.axes.transpose() * theta).tail<2>().norm();
  Finding f;
  f.name = fmt::format("frames/imperfection/{}/{:g}", entry.name, skew.angle);
  f.formulation = entry.name;
  f.subject = "frames";
  f.value = double(std::ranges::count_if(path.singular, is_branching));
  f.unit = "branchings";
  f.comparison = Comparison::equal;
  f.expected = skew.branchings;
  f.oracle = Oracle::closed_form;
  f.parameter = path.outcome;
  f.reason = skew.what;
  Finding way = f;
  way.name += "/off_axis";
  way.value = off_axis > 0.1;
  way.unit = "1: turned off";
  way.expected = skew.branchings == 0;
  way.reason = "over the branching along the axis, or turned off before it onto the other path";
  return {judged(f), judged(way)};
}

/// What `run --arc` says of the load in turned axes.
std::vector<Finding> told() {
  const Written written = skewed(0);
  const auto& entry = *reference::find_formulation("invariant");
  const reference::Curve curve = reference::follow_by_arc(written.scene, {&entry, entry.probe_xi});
  Finding f;
  f.name = "frames/told/invariant";
  f.formulation = entry.name;
  f.subject = "frames";
  f.value = curve.outcome.find("branching at load factor 830.455516") == std::string::npos;
  f.high = 0;
  f.unit = "0: named";
  f.oracle = Oracle::independent;
  f.parameter = curve.outcome;
  f.reason = "the first zero of the determinant about joint axis 1, to ten digits";
  return {judged(f)};
}

}  // namespace

void add_frames_imperfections(Checks& checks) {
  for (const char* name : {"attached_b", "invariant", "conformal"}) {
    const reference::Entry& entry = *reference::find_formulation(name);
    for (const Skew& skew : kSkews) {
      checks.push_back({fmt::format("frames/imperfection/{}/{:g}", name, skew.angle), "cases",
                        [&entry, &skew] { return named_branchings(entry, skew); }});
    }
  }
  checks.push_back({"frames/told/invariant", "cases", told});
}

}  // namespace halfway::verify
