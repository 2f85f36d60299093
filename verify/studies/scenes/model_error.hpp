// How far a model's answer to a scene is from the truth of the scene's body.
#pragma once

#include "reference/solve/solve.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace halfway::verify {

/// The paper's form for the body of a scene, followed at 50 digits. `curve.rows` are rounded to double.
struct Truth {
  reference::Choice choice{};
  reference::Curve curve;
  std::string described;  ///< which form and why
};

/// A body without mirror symmetry has a xi other than 1/2: the last such one of the scene, by the
/// intrinsic form. All others are invariant.
Truth truth_of(const reference::Scene& scene);

/// A formulation as its transcription, its kernel (in double or float) or a variant of invariant's kernel
/// evaluates it. Nothing for variants that are no cheaper accuracy (compensated) or another joint than the
/// others' (no_ends), and for a law that no kernel takes.
std::optional<reference::Entry> evaluated_by(std::string_view implementation, std::string_view variant,
                                             std::string_view precision, const reference::Entry& entry,
                                             const reference::Scene& scene);

/// Largest difference of an angle from the truth over the truth's largest angle, on the whole path; the
/// same of displacements; the greater of both, and at least what rounding leaves of the truth. Nothing
/// for a path that does not reach the end.
std::optional<double> model_error(const reference::Curve& path, const Truth& truth);

}  // namespace halfway::verify
