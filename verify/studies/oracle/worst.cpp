// A NaN fails, wherever among the numbers it stands, and so does what measured or was judged by nothing.
#include "verify/oracle/worst.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace halfway::verify {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Errors have no order: std::max and the like do not compile on them.
template <class T>
concept Ordered = requires(const T& x) {
  x < x;
};
static_assert(!Ordered<Measurement> && !Ordered<Extent> && !std::is_convertible_v<Measurement, double>);

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
  int count = !std::isnan(larger(kNan, 1.)) + !std::isnan(larger(1., kNan));
  for (int at = 0; at < 3; ++at) {
    Measurement worst;
    Extent extent;
    for (int i = 0; i < 3; ++i) worst.include(i == at ? kNan : i, ""), extent.include(i == at ? kNan : i);
    count += !std::isnan(worst.value()) + !std::isnan(extent.low()) + !std::isnan(extent.high());
  }
  return count;
}

/// Folds without anything to fold.
int nothing_that_is_a_number() {
  const Eigen::MatrixXd empty(0, 0);
  return !std::isnan(Measurement().value()) + !std::isnan(Extent().low()) + !std::isnan(Extent().high()) +
         !std::isnan(Finding().value) + !std::isnan(largest_entry<double>(empty));
}

/// What keeps its values although it is no NaN.
int lost_numbers() {
  Measurement worst;
  Extent extent;
  for (const double x : {-3., -1., -2.}) worst.include(x, x == -1 ? "here" : ""), extent.include(x);
  return (worst.value() != -1) + (worst.where() != "here") + (extent.low() != -3) + (extent.high() != -1);
}

bool passes(const Finding& f) { return f.verdict != Verdict::fail; }

Finding none(const char* name, int count, const char* unit = "NaNs forgotten") {
  return finding(std::string("worst/") + name)
      .about("worst")
      .measured(tapped(double(count)))
      .in(unit)
      .equal(0, 0, "a check that forgets a NaN cannot fail")
      .by(Oracle::closed_form);
}

std::vector<Finding> nan_is_worst() {
  const Real50 zero(0);
  const auto draft = [] { return finding("x"); };
  const int judged_nan = passes(draft().measured(kNan).at_most(1, "").by(Oracle::closed_form)) +
                         passes(draft().measured(kNan).reported(""));
  const int judged_nothing = passes(draft().at_most(1, "").by(Oracle::closed_form)) +
                             passes(draft().measured(Measurement()).at_most(1, "").by(Oracle::closed_form)) +
                             passes(draft().reported("")) + passes(draft().left_out(""));
  const int by_nobody =
      passes(draft().measured(0).at_most(1, "")) + passes(draft().measured(0).equal(0, 1, "")) +
      passes(draft().measured(1).at_least(0, "")) + passes(draft().measured(0).within(-1, 1, ""));
  const int in_vain = !passes(draft().measured(0).at_most(1, "").by(Oracle::closed_form)) +
                      !passes(draft().measured(1).at_least(0, "").by(Oracle::kept)) +
                      !passes(draft().measured(0).reported("")) + !passes(draft().left_out("why"));
  return {
      none("double", forgotten(kNan)),
      none("fifty_digits", forgotten(Real50(zero / zero))),
      none("measurement", forgotten_measurements()),
      none("judged", judged_nan),
      none("nothing_measured", nothing_that_is_a_number() + judged_nothing, "empty measurements that pass"),
      none("no_oracle", by_nobody, "findings that pass though judged by nobody"),
      none("numbers_kept", lost_numbers() + in_vain, "sound ones that fail")};
}

}  // namespace

void worst(Checks& checks) { checks.push_back({"worst/nan", "identities", nan_is_worst}); }

}  // namespace halfway::verify
