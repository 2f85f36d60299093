#include "reports/history/statistics/changes.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace halfway::statistics;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Exact error(double value, double limit = 1e-12, Verdict verdict = Verdict::pass) {
  return {.value = value, .error = value, .limit = limit, .verdict = verdict};
}
Exact counted(double value) { return {.value = value, .is_count = true}; }

/// "+" improvement, "-" regression, "~" change, "=" the same.
char sense(const Exact& before, const Exact& after) {
  const auto change = exact_change(before, after);
  if (!change) return '=';
  return change->sense == Sense::improvement ? '+' : change->sense == Sense::regression ? '-' : '~';
}

}  // namespace

BOOST_AUTO_TEST_SUITE(exact)

BOOST_AUTO_TEST_CASE(verdicts_count_first) {
  BOOST_TEST(sense(error(1e-13), error(1e-11, 1e-12, Verdict::fail)) == '-');
  BOOST_TEST(sense(error(1e-11, 1e-12, Verdict::fail), error(1e-13)) == '+');
  BOOST_TEST(sense(error(1e-13), error(1e-13, 1e-12, Verdict::known_failure)) == '-');
  BOOST_TEST(sense(error(1e-13), error(kNan, 1e-12, Verdict::left_out)) == '-');
  BOOST_TEST(exact_change(error(1e-13), error(1e-11, 1e-12, Verdict::fail))->text ==
             "pass -> fail; 1e-13 -> 1e-11");
  for (const char* text : {"pass", "known_failure", "left_out", "fail"})
    BOOST_TEST(to_string(verdict_of(text)) == text);
  BOOST_TEST((verdict_of("PASS") == Verdict::fail));
}

BOOST_AUTO_TEST_CASE(limits) {
  BOOST_TEST(sense(error(1e-13, 1e-12), error(1e-13, 1e-10)) == '-');
  BOOST_TEST(sense(error(1e-13, 1e-12), error(1e-13, 1e-13)) == '+');
  BOOST_TEST(sense(error(1e-13, 1e-12), error(1e-13, kNan)) == '-');  // no limit holds it any more
  BOOST_TEST(sense(error(1e-13, kNan), error(1e-13, 1e-12)) == '+');
}

BOOST_AUTO_TEST_CASE(digits_and_never_ratios) {
  BOOST_TEST(sense(error(1.1e-13), error(3.3e-13)) == '~');  // a ratio of 3
  BOOST_TEST(sense(error(1.1e-16, 1e-14), error(3.3e-16, 1e-14)) == '~');
  BOOST_TEST(sense(error(1e-14), error(1e-13)) == '-');
  BOOST_TEST(sense(error(1e-13), error(1e-14)) == '+');
  BOOST_TEST(sense(error(1e-30), error(1e-16)) == '~');  // both far below what the limit resolves
  BOOST_TEST(sense(error(0), error(5e-15)) == '~');
  BOOST_TEST(sense(error(0), error(1e-13)) == '-');
  BOOST_TEST(sense(error(1e-13), error(1e-13)) == '=');
  BOOST_TEST(digits_gained(error(1e-13), error(2e-12)) == -std::log10(20.0),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(exact_change(error(1e-14), error(1e-13))->text == "1e-14 -> 1e-13, 1.0 digits lost");
  // Without a limit eps is what counts.
  BOOST_TEST(sense(error(1e-18, kNan), error(2e-16, kNan)) == '~');
  BOOST_TEST(sense(error(1e-16, kNan), error(1e-14, kNan)) == '-');
  // A value without an error is shown, not judged.
  BOOST_TEST(sense({.value = 5}, {.value = 50}) == '~');
}

BOOST_AUTO_TEST_CASE(nothing_measured) {
  BOOST_TEST(sense(error(1e-13), error(kNan)) == '-');
  BOOST_TEST(sense(error(kNan), error(1e-13)) == '+');
  BOOST_TEST(sense(error(kNan), error(kNan)) == '=');
  BOOST_TEST(sense(counted(3), counted(kNan)) == '-');
}

BOOST_AUTO_TEST_CASE(counts) {
  BOOST_TEST(sense(counted(306.75), counted(306.5)) == '+');
  BOOST_TEST(sense(counted(306.5), counted(306.75)) == '-');
  BOOST_TEST(sense(counted(306.5), counted(306.5)) == '=');
}

// Three times 0.4 digits: no single commit lost one, all of them together did.
BOOST_AUTO_TEST_CASE(digits_lost_in_parts) {
  std::vector<Exact> readings;
  for (const double digits : {0.0, 0.0, 0.4, 0.8, 1.2, 1.2, 1.6})
    readings.push_back(error(1e-14 * std::pow(10, digits)));
  const auto changes = find_changes(readings);
  BOOST_REQUIRE(changes.size() == 4u);
  const Sense senses[] = {Sense::change, Sense::change, Sense::regression, Sense::change};
  const std::size_t runs[] = {2, 3, 4, 6};
  for (std::size_t i = 0; i < 4; ++i) {
    BOOST_TEST((changes[i].sense == senses[i]));
    BOOST_TEST(changes[i].run == runs[i]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
