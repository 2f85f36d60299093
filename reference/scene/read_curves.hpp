// A law of one curve for each strain: linear, an odd polynomial, bilinear or a table.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/scene/fields.hpp"

namespace halfway::reference {

/// `axis`: n tables, translation first, each with `stiffness`; `k1`, `k3`, `k5`; `negative` and `positive`,
/// the slopes below and above zero strain; or `x`, `y` and `interpolation` (linear, akima, monotone), points
/// of a curve that goes straight on beyond them. At zero strain none may fall. Throws Refusal
/// [indefinite_stiffness, named_twice].
PerAxisSpec read_curves(const Field& law, Kind kind);

}  // namespace halfway::reference
