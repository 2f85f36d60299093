// What second-order theory says of each formulation: the frame of its force, and its rotation under a moment.
#pragma once

#include "verify/oracle/probes.hpp"

#include <optional>

namespace halfway::verify {

/// The frame xi of the force; none for a formulation whose force has no such frame, or that is not known
/// here.
std::optional<double> force_frame(const Entry& entry);

/// Rotation of node b under a fixed moment m, F the diagonal compliance, to second order in m; none where the
/// formulation has no fingerprint and is not known here.
std::optional<Vec3<double>> response_to_moment(const Entry& entry, const Vec3<double>& F,
                                               const Vec3<double>& m);

}  // namespace halfway::verify
