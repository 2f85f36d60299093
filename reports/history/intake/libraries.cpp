// In a file of its own: versions are in the headers of what nothing else here includes.
#include "reports/history/intake/intake.hpp"

#include <Eigen/src/Core/util/Macros.h>
#include <fmt/core.h>
#include <gsl/gsl_version.h>
#include <boost/version.hpp>

namespace halfway::history {

std::string libraries_here() {
  return fmt::format(R"({{"Boost":"{}.{}.{}","Eigen":"{}.{}.{}","GSL":"{}","fmt":"{}.{}.{}"}})",
                     BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100,
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, GSL_VERSION,
                     FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100);
}

}  // namespace halfway::history
