// A study's numbers are computed once in a process: its findings and its series are of the same ones.
#pragma once

#include "reference/face/registry.hpp"

#include <map>
#include <tuple>

namespace halfway::verify {

/// What was computed of each formulation, by whatever else the question depends on. A wrong twin is another
/// entry, asked for in a process of its own (run_apart), so that nothing of a healthy one answers for it.
template <class Value, class... Key>
class Once {
 public:
  template <class Compute>
  const Value& operator()(const reference::Entry& entry, const Key&... key, const Compute& compute) {
    const std::tuple<const reference::Entry*, Key...> at{&entry, key...};
    const auto known = kept_.find(at);
    return known != kept_.end() ? known->second : kept_.emplace(at, compute()).first->second;
  }

 private:
  std::map<std::tuple<const reference::Entry*, Key...>, Value> kept_;
};

}  // namespace halfway::verify
