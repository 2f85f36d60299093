// The questions of a check, written down before any is asked: whoever needs an answer asks twice, once to
// have the question put on the list and once to read what was said.
#pragma once

#include "reference/programs/ask.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halfway::check {

using reference::Answerer;
using reference::Ask;
using reference::TwelveLoads;

class Questions {
 public:
  /// Puts what it is asked on the list, under `group`/number, and answers NaN.
  Answerer writer(const std::string& group);

  /// Reads the answers; NaN where there is none.
  Answerer reader() const;

  /// Ids that never change as long as the group's questions do not: group/001, ... Equal questions stand
  /// once.
  const std::vector<std::string>& ids() const { return ids_; }
  const std::vector<Ask>& asks() const { return asks_; }

  void answer(std::size_t i, const TwelveLoads& loads) { answers_[i] = loads; }
  std::optional<TwelveLoads> answer_to(std::size_t i) const { return answers_[i]; }
  /// Index of the first that is not yet asked.
  std::size_t size() const { return asks_.size(); }

 private:
  static std::string key(const Ask& ask);

  std::vector<Ask> asks_;
  std::vector<std::string> ids_;
  std::vector<std::optional<TwelveLoads>> answers_;
  std::map<std::string, std::size_t> known_;
  std::map<std::string, int> count_;
};

}  // namespace halfway::check
