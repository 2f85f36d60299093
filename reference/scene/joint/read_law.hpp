// The law of a joint: linear, a polynomial or a curve for each axis, with a preload or an offset beside it.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/scene/text/fields.hpp"

namespace halfway::reference {

/// A table with type = "linear" (read_matrix.hpp), "polynomial" (k1, k3, k5: n numbers each) or "per_axis"
/// (read_curves.hpp), for the strains of `kind`, translation first. Beside each `offset`, the strain at which
/// the law's own zero is, and `preload`, a stress that is added: stress = law(strain - offset) + preload.
/// Throws Refusal [unknown_law, not_symmetric, indefinite_stiffness, wrong_unit, unknown_unit].
LawSpec read_law(const Field& law, Kind kind);

/// Says in a note which strains the law leaves free, if any.
void note_free_strains(const Field& law, const JointSpec& joint);

}  // namespace halfway::reference
