// What each law is known to do and not to do, word by word, and that its double precision is its 50 digits.
#include "halfway/programs/lines.hpp"
#include "verify/studies/programs/subject.hpp"

namespace halfway::verify {
namespace {

using programs::ProgramFacts;
using reference::ProgramJoint;

/// Of a defect that is there: the least that is no accident of a pose.
constexpr double kThere = 1e-4;
constexpr const char* kThereReason = "a defect of first or second order in the angle, at up to 1.3 rad";

Finding held(std::string_view what, const ProgramJoint& joint, bool is_free, const Measurement& measured) {
  Draft f = program_finding(what, joint.name).measured(measured).in("relative");
  if (is_free) return f.at_most(kDoubleRounding, kDoubleRoundingReason).by(Oracle::closed_form);
  return f.at_least(kThere, kThereReason).by(Oracle::independent);
}

Measurement size(double x) { return {std::abs(x), ""}; }

/// Round loops of rotations alone: a bond has no rotation without its line.
void add_loops(std::vector<Finding>& out, const ProgramJoint& joint, const reference::Answerer& answer) {
  const ProgramFacts& facts = joint.facts;
  const Vec3<double> none(0, 0, 0), one(10, 10, 10), three(1, 10, 100);
  out.push_back(held("loop_one_stiffness", joint, facts.isotropic_conservative,
                     size(loop_work(answer, none, one, false))));
  if (!facts.isotropic_moments) {
    out.push_back(held("loop_three_stiffnesses", joint, facts.anisotropic_conservative,
                       size(loop_work(answer, none, three, false))));
  }
  out.push_back(held("tensoriality", joint, facts.tensorial, tensoriality(answer).worst));
}

std::vector<Finding> judged(const ProgramJoint& joint) {
  const ProgramFacts& facts = joint.facts;
  const auto answer = program_subject(joint.name);
  const auto asks = program_asks(facts, 24, 1.3);
  Measurement deep;
  for (const auto& ask : program_asks(facts, 24, 2.8))
    deep.include(reference::apart(joint.at_50_digits(ask), answer(ask)), "up to 2.8 rad");
  std::vector<Finding> out{
      program_finding("rounding", joint.name)
          .measured(deep)
          .in("relative")
          .at_most(kDoubleRounding, kDoubleRoundingReason)
          .by(Oracle::fifty_digits),
      held("moment_balance", joint, facts.balanced, moment_balance(answer, asks).worst),
      held("body_order", joint, facts.order_free, body_order(answer, asks).worst),
      held("objectivity", joint, facts.objective, objectivity(answer, asks).worst),
      held("double_cover", joint, true, double_cover(answer, asks).worst),
      held("masses", joint, !facts.asks_for_masses, mass_dependence(answer, asks).worst),
      held("proportionality", joint, true, proportionality(answer, asks).worst),
  };
  if (facts.is_bond) {
    const Vec3<double> k(10, 10, 100), rest(0, 0, programs::kBondRest);
    out.push_back(held("loop_of_a_bond", joint, false, size(loop_work(answer, k, k, true, rest))));
  } else {
    add_loops(out, joint, answer);
  }
  return out;
}

}  // namespace

void program_facts(Checks& checks) {
  for (const ProgramJoint& joint : reference::program_joints()) {
    checks.push_back({fmt::format("programs/facts/{}", joint.name), "", [&joint] { return judged(joint); }});
  }
}

}  // namespace halfway::verify
