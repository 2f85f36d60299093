// Joints of programs in every study: which stand them all, as formulations (reference/programs/all.def), and
// why the others do not.
#include "verify/studies/programs/subject.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::verify {
namespace {

constexpr std::string_view kEverywhere[] = {
#define HALFWAY_FORMULATION(type, header) #type,
#include "reference/programs/all.def"
#undef HALFWAY_FORMULATION
};

/// Why a joint cannot stand in every study; empty where it can.
const char* why_not(const reference::ProgramJoint& joint) {
  const auto& facts = joint.facts;
  if (facts.asks_for_masses) return "its loads depend on masses: no force law";
  if (facts.is_bond) return "its points rest a metre apart, those of scenes together";
  if (!facts.objective) return "its loads are not of the relative motion alone";
  if (facts.isotropic_moments || facts.isotropic_forces) return "it takes one stiffness, scenes have three";
  if (!facts.has_forces) return "its springs of translation are not known";
  if (joint.name == "jolt_partial") return "some motors are off; with all of them on it is jolt_6dof";
  if (joint.name == "dart_free")
    return "two free bodies on it win many times their energy in forty periods, where steps are to be "
           "compared";
  if (joint.name == "febio_generic")
    return "its second order is no (alpha, beta) form, and at the stiffness that tells looks like one";
  if (joint.name == "abaqus_bushing")
    return "written by the axis of its swing, which a joint at rest has not: no derivative there";
  return "";
}

Finding placed(const reference::ProgramJoint& joint) {
  const std::string why = why_not(joint);
  const bool expected = why.empty(),
             listed = std::ranges::find(kEverywhere, fmt::format("Program{}", joint.type)) !=
                      std::end(kEverywhere);
  Draft f = program_finding("everywhere", joint.name);
  if (!expected && !listed) return f.left_out(why);
  return f.measured(tapped(double(listed) - double(expected)))
      .in("listed, less wanted")
      .equal(0, 0, "a list")
      .by(Oracle::independent);
}

std::vector<Finding> all() {
  std::vector<Finding> out;
  for (const auto& joint : reference::program_joints()) out.push_back(placed(joint));
  return out;
}

}  // namespace

void program_everywhere(Checks& checks) { checks.push_back({"programs/everywhere", "", all}); }

}  // namespace halfway::verify
