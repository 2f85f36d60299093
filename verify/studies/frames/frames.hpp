// The parts of the study of frames.
#pragma once

#include "verify/check.hpp"

#include "halfway/rotations/so3.hpp"

namespace halfway::verify {

/// Rotation vectors of turns that no binary number has exactly, rad.
inline const Vec3<double> kTurns[] = {{0.7, -1.1, 0.4}, {-0.3, 0.9, 2.0}};

/// What a curve in double may change by in another writing, where its condition does not ask for more.
inline constexpr double kCurve = 1e-12;

/// Angles about axes in turn are no tensor: what a turn of the law changes, by second-order theory.
void add_frames_second_order(Checks& checks);
/// What of an imperfection is rounding, and what is a path of its own.
void add_frames_imperfections(Checks& checks);
/// Wrong writings, that the measurements of this study must see.
void add_frames_mutants(Checks& checks);

}  // namespace halfway::verify
