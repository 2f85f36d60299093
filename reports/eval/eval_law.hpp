// The law of a request: linear by its stiffness, or a polynomial per axis.
#pragma once

#include "reference/face/registry.hpp"
#include "reports/eval/eval_fields.hpp"

namespace halfway::reports {

/// Reads {"type": "linear", "K": rows} or {"type": "polynomial", "k1", "k3", "k5"}, for the number of
/// strains of `kind`, and checks it: symmetric, positive semidefinite, no coupling where `entry` has none.
/// @throws EvalError unknown_law, not_symmetric, indefinite_stiffness, block_diagonal_law_only and
///         those of eval_fields.hpp
reference::LawSpec read_law(const Field& law, Kind kind, const reference::Entry& entry);

}  // namespace halfway::reports
