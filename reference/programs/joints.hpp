// Other programs' joints behind one face, and formulations of the catalog behind the same.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/programs/ask.hpp"

#include <span>
#include <string_view>

namespace halfway::reference {

struct ProgramJoint {
  std::string_view name, stands_for;
  std::string_view type;    ///< in C++, below namespace halfway::programs
  std::string_view header;  ///< to be included for it
  programs::ProgramFacts facts;
  TwelveLoads (*in_double)(const Ask&);
  TwelveLoads (*at_50_digits)(const Ask&);  ///< rounded at the end
};

/// In the order of programs.def.
std::span<const ProgramJoint> program_joints();

/// nullptr where there is none of that name.
const ProgramJoint* find_program_joint(std::string_view name);

/// The linear/angular joint of these ends and springs, as formulations take it.
JointSpec joint_spec(const programs::Situation<double>& situation);

/// A formulation as a program that is asked, in double. @param entry  must outlive the result.
Answerer answerer(const Entry& entry, double xi);

}  // namespace halfway::reference
