// Every answer of every scene again in other axes, with a turned law, from another unstrained pose, and in
// the other order of the nodes.
#include "verify/studies/frames/frames.hpp"

#include "reference/record/effort.hpp"
#include "reference/solve/buckling.hpp"
#include "reference/solve/paths/branches.hpp"
#include "reference/solve/solve.hpp"
#include "verify/once.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/frames/answers.hpp"
#include "verify/studies/frames/laws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

using reference::Entry;
using reference::Scene;

constexpr const char* kCritical = "c3_buckling";
constexpr int kFlutterAxes[] = {0, 2};  // the soft way of the load, and the stiffest: most laws flutter there

struct Writing {
  const char* name;
  Rewriting write;
  const char* reason;
};
const Writing kWritings[] = {
    {"other_axes", in_other_axes, "no answer depends on the axes that it is written in"},
    {"law_in_other_axes", law_in_other_axes,
     "H^T K H in frames turned by H is the same body, for tensorial laws"},
    {"node_b_in_other_axes", node_b_in_other_axes,
     "all counts from the unstrained pose, whatever axes node b has"},
    {"nodes_exchanged", nodes_exchanged, "the other order of the nodes, answered by the partner's law"}};

/// C6 with what it lacks: joint points off the nodes and off the force, and frames that are those of no node.
Scene with_ends() {
  Scene out = scene("c6_compression_shear");
  out.name = "c6_with_ends";
  out.joint.a = {{0.3, -0.2, 0.5}, so3::exp<double>({0.4, 0.1, -0.6})};
  out.joint.b = {{-0.1, 0.4, 0.2}, so3::exp<double>({-0.5, 0.8, 0.3})};
  out.loads.front().point = {0.2, 0.1, -0.3};
  out.loads.push_back({reference::LoadType::follower_moment, {2, -1, 3}});
  out.factor_end = 10;
  return out;
}

std::vector<Scene> all_scenes() {
  std::vector<Scene> out = scenes();
  out.push_back(with_ends());
  return out;
}

/// The scenes of a path by arc length: through the branching, and past it.
std::vector<Scene> arc_scenes() {
  Scene straight = reference::without_skew(scene(kCritical), 0);
  straight.name = "c3_straight";
  return {scene(kCritical), straight};
}

/// The worst of each answer.
struct Worst {
  Measurement curve, energy, modes, critical, flutter, arc;
  double condition = 1;
};

/// The answers of the scenes as they are: every writing is compared with the same ones.
const CurveAnswers& original_curve(const LawUnderTest& law, const Scene& s) {
  static Once<CurveAnswers, std::string, double> known;
  return known(*law.entry, s.name, s.factor_end, [&] { return curve_answers(law, as_it_is(s, {})); });
}

const reference::CriticalLoads& original_loads(const LawUnderTest& law, int axis) {
  static Once<reference::CriticalLoads, int> known;
  return known(*law.entry, axis, [&] { return critical_answers(law, as_it_is(scene(kCritical), {}), axis); });
}

const reference::EquilibriumPath& original_arc(const LawUnderTest& law, const Scene& s) {
  static Once<reference::EquilibriumPath, std::string> known;
  return known(*law.entry, s.name, [&] { return arc_answers(law, as_it_is(s, {})); });
}

void keep(Measurement& worst, const Measurement& m, const std::string& at) {
  worst.include(m.value(), at + ": " + m.where());
}

void compare_curves(Worst& worst, const LawUnderTest& law, const LawUnderTest& partner, Scene s,
                    Rewriting write, const Mat3<double>& H) {
  if (original_curve(law, s).theta.empty()) s.factor_end /= 100;  // it carries less than the first point
  const CurveAnswers& original = original_curve(law, s);
  const CurveChanges c = changes(original, curve_answers(partner, write(s, H)));
  keep_largest(worst.condition, original.condition);
  keep(worst.curve, c.pose, s.name);
  keep(worst.energy, c.energy, s.name);
  keep(worst.modes, c.modes, s.name);
}

/// A turned law has no moment about one joint axis alone: its branchings are those of the arcs.
bool has_joint_axes(const Writing& writing) { return writing.write != law_in_other_axes; }

