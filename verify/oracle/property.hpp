// The common shape of property checks: one check per formulation and kind, one finding each.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/measures.hpp"

#include <string>

namespace halfway::verify {

/// A finding of one formulation and kind, name filled in; the caller adds value and limits.
Finding property_finding(const Entry& entry, Kind kind, const std::string& property);

/// Adds `entry/kind/property` for every formulation, for the kinds given.
/// @param measure  (entry, kind, finding with its name) -> finding with value, limits and reason
void add_property(Checks& checks, const std::string& property, std::initializer_list<Kind> kinds,
                  const std::function<Finding(const Entry&, Kind, Finding)>& measure);

/// A relative error, judged against a limit; an independent road gave what it is the error of.
Finding held(Finding finding, const Measurement& measured, double limit, const std::string& reason,
             const std::string& unit = "relative");

/// Holds the measured defect to rounding, or to the declared band of a known failure.
void hold(Finding& finding, const Measurement& measured, const Band& band);

}  // namespace halfway::verify
