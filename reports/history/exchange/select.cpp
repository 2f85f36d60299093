#include "reports/history/exchange/exchange.hpp"

namespace halfway::history {

Selection select(const History& history, int run, const std::function<bool(const std::string&)>& is_wanted) {
  Record all = record_at(history, run);
  Selection out{.run = all.run, .series = all.series};
  for (auto& [name, exact] : all.exact)
    if (is_wanted(name)) out.exact.push_back(std::move(exact));
  for (auto& [name, timed] : all.timed)
    if (is_wanted(name)) out.timed.push_back(std::move(timed));
  return out;
}

}  // namespace halfway::history
