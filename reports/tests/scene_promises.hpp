// What the reader of scene files keeps for any text at all, in words where it does not.
#pragma once

#include <string>
#include <string_view>

namespace halfway::reports::test {

/// Empty, or what is wrong: a text that is neither read nor refused with its file, what is wrong and what is
/// allowed.
std::string broken_scene_promise(std::string_view text);

}  // namespace halfway::reports::test
