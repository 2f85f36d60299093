// Words for units that files use, in SI and radians.
#pragma once

#include "reports/import/record/text.hpp"

namespace halfway::imports {

struct Units {
  double length = 1;  ///< m
  double force = 1;   ///< N
  double angle = 1;   ///< rad, of abscissae; stiffnesses by keywords are per radian

  double stiffness(int strain) const { return strain < 3 ? force / length : force * length / angle; }
  double strain(int strain) const { return strain < 3 ? length : angle; }
  double stress(int strain) const { return strain < 3 ? force : force * length; }
};

/// Each refuses an unknown word, naming those that are known.
double length_unit(const Source& at);
double force_unit(const Source& at);
double angle_unit(const Source& at);

/// Of `--units`, or none: m, N, rad, which is noted.
Units units_said(const ImportOptions& options, std::string& note);

}  // namespace halfway::imports