void compare_critical(Worst& worst, const LawUnderTest& law, const LawUnderTest& partner,
                      const Written& written) {
  const Scene& s = scene(kCritical);
  for (int axis : kFlutterAxes) {
    keep(worst.flutter, change(original_loads(law, axis), critical_answers(partner, written, axis)),
         fmt::format("axis {}", axis + 1));
  }
  const auto a = reference::critical_state(s, {law.entry, law.xi});
  reference::JointSpec spec = written.scene.joint;
  spec.xi = partner.xi;
  const auto b =
      reference::first_buckling(*partner.entry, spec, s.critical_axis - 1, written.setting.nodes_exchanged);
  double off = a.has_value() == b.has_value() ? 0 : std::nan("");
  if (a && b) off = std::abs(double(b->moment / a->moment) - 1);
  worst.critical.include(off, a ? fmt::format("{:.12g} N m", double(a->moment)) : "none below pi");
}

Finding named(const Entry& entry, const Writing& writing, const char* answer) {
  Finding f;
  f.name = fmt::format("frames/{}/{}/{}", entry.name, writing.name, answer);
  f.formulation = entry.name;
  f.subject = "frames";
  f.unit = "relative";
  f.oracle = Oracle::independent;
  return f;
}

Finding finding(const Entry& entry, const Writing& writing, const char* answer, const Measurement& m,
                double limit, const std::string& why) {
  Finding f = named(entry, writing, answer);
  f.value = m.value();
  f.parameter = m.where();
  f.high = limit;
  f.reason = fmt::format("{}; {}", writing.reason, why);
  return judged(f);
}

std::vector<Finding> findings(const Entry& entry, const Writing& writing, const Worst& worst) {
  const double limit = larger(kCurve, 16 * std::numeric_limits<double>::epsilon() * worst.condition);
  const std::string curve_why =
      fmt::format("solutions in double, each to some eps times the condition of its tangent, which is {:.2g}",
                  worst.condition);
  const char* arc_why =
      "a turn leaves an imbalance of some eps, which moves a branching by eps times the condition, 40";
  std::vector<Finding> out{finding(entry, writing, "curve", worst.curve, limit, curve_why),
                           finding(entry, writing, "energy", worst.energy, limit, curve_why),
                           finding(entry, writing, "modes", worst.modes, limit, curve_why),
                           finding(entry, writing, "arc", worst.arc, 1e-9, arc_why)};
  if (!has_joint_axes(writing)) return out;
  const char* why = "found at 50 digits for numbers that are given in double, to eps times a condition of 40";
  out.push_back(finding(entry, writing, "critical", worst.critical, 1e-12, why));
  out.push_back(finding(entry, writing, "flutter", worst.flutter, 1e-12, why));
  return out;
}

Finding left_out(const Entry& entry, const Writing& writing, const std::string& reason) {
  Finding f = named(entry, writing, "curve");
  f.verdict = Verdict::left_out;
  f.reason = reason;
  return f;
}

std::vector<Finding> in_writing(const Entry& entry, const Writing& writing) {
  if (writing.write == law_in_other_axes && !is_tensorial(entry)) {
    return {left_out(entry, writing,
                     turn_sequence(entry.name)
                         ? "angles about axes in turn: another law in other axes, see second_order"
                         : "its measure or its rod has axes of its own: another law in other axes")};
  }
  const bool exchanged = writing.write == nodes_exchanged;
  const auto partner_of = [&](Kind kind) { return exchanged ? exchange_partner(entry, kind) : own(entry); };
  if (!partner_of(Kind::angular))
    return {left_out(entry, writing, "depends on the order of the nodes, and no formulation is its image")};
  const LawUnderTest law = *own(entry), partner = *partner_of(Kind::angular);
  Worst worst;
  for (const Vec3<double>& turn : kTurns) {
    const Mat3<double> H = so3::exp<double>(turn);
    for (const Scene& s : all_scenes()) {
      const auto other = partner_of(s.joint.kind);
      if (!other || !accepts_law(entry, s.joint)) continue;
      compare_curves(worst, law, *other, s, writing.write, H);
    }
    for (const Scene& s : arc_scenes())
      keep(worst.arc, change(original_arc(law, s), arc_answers(partner, writing.write(s, H))), s.name);
    if (has_joint_axes(writing)) compare_critical(worst, law, partner, writing.write(scene(kCritical), H));
    if (exchanged) break;  // H has no part in it
    if (by_effort(2, 1) == 1) break;
  }
  return findings(entry, writing, worst);
}

}  // namespace

void frames(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    for (const Writing& writing : kWritings) {
      checks.push_back({fmt::format("frames/{}/{}", entry.name, writing.name), "cases",
                        [&entry, &writing] { return in_writing(entry, writing); }});
    }
  }
  add_frames_second_order(checks);
  add_frames_imperfections(checks);
  add_frames_mutants(checks);
}

}  // namespace halfway::verify
