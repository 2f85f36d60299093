// Large rotation and conditioning for the report: where each formulation jumps, ends or loses its digits.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// Of the studies that the findings are of:
///   stiffness       [N m/rad] of the joint that is turned, about its axes
///   curves          [{formulation, phi (rad), moment (n.m/n.K n, rad; n the axis)}], of the pose alone, 0 to
///   2 pi unwrapped       the same with the unwrapped rotation vector, 0 to 3 pi large_rotation
///   [{formulation, axis, points: [{angle, moment (|m|/(|K| phi)), smallest (singular value of
///                   the tangent over |K|), condition}], crossings: [{angle, behaviour, jump, moment,
///                   order}]}]
///   gimbal          [{formulation, sequence, load_order, tangent_order, lost_1e6, lost_1e3 (rad), distance
///                   (rad), error}]
///   conditioning    [{what, formulation, x, error, notes}]: a series, x and error of the same length; an
///   error
///                   is null where its note says why
///   refusals        [{what, who, says}]: stiffnesses and frames that a reader refuses
///   convexity       [{formulation, radius (rad), says}]: energies that are series, and what eval says beyond
///   projection      {quaternion, polar}: flops of making a drifted matrix a rotation again
/// Numbers are rounded to the digits that a chart shows; what is not finite is null.
nlohmann::json stability_range_record();

}  // namespace halfway::reports
