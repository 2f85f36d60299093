// Wrong writings and roads that forget a frame: each must be seen by the measurement that the study makes.
#include "verify/studies/frames/frames.hpp"

#include "reference/numbers/zeros.hpp"
#include "reference/solve/buckling.hpp"
#include "verify/oracle/mutants/verdicts.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/frames/laws.hpp"

#include <Eigen/LU>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Scene;

const char* const kScene = "c3_buckling";

Written load_not_turned(const Scene& s, const Mat3<double>& H) {
  Written out = in_other_axes(s, H);
  out.scene.loads = s.loads;
  return out;
}
Written frame_transposed(const Scene& s, const Mat3<double>& H) {
  Written out = in_other_axes(s, H);
  out.scene.joint.a.H = H.transpose() * s.joint.a.H;
  return out;
}
Written law_not_turned(const Scene& s, const Mat3<double>& H) {
  Written out = law_in_other_axes(s, H);
  out.scene.joint.law = s.joint.law;
  return out;
}
Written law_turned_on(const Scene& s, const Mat3<double>& H) {
  Written out = law_in_other_axes(s, H);
  out.scene.joint.law = law_in_other_axes(s, H.transpose()).scene.joint.law;
  return out;
}
Written inertia_left_behind(const Scene& s, const Mat3<double>& H) {
  Written out = in_other_axes(s, H);
  out.node_b.setIdentity();
  return out;
}

LawUnderTest law_of(const char* name) { return *own(*reference::find_formulation(name)); }

/// Of the invariant law.
CurveChanges curve_changes(Rewriting write) {
  const Mat3<double> H = so3::exp<double>(kTurns[0]);
  const LawUnderTest law = law_of("invariant");
  return changes(curve_answers(law, as_it_is(scene(kScene), H)), curve_answers(law, write(scene(kScene), H)));
}

void add_writing(Checks& checks, const char* name, Rewriting mutant, Rewriting healthy) {
  add_mutant(checks, name, "frames/curve", kCurve, [=] {
    return std::pair{curve_changes(mutant).pose, curve_changes(healthy).pose};
  });
}

/// The first zero of the determinant on the way round an axis of the nodes, from where both stand alike: as
/// long as no node has a frame this is the joint's.
double critical_in_node_axes(const reference::Entry& entry, const reference::JointSpec& spec, int axis) {
  const auto loads_at = [&](double angle) {
    Pose<double> b;
    b.R = so3::exp<double>(angle * Vec3<double>::Unit(axis));
    return entry.in_double.angular(spec, {}, b, true);
  };
  constexpr double kStep = 1e-3;
  const bool start = loads_at(0).m_b_wb.determinant() < 0;
  const auto as_before = [&](double angle) { return (loads_at(angle).m_b_wb.determinant() < 0) == start; };
  for (double low = 0; low + kStep < 3.14; low += kStep) {
    if (!as_before(low + kStep)) return loads_at(last_where(as_before, low, low + kStep, 60)).m_b[axis];
  }
  return 0;
}

double critical_of_joint(const reference::Entry& entry, const reference::JointSpec& spec, int axis) {
  const auto found = reference::first_buckling(entry, spec, axis);
  return found ? double(found->moment) : 0;
}

/// Change of the critical moment when the scene is written in other axes, relative.
Measurement critical_change(double (*critical)(const reference::Entry&, const reference::JointSpec&, int)) {
  const reference::Entry& entry = *reference::find_formulation("jointc");
  const Scene& s = scene(kScene);
  const Written written = in_other_axes(s, so3::exp<double>(kTurns[0]));
  const double before = critical(entry, s.joint, 0), after = critical(entry, written.scene.joint, 0);
  return {std::abs(after / before - 1), fmt::format("{:.10g} and {:.10g} N m", before, after)};
}

/// Flutter of attached_a about axis 3 when the body's inertia stays in the axes that the node had.
Measurement flutter_change(Rewriting write) {
  const LawUnderTest law = law_of("attached_a");
  const Mat3<double> H = so3::exp<double>(kTurns[0]);
  return change(critical_answers(law, as_it_is(scene(kScene), H), 2),
                critical_answers(law, write(scene(kScene), H), 2));
}

}  // namespace

void add_frames_mutants(Checks& checks) {
  add_writing(checks, "frames_load_not_turned", load_not_turned, in_other_axes);
  add_writing(checks, "frames_frame_transposed", frame_transposed, in_other_axes);
  add_writing(checks, "frames_law_not_turned", law_not_turned, law_in_other_axes);
  add_writing(checks, "frames_law_turned_on", law_turned_on, law_in_other_axes);
  add_mutant(checks, "frames_critical_in_node_axes", "frames/critical", 1e-12, [] {
    return std::pair{critical_change(critical_in_node_axes), critical_change(critical_of_joint)};
  });
  add_mutant(checks, "frames_inertia_left_behind", "frames/flutter", 1e-12, [] {
    return std::pair{flutter_change(inertia_left_behind), flutter_change(in_other_axes)};
  });
}

}  // namespace halfway::verify
