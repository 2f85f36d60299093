// How often the intervals of `halfway identify` hold the truth: the command behind
// reference/data/identify/coverage.json.
#include "reference/identify/coverage.hpp"
#include "reports/views/files.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <future>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  using namespace halfway;
  namespace id = reference::identify;
  if (argc != 3 || std::atoi(argv[1]) < 1) {
    std::fputs("usage: halfway_identify_coverage TRIALS FILE.json\n", stderr);
    return 2;
  }
  const int trials = std::atoi(argv[1]);
  nlohmann::ordered_json out = {
      {"made_by", "halfway_identify_coverage"}, {"trials", trials}, {"confidence", 0.95}};
  std::vector<std::future<std::vector<id::Coverage>>> counts;
  for (const std::string& name : id::bench_names())
    counts.push_back(
        std::async(std::launch::async, [name, trials] { return id::coverage(id::bench(name), trials); }));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string& name = id::bench_names()[i];
    for (const id::Coverage& one : counts[i].get()) {
      out["benches"][name].push_back({{"quantity", one.quantity},
                                      {"identified", one.trials},
                                      {"covered", one.covered},
                                      {"share", one.share()}});
      std::printf("%-9s %-52s %5d of %5d: %.3f\n", name.c_str(), one.quantity.c_str(), one.covered,
                  one.trials, one.share());
    }
    std::fflush(stdout);
  }
  reports::write_file(argv[2], out.dump(1) + "\n");
  return 0;
}
