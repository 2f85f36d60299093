// Kinds of instability for the report: critical moments and the eigenvalues on the way to them.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// Of the studies that the findings are of:
///   scene     whose law it is
///   moments   [{name, what}], in the order of the chart
///   bodies    [{name, principal (kg m^2)}]: flutter depends on the body, divergence does not
///   rows      [{formulation, axis (1 ... 3), moment, inertia (name of a body, or "any"), kind (divergence or
///             flutter), load (N m), angle (rad), until (rad), end}]: the first of its kind; load and angle
///             are null where there is none up to `until`, and `end` says why the path ends there
///   modes     [{formulation, moment, axis, inertia, columns, points}]: columns load (N m), angle (rad),
///   lowest
///             (smallest real part of mu, 1/s^2), imaginary (largest of mu, 1/s^2), growth (1/s)
nlohmann::json stability_kind_record();

}  // namespace halfway::reports
