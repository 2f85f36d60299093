// What of its energy a joint keeps: in thousands of periods of bodies, and round closed loops. Computed once,
// judged and drawn.
#pragma once

#include "reference/solve/dynamics/drift.hpp"
#include "verify/oracle/measures.hpp"

namespace halfway::verify {

/// What moves.
enum class Motion {
  clamped,  ///< a body on an angular joint to a clamped node
  free,     ///< two bodies on a linear/angular joint
  chain     ///< sixteen links
};
inline constexpr Motion kMotions[] = {Motion::clamped, Motion::free, Motion::chain};

Kind kind_of(Motion motion);
reference::dynamics::Scenario motion_scenario(const Entry& entry, Motion motion);

/// Over all periods, or fewer where the effort is quick.
const reference::dynamics::Drift& long_motion(const Entry& entry, Motion motion);

/// Work round a loop at small amplitudes, at 50 digits.
struct SmallLoops {
  LoopWork once, twice;  ///< of kSmallAmplitude, and of twice that
  double order() const;  ///< of the net work in the amplitude
};
inline constexpr double kSmallAmplitude = 1e-5;  ///< rad and m
const SmallLoops& small_loops(const Entry& entry, Kind kind);

struct WideLoop {
  double amplitude = 0;  ///< rad and m
  double relative = 0;   ///< net work over turnover
};
/// Amplitudes of 0.0125 to 0.8; the loads of doubles on a loop of 50 digits: a chart needs no more, and they
/// cost a tenth.
std::vector<WideLoop> wide_loops(const Entry& entry, Kind kind);

}  // namespace halfway::verify
