// A NaN fails, wherever among the numbers it stands.
#include "verify/oracle/worst.hpp"
#include "verify/findings.hpp"

#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

/// The NaN first, in the middle and last, each of which a plain comparison may forget.
template <class T>
int forgotten(const T& nan) {
  int count = 0;
  for (int at = 0; at < 9; ++at) {
    Eigen::Matrix<T, 3, 3> m = Eigen::Matrix<T, 3, 3>::Constant(T(2));
    m(at) = nan;
    const T worst = largest_entry<T>(m);
    count += worst == worst;
  }
  return count;
}

int forgotten_measurements() {
  int count = 0;
  for (int at = 0; at < 3; ++at) {
    Measurement worst;
    for (int i = 0; i < 3; ++i) worst.include(i == at ? std::nan("") : i, "");
    count += !std::isnan(worst.value);
  }
  return count;
}

Finding none(const char* name, int count) {
  Finding f;
  f.name = std::string("worst/") + name;
  f.subject = "worst";
  f.value = count;
  f.unit = "NaNs forgotten";
  f.comparison = Comparison::equal;
  f.oracle = Oracle::closed_form;
  f.reason = "a check that forgets a NaN cannot fail";
  return judged(f);
}

std::vector<Finding> nan_is_worst() {
  const Real50 zero(0);
  Finding judged_nan;
  judged_nan.value = std::nan("");
  judged_nan.high = 1;
  return {none("double", forgotten(std::numeric_limits<double>::quiet_NaN())),
          none("fifty_digits", forgotten(Real50(zero / zero))), none("measurement", forgotten_measurements()),
          none("judged", judged(judged_nan).verdict != Verdict::fail)};
}

}  // namespace

void worst(Checks& checks) { checks.push_back({"worst/nan", "identities", nan_is_worst}); }

}  // namespace halfway::verify
