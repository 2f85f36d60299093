// The requests of one ask(): which wait, which are under way, what became of the others.
#pragma once

#include "reports/check/child/child_answer.hpp"

#include <deque>
#include <map>
#include <vector>

namespace halfway::check {

class Round {
 public:
  /// @param requests  JSON objects, a line each, with ids that differ; else std::invalid_argument
  explicit Round(const std::vector<std::string>& requests);

  bool is_done() const { return waiting_.empty() && under_way_.empty(); }
  bool any_waiting() const { return !waiting_.empty(); }
  std::size_t under_way() const { return under_way_.size(); }
  bool knows(const std::string& id) const { return number_of_.contains(id); }
  /// The id of the first under way.
  const std::string& first() const { return ids_[under_way_.front()]; }

  /// The next line to write, its end included; it is under way from then on.
  std::string send_next();
  /// Those under way wait again, before the others.
  void ask_again();

  /// An answer to a request that has none: under way, waiting again, or lost before.
  /// @return  false for a second answer
  bool settle(const std::string& id, Outcome outcome);
  /// The first under way has no answer.
  void lose_first(Lost lost, std::string words);
  /// Nor has any that is left.
  void give_up(const std::string& words);

  const std::vector<std::string>& ids() const { return ids_; }
  const std::vector<Outcome>& outcomes() const { return outcomes_; }

 private:
  std::vector<std::string> lines_, ids_;
  std::vector<Outcome> outcomes_;
  std::map<std::string, std::size_t> number_of_;
  std::deque<std::size_t> waiting_, under_way_;
};

}  // namespace halfway::check
