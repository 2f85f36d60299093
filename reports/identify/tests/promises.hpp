// What holds whatever text an identification is given.
#pragma once

#include <string>
#include <string_view>

namespace halfway::reports::test {

/// Empty, or the promise that is broken: a refusal is one short message with a line of the text; what is read
/// has a case or more, rows of loads and motions each, all of them finite, and no noise below zero.
std::string broken_promise(std::string_view text);

}  // namespace halfway::reports::test
