// A linear law: its stiffness or its compliance as a diagonal or a matrix, in axes of its own where it says
// so.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/scene/text/fields.hpp"

namespace halfway::reference {

/// The keys of a linear law.
inline const Names kLinearKeys = {
    "type",          "stiffness", "K",       "compliance", "axes", "axes_translation",
    "axes_rotation", "tolerance", "preload", "offset"};

/// `stiffness` (or `K`) or `compliance`: n numbers (a diagonal) or n rows, symmetric to 1e-12 or to
/// `tolerance`, at most 0.1, of the largest entry in units of its own (then the symmetric part, with a note).
/// A stiffness may be zero along some directions, a compliance may not; neither may be negative, however
/// large the tolerance. `axes`, or `axes_translation` and `axes_rotation`: it is given along the columns of
/// that rotation. Throws Refusal [not_symmetric, indefinite_stiffness, named_twice].
LinearSpec read_linear(const Field& law, Kind kind);

/// n numbers (a diagonal) or n rows, symmetric to 1e-12, of a damper: positive semidefinite; N s/m, N m
/// s/rad. Throws Refusal.
Eigen::MatrixXd read_damping(const Field& field, Kind kind);

/// The field of a linear law's matrix, by whichever word it has. Throws Refusal [missing_key, named_twice].
Field matrix_field(const Field& law);

}  // namespace halfway::reference
