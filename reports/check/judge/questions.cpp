#include "reports/check/judge/questions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace halfway::check {
namespace {

TwelveLoads nothing() { return TwelveLoads::Constant(std::numeric_limits<double>::quiet_NaN()); }

}  // namespace

std::string Questions::key(const Ask& ask) { return reference::request(ask).dump(); }

Answerer Questions::writer(const std::string& group) {
  return [this, group](const Ask& ask) {
    if (known_.emplace(key(ask), asks_.size()).second) {
      asks_.push_back(ask);
      answers_.emplace_back();
      ids_.push_back(fmt::format("{}/{:03}", group, ++count_[group]));
    }
    return nothing();
  };
}

Answerer Questions::reader() const {
  return [this](const Ask& ask) {
    const auto at = known_.find(key(ask));
    return at == known_.end() ? nothing() : answers_[at->second].value_or(nothing());
  };
}

}  // namespace halfway::check
