#include "reports/history/statistics/medians.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace halfway::statistics;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> noise(int n) {
  std::mt19937 random(3);
  std::vector<double> out(static_cast<std::size_t>(n));
  for (double& x : out) x = std::normal_distribution<double>(100, 2)(random);
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(medians)

BOOST_AUTO_TEST_CASE(middle) {
  BOOST_TEST(median(std::vector<double>{3, 1, 2}) == 2);
  BOOST_TEST(median(std::vector<double>{4, 1, 3, 2}) == 2.5);
  BOOST_TEST(median(std::vector<double>{7}) == 7);
  BOOST_TEST(std::isnan(median(std::vector<double>{})));
  BOOST_TEST(std::isnan(median(std::vector<double>{1, kNan, 2})));
  BOOST_TEST(std::isnan(median(std::vector<double>{kNan})));
}

// As many numbers on either side, whatever the numbers.
BOOST_AUTO_TEST_CASE(half_on_either_side) {
  for (const int n : {1, 2, 5, 40, 101}) {
    const auto numbers = noise(n);
    const double m = median(numbers);
    BOOST_TEST(std::ranges::count_if(numbers, [&](double x) { return x < m; }) == n / 2);
    BOOST_TEST(std::ranges::count_if(numbers, [&](double x) { return x > m; }) == n / 2);
  }
}

BOOST_AUTO_TEST_CASE(width) {
  BOOST_TEST(spread(std::vector<double>{1, 2, 3, 4, 100}) == 1.4826, boost::test_tools::tolerance(1e-15));
  // Of 10^4 normal draws: the median distance scatters by 1.17 / sqrt(10^4), 1.2 %; five times that.
  BOOST_TEST(spread(noise(10000)) == 2.0, boost::test_tools::tolerance(0.06));
}

BOOST_AUTO_TEST_CASE(outlier_goes_and_step_stays) {
  auto series = noise(60);
  const double plain = series[20];
  series[20] = 1000;
  const auto calm = clipped(series);
  BOOST_TEST(calm[20] < 115);  // three spreads of 2, and what the local median is off
  BOOST_TEST(std::abs(calm[20] - plain) < 15);
  for (std::size_t i = 30; i < 60; ++i) series[i] += 50;
  const auto stepped = clipped(series);
  for (const std::size_t i : {28u, 29u}) BOOST_TEST(stepped[i] < 125);
  for (const std::size_t i : {30u, 31u}) BOOST_TEST(stepped[i] > 125);
  BOOST_TEST(clipped(std::vector<double>{}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
