// What real programs answered, kept below data/programs.
#pragma once

#include "reference/programs/ask.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

struct MeasuredPose {
  int id = 0;
  Ask ask;
  TwelveLoads loads;  ///< internal, as everywhere here: the files have the opposite, loads on the bodies
};

struct MeasuredProgram {
  std::string program, version, how;
  std::vector<MeasuredPose> poses;
};

/// @param name  of data/programs/NAME.json. Throws DataError.
MeasuredProgram read_measured(const std::string& name);

}  // namespace halfway::reference
