#include "reports/check/child/child_round.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace halfway::check {
namespace {

std::string id_of_request(const std::string& line) {
  const nlohmann::json request = nlohmann::json::parse(line, nullptr, false);
  if (line.find('\n') != std::string::npos || !request.is_object() || !request.contains("id"))
    throw std::invalid_argument("a request is one line, a JSON object with an id: " + readable(line));
  return id_key(request["id"]);
}

}  // namespace

Round::Round(const std::vector<std::string>& requests) : lines_(requests), outcomes_(requests.size()) {
  for (std::size_t i = 0; i < requests.size(); ++i) {
    ids_.push_back(id_of_request(requests[i]));
    if (!number_of_.emplace(ids_[i], i).second)
      throw std::invalid_argument(fmt::format("two requests have the id {}", ids_[i]));
    waiting_.push_back(i);
  }
}

std::string Round::send_next() {
  under_way_.push_back(waiting_.front());
  waiting_.pop_front();
  return lines_[under_way_.back()] + "\n";
}

void Round::ask_again() {
  waiting_.insert(waiting_.begin(), under_way_.begin(), under_way_.end());
  under_way_.clear();
}

bool Round::settle(const std::string& id, Outcome outcome) {
  const std::size_t i = number_of_.at(id);
  const bool is_new = std::erase(under_way_, i) + std::erase(waiting_, i) > 0;
  if (!is_new && outcomes_[i].sort != Outcome::Sort::missing) return false;
  outcomes_[i] = std::move(outcome);
  return true;
}

void Round::lose_first(Lost lost, std::string words) {
  outcomes_[under_way_.front()] = {.lost = lost, .words = std::move(words)};
  under_way_.pop_front();
}

void Round::give_up(const std::string& words) {
  ask_again();
  for (const std::size_t i : waiting_) outcomes_[i] = {.lost = Lost::not_asked, .words = words};
  waiting_.clear();
}

}  // namespace halfway::check
