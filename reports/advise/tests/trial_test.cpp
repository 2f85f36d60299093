// Random scenes, the same as of `advise_trial`, fewer of them; and that the trial notices advice that is
// wrong.
#include "reports/advise/trial/trial.hpp"
#include "reference/record/effort.hpp"
#include "reports/views/files.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>

namespace halfway::advise {
namespace {

/// How many of the first scenes are right when each advice is spoilt.
int right_of(int count, const std::function<void(Advice&)>& spoil) {
  const auto costs = trial_costs();
  int right = 0;
  for (int number = 0; number < count; ++number) right += tried(number, costs, spoil).is_right();
  return right;
}

BOOST_AUTO_TEST_SUITE(trial)

BOOST_AUTO_TEST_CASE(random_scenes) {
  const int count = reference::by_effort(24, 8);
  const auto costs = trial_costs();
  int advised = 0;
  for (int number = 0; number < count; ++number) {
    const Tried t = tried(number, costs);
    advised += !t.advised.empty();
    BOOST_TEST_CONTEXT("scene " << number << ": '" << t.advised << "' has " << t.error << " of "
                                << t.tolerance << ", cheaper '" << t.cheaper << "'")
    BOOST_TEST(t.is_right());
  }
  BOOST_TEST(advised >= count / 3);  // most have an answer
}

/// The kept result of all 200 is of today's questions, and all are right.
BOOST_AUTO_TEST_CASE(all_two_hundred) {
  const auto kept = nlohmann::json::parse(reports::read_file(HALFWAY_ADVICE_KEPT));
  BOOST_TEST(kept.at("of") == 200);
  BOOST_TEST(kept.at("right") == 200);
  int number = 0;
  for (const auto& scene : kept.at("scenes"))
    BOOST_TEST(scene.at("tolerance").get<double>() == random_question(number++).tolerance,
               boost::test_tools::tolerance(1e-12));
  BOOST_TEST(number == 200);
}

BOOST_AUTO_TEST_CASE(wrong_advice_is_noticed) {
  constexpr int kScenes = 8;
  // The cheapest whatever its error; none where there is one; a dearer one; one without a number.
  BOOST_TEST(right_of(kScenes, [](Advice& a) { a.choice = 0; }) < kScenes);
  BOOST_TEST(right_of(kScenes, [](Advice& a) { a.choice.reset(); }) < kScenes);
  BOOST_TEST(right_of(kScenes, [](Advice& a) {
               for (std::size_t i = 0; i < a.judged.size(); ++i)
                 if (a.judged[i].suffices(a.question.tolerance) && a.judged[i].cost.ns > 0) a.choice = i;
             }) < kScenes);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace halfway::advise
