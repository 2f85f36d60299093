// What holds whatever text an import is given.
#pragma once

#include <string>
#include <string_view>

namespace halfway::imports::test {

/// Empty, or the promise that is broken: a refusal is one message with a line of the text and what is
/// allowed; a joint is finite, with rotations for frames and no negative stiffness, and the scene that is
/// written is our own reader's.
std::string broken_promise(std::string_view text);

}  // namespace halfway::imports::test
