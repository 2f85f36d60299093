// In a file of its own: versions are in the headers of what nothing else here includes.
#include "reports/history/intake/intake.hpp"

#include <Eigen/src/Core/util/Macros.h>
#include <fmt/core.h>
#include <gsl/gsl_version.h>
#include <mpfr.h>

namespace halfway::history {

std::string libraries_here() {
  return fmt::format(R"({{"Eigen":"{}.{}.{}","GSL":"{}","MPFR":"{}","fmt":"{}.{}.{}"}})", EIGEN_WORLD_VERSION,
                     EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, GSL_VERSION, MPFR_VERSION_STRING,
                     FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100);
}

}  // namespace halfway::history
