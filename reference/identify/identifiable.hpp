// A fit of what the data determine, and in words why the rest cannot be.
#pragma once

#include "reference/identify/fit.hpp"

#include <string>
#include <vector>

namespace halfway::reference::identify {

/// An unknown that was left out of a fit: it keeps the value that the fit began with.
struct Dropped {
  int place;
  double deviation;  ///< standard deviation that it had, in its own unit
};

/// The same in words.
struct LeftOpen {
  int place;
  std::string what;  ///< "xi of moments 2-3"
  std::string reason;
};

/// "stiffness about axis 2", "xi of moments 1-3", ...
std::string name_of(int place);

/// Why the data tell nothing of translations (first = 0) or rotations (first = 3); empty: they do.
std::string why_none(const Data& data, int first);

/// Fits; leaves out, one at a time, what has no effect or stays uncertain by more than half of itself (xi: by
/// 0.5; axes: by 20 degrees), and fits again.
/// @param sigma  as of fit()
Fit fit_identifiable(const Data& data, const MakeModel& make, const Unknowns& start, Freedom freedom,
                     const std::array<double, kChannels>& sigma, std::vector<Dropped>& left_open);

/// Of `freedom` what the data do not tell by small motion: what acts at second order alone would stand on
/// assumptions.
std::vector<Dropped> open_at_small_motion(const Data& data, const MakeModel& make, const Unknowns& start,
                                          Freedom freedom);

/// Why an unknown is open.
/// @param fit  the last fit of it, or of all but it; `frame` is that of the unknowns
std::string reason_of(const Dropped& one, const Data& data, const Frame& frame, const Fit& fit,
                      const MakeModel& make);

}  // namespace halfway::reference::identify
