// Joints with a memory, asked along a road: what a joint of programs is that answers by how a pose was
// reached.
#pragma once

#include "reference/programs/ask.hpp"

#include <span>
#include <string_view>

namespace halfway::reference {

struct PathJoint {
  std::string_view name, stands_for;
  programs::ProgramFacts facts;
  TwelveLoads (*answer)(const Ask&);  ///< along the question's road; without one, along `straight_road`
};

/// LS-DYNA's discrete beam, SCOOR from -3 to 3.
std::span<const PathJoint> path_joints();

/// nullptr where there is none of that name.
const PathJoint* find_path_joint(std::string_view name);

/// The same question with the poses before it: body a where it is, body b from where the joint frames lie in
/// one another (or, of a bond, a metre apart) in equal turns and moves to where it is. A question that has a
/// road keeps it.
Ask with_road(const Ask& ask);

/// Body b alone turns: tilted by `tilt` about x of joint frame a, the axis of the tilt carried once round z,
/// and tilted back, to where it started. What a triad carried by a node keeps of it is a turn by the solid
/// angle 2 pi (1 - cos tilt).
Ask cone(double tilt);

}  // namespace halfway::reference
