// The law of a joint: linear by its stiffness or compliance, or a polynomial per axis.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/scene/fields.hpp"

namespace halfway::reference {

/// {type = "linear", stiffness (or K) or compliance} or {type = "polynomial", k1, k3, k5}, for the strains
/// of `kind`, translation first. A matrix is n numbers (a diagonal) or n rows, symmetric to 1e-12 (then its
/// symmetric part, with a note); a stiffness may be zero along some directions, a compliance may not.
/// Throws Refusal [unknown_law, not_symmetric, indefinite_stiffness].
LawSpec read_law(const Field& law, Kind kind);

/// The field of a linear law's matrix, by whichever word it has. Throws Refusal [missing_key, named_twice].
Field matrix_field(const Field& law);

}  // namespace halfway::reference
