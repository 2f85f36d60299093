// advise_trial COUNT [FILE.json]: random scenes, and whether the advice is right. Exit code 1 where one is
// not.
#include "reference/face/registry.hpp"
#include "reports/advise/trial/trial.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv) try {
  using namespace halfway;
  const int count = argc > 1 ? std::atoi(argv[1]) : 0;
  if (count < 1) {
    reports::tell("usage: advise_trial COUNT [FILE.json]\n");
    return 2;
  }
  reference::complete_catalog();
  const auto costs = advise::trial_costs();
  std::vector<advise::Tried> all;
  for (int number = 0; number < count; ++number) {
    all.push_back(advise::tried(number, costs));
    const advise::Tried& t = all.back();
    if (!t.is_right())
      reports::print(
          fmt::format("WRONG {}: {} within {:g} at {:.3g} deg, ratio {:.3g}: '{}' has {:g}; cheaper: '{}'\n",
                      number, t.truth, t.tolerance, t.degrees, t.ratio, t.advised, t.error, t.cheaper));
  }
  const auto right = std::ranges::count_if(all, &advise::Tried::is_right);
  reports::print(fmt::format("{} of {} right\n", right, count));
  if (argc > 2) reports::write_file(argv[2], advise::trial_json(all).dump(1) + "\n");
  return right == count ? 0 : 1;
} catch (const std::exception& e) {
  halfway::reports::tell(fmt::format("advise_trial: {}\n", e.what()));
  return 1;
}
