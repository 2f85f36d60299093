// A joint as both doors spell it: kind, law, and for each node its offset and frame.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/scene/text/fields.hpp"

namespace halfway::reference {

/// The keys of read_joint: in a scene those of [joint], in a request of the line.
inline const Names kJointKeys = {"kind", "law", "offset_a", "offset_b", "frame_a", "frame_b", "a", "b"};

/// What `kind`, `law`, `offset_a` or `a.o`, `frame_a` or `a.h` (and b) say; other keys are the door's.
/// Throws Refusal.
JointSpec read_joint(const Field& joint);

/// The keys of read_rod.
inline const Names kRodKeys = {"length", "axis"};

/// `length`, m, > 0, and `axis`, 1, 2, 3 or -1, -2, -3, 1 where it is left out; false: neither is there, and
/// the joint is left as it is. Throws Refusal.
bool read_rod(const Field& joint, JointSpec& spec);

/// Node axes from a quaternion [w, x, y, z] or the rows of a matrix. Off by up to 1e-3 it is the nearest
/// rotation, with a note from 1e-6 on. Throws Refusal [not_unit_quaternion, not_a_rotation].
Mat3<double> read_rotation(const Field& field);

}  // namespace halfway::reference
