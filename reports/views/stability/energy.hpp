// Energy in motion for the report: long runs of bodies on each formulation, and work round closed loops.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// Of the studies that the findings are of:
///   scenarios  [{name, title, kind, period (s, of the slowest mode), frequencies (rad/s, ascending)}]
///   integrator {order, steps_per_fastest}
///   runs       [{formulation, scenario, potential, balanced (facts: the moments do), periods reached, steps,
///              ending (empty: all periods), largest, trend (per period) of the relative energy change,
///              linear, angular (momentum drift over that of the whole energy; null where a body is clamped),
///              samples [[period, largest |energy change| since the last sample]], at most 120}]
///   loops      [{formulation, kind, slope (of the finding loop_order; null: no net work), points
///   [{amplitude,
///              relative (net work over turnover)}]}], loads in double
nlohmann::json stability_energy_record();

}  // namespace halfway::reports
