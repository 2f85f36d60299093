// The common shape of property checks: one check per formulation and kind, one finding each.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/measures.hpp"

#include <string>

namespace halfway::verify {

/// entry/kind/property
std::string property_name(const Entry& entry, Kind kind, const std::string& property);

/// A finding of one formulation and kind, name filled in; the caller says what was measured, held how, by
/// whom.
Draft property_finding(const Entry& entry, Kind kind, const std::string& property);

/// Adds `entry/kind/property` for every formulation, for the kinds given.
/// @param measure  (entry, kind, finding with its name) -> finding with value, limits, oracle and reason
void add_property(Checks& checks, const std::string& property, std::initializer_list<Kind> kinds,
                  const std::function<Finding(const Entry&, Kind, Draft)>& measure);

/// Holds the measured defect to rounding of what the oracle says, or to the kept band of a known failure.
Draft hold(Draft finding, const Measurement& measured, const Band& band, Oracle oracle);

}  // namespace halfway::verify
