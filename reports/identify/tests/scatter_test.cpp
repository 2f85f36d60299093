// Weights that were found from the same numbers as the unknowns.
#include "reference/identify/scatter.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace id = halfway::reference::identify;

namespace {

/// A mean that two samples share, each with its own scatter: channels 0 and 3.
struct CommonMean {
  std::array<int, 2> count;
  std::array<double, 2> sigma;

  id::Scatter scatter(std::array<bool, id::kChannels> found) const {
    Eigen::MatrixXd J(count[0] + count[1], 1);
    std::vector<int> channel;
    for (int i = 0; i < J.rows(); ++i) {
      const std::size_t sample = i < count[0] ? 0 : 1;
      J(i, 0) = 1 / sigma[sample];
      channel.push_back(sample == 0 ? 0 : 3);
    }
    return id::scatter_of(J, channel, found);
  }
  /// Each sample's share in the mean.
  std::array<double, 2> weights() const {
    const double a = count[0] / (sigma[0] * sigma[0]), b = count[1] / (sigma[1] * sigma[1]);
    return {a / (a + b), b / (a + b)};
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(scatter)

/// P. Meier (Biometrics 9, 1953): the variance of a common mean is 1 + 4 sum w (1 - w)/(n - 1) of what the
/// weights found say, its degrees of freedom are 1/sum w^2/(n - 1). To first order in 1/39 of samples of 40
/// and more, within which the two roads differ.
BOOST_AUTO_TEST_CASE(common_mean) {
  for (const double ratio : {1., 2., 0.3}) {
    const CommonMean mean{{40, 80}, {1, ratio}};
    const auto w = mean.weights();
    double more = 0, squares = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      more += 4 * w[i] * (1 - w[i]) / (mean.count[i] - 1);
      squares += w[i] * w[i] / (mean.count[i] - 1);
    }
    const id::Scatter found = mean.scatter({true, true, true, true});
    BOOST_TEST_CONTEXT("sigma of one over the other's: " << ratio) {
      BOOST_TEST(std::abs((found.inflation[0] - 1) / more - 1) < 1. / 39);
      BOOST_TEST(std::abs(found.degrees[0] * squares - 1) < 1. / 39);
      BOOST_TEST(std::abs(found.left[0] + found.left[3] - 119) < 1e-9);
      BOOST_TEST(found.left[1] == 0);
    }
  }
}

/// Nothing is added where weights are known, or where there is one scatter for all: it cancels.
BOOST_AUTO_TEST_CASE(weights_that_do_not_scatter) {
  const CommonMean two{{40, 80}, {1, 2}}, one{{40, 0}, {1, 1}};
  const id::Scatter known = two.scatter({});
  BOOST_TEST(known.inflation[0] == 1);
  BOOST_TEST(known.degrees[0] == 119);
  const id::Scatter alone = one.scatter({true, true, true, true});
  BOOST_TEST(std::abs(alone.inflation[0] - 1) < 1e-14);
  BOOST_TEST(std::abs(alone.degrees[0] - 39) < 1e-9);
}

/// A single number that settles the mean has no say in its own scatter, and adds none.
BOOST_AUTO_TEST_CASE(too_few_to_tell) {
  const CommonMean mean{{1, 40}, {1e-3, 1}};
  const id::Scatter found = mean.scatter({true, true, true, true});
  BOOST_TEST(found.left[0] < 0.5);
  BOOST_TEST(std::isfinite(found.inflation[0]));
  BOOST_TEST(found.inflation[0] >= 1);
}

BOOST_AUTO_TEST_SUITE_END()
