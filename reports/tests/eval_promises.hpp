// What `halfway eval` keeps for any line at all, in words where it does not.
#pragma once

#include <string>
#include <string_view>

namespace halfway::reports::test {

/// Empty, or what is wrong: an answer that is not one line of JSON with an id, an internal error, or a
/// reading that differs from nlohmann's, an independent parser: text that one takes for JSON and the other
/// does not, or a value.
std::string broken_promise(std::string_view line);

}  // namespace halfway::reports::test
