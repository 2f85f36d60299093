// Ranks: every arrangement counted, closed forms, and mutants that these would catch.
#include "reports/history/statistics/rank_test.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

using namespace halfway::statistics;

namespace {

using Numbers = std::vector<double>;
using Test = std::function<double(const Numbers&, const Numbers&)>;

/// Pairs (x, y) with y above x, ties as one half: Mann and Whitney's own definition, without ranks.
double pairs_above(const Numbers& a, const Numbers& b) {
  double u = 0;
  for (const double x : a)
    for (const double y : b) u += y > x ? 1 : y == x ? 0.5 : 0;
  return u;
}

/// Over every way to call n of the numbers `b`: how often are there at least as many pairs?
double by_counting(const Numbers& a, const Numbers& b) {
  Numbers all = a;
  all.insert(all.end(), b.begin(), b.end());
  const double seen = pairs_above(a, b);
  int ways = 0, beyond = 0;
  for (unsigned set = 0; set < 1u << all.size(); ++set) {
    if (std::popcount(set) != int(b.size())) continue;
    Numbers left, right;
    for (std::size_t i = 0; i < all.size(); ++i) (set >> i & 1 ? right : left).push_back(all[i]);
    ++ways, beyond += pairs_above(left, right) >= seen;
  }
  return double(beyond) / ways;
}

/// Groups of 1 to 6, with many ties and with none.
bool agrees(const Test& test) {
  std::mt19937 random(1947);
  for (int draw = 0; draw < 60; ++draw) {
    const bool tied = draw % 2 == 0;
    const auto number = [&] {
      return tied ? double(random() % 4) : std::uniform_real_distribution<double>()(random);
    };
    Numbers a(1 + random() % 6), b(1 + random() % 6);
    for (double& x : a) x = number();
    for (double& x : b) x = number() + (draw % 3 == 0 ? 0.3 : 0);
    // Both count whole numbers below 2^53: what is left are the roundings of one division and its sums.
    if (!(std::abs(test(a, b) - by_counting(a, b)) < 1e-14)) return false;
  }
  return true;
}

double chance(const Numbers& a, const Numbers& b) { return chance_of_higher(a, b); }

double normal(double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); }

/// [0, 1, ..., n - 1] + shift
Numbers counted(int n, double shift) {
  Numbers out;
  for (int i = 0; i < n; ++i) out.push_back(i + shift);
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ranks)

BOOST_AUTO_TEST_CASE(every_arrangement) { BOOST_TEST(agrees(chance)); }

BOOST_AUTO_TEST_CASE(mutants_are_caught) {
  const Test strictly_above = [](const Numbers& a, const Numbers& b) { return 1 - chance(b, a); };
  const Test other_side = [](const Numbers& a, const Numbers& b) { return chance(b, a); };
  const Test two_sided = [](const Numbers& a, const Numbers& b) { return chance_of_difference(a, b); };
  const Test ties_in_order = [](const Numbers& a, Numbers b) {
    for (double& x : b) x += 1e-9;  // an equal number ranks above
    return chance(a, b);
  };
  const Test approximate = [](const Numbers& a, const Numbers& b) {
    const double m = double(a.size()), n = double(b.size());
    return normal((pairs_above(a, b) - m * n / 2 - 0.5) / std::sqrt(m * n * (m + n + 1) / 12));
  };
  for (const Test& mutant : {strictly_above, other_side, two_sided, ties_in_order, approximate})
    BOOST_TEST(!agrees(mutant));
}

// Either way, by the definition: twice the smaller of both. Groups of 1 to 60, few different numbers or many.
BOOST_AUTO_TEST_CASE(either_way) {
  std::mt19937 random(50);
  for (int draw = 0; draw < 400; ++draw) {
    const int different = draw % 4 == 0 ? 2 : draw % 4 == 1 ? 9 : draw % 4 == 2 ? 80 : 1 << 30;
    Numbers a(1 + random() % 60), b(1 + random() % 60);
    for (double& x : a) x = double(random() % unsigned(different));
    for (double& x : b) x = double(random() % unsigned(different)) + (draw % 3 - 1) * different / 6;
    const double least = std::min(chance(a, b), chance(b, a));
    // Sums of up to 3000 numbers of ways, each with a rounding of its own.
    BOOST_TEST(chance_of_difference(a, b) == std::min(1.0, 2 * least), boost::test_tools::tolerance(1e-13));
    BOOST_TEST(chance_of_difference(b, a) == chance_of_difference(a, b), boost::test_tools::tolerance(1e-13));
  }
}

// The k-th largest sum of ranks is reached in as many ways as k - 1 has partitions, while k is small.
BOOST_AUTO_TEST_CASE(partitions) {
  constexpr double ways[] = {1, 2, 4, 7, 12, 19, 30, 45};  // sums of 1, 1, 2, 3, 5, 7, 11, 15
  constexpr double all = 48620;                            // 18 over 9
  for (int u = 0; u < 8; ++u) {
    Numbers a = counted(9, 0), b = counted(9, 100);
    b[0] = 8.5 - u;  // below u of a
    BOOST_TEST(chance(a, b) == ways[u] / all, boost::test_tools::tolerance(1e-14));
  }
}

// 50 and 50, fully apart: one way in 100 over 50.
BOOST_AUTO_TEST_CASE(largest_exact) {
  const double ways = std::exp(std::lgamma(101) - 2 * std::lgamma(51));
  // lgamma of 363 is known to an ulp of it: 6e-14.
  BOOST_TEST(chance(counted(50, 0), counted(50, 50)) * ways == 1.0, boost::test_tools::tolerance(1e-12));
}

// Beyond 100 numbers. Near the middle the approximation is good to its next term, about 1 / (5 N).
BOOST_AUTO_TEST_CASE(many) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  Numbers a(50), b(50);
  for (double& x : a) x = noise(random);
  for (double& x : b) x = noise(random) + 0.4;
  const double exact = chance(a, b);
  a.push_back(-9), b.push_back(9);
  a.push_back(9), b.push_back(-9);
  BOOST_TEST(chance(a, b) == exact, boost::test_tools::tolerance(0.25));
  BOOST_TEST(exact < 0.1);
  BOOST_TEST(chance(Numbers(80, 1.0), Numbers(80, 1.0)) == 1.0);
  // All but two tie, by hand: one of b is above all 80, the 79 others above one; 79 * 79 pairs are equal.
  Numbers low(80, 1.0), high(80, 1.0);
  low[0] = 0, high[0] = 2;
  const double ties = 158.0 * 158 * 158 - 158, variance = 80 * 80 / 12.0 * (161 - ties / (160 * 159.0));
  const double u = 80 + 79 + 79 * 79 / 2.0;
  BOOST_TEST(chance(low, high) == normal((u - 3200 - 0.5) / std::sqrt(variance)),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(chance({}, {1}), std::invalid_argument);
  BOOST_CHECK_THROW(chance({1}, {}), std::invalid_argument);
  BOOST_CHECK_THROW(chance({1, nan}, {1, 2}), std::invalid_argument);
  BOOST_CHECK_THROW(chance({1}, {nan}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
