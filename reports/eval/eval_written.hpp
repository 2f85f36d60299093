// The answer to a request as one line of JSON.
#pragma once

#include "reference/scene/text/document.hpp"
#include "reports/eval/eval_request.hpp"

#include <string>
#include <string_view>

namespace halfway::reports {

/// Evaluates and writes: each of what is wanted is a member, a list with an item for each pose where the
/// request has "poses". A pose of those that has no finite result is null everywhere and named in "errors".
/// Numbers have the fewest digits that give them back.
/// @param id  JSON already
/// Throws reference::Refusal [singular_pose] for the only pose of a request without "poses".
std::string written_answer(std::string_view id, const EvalRequest& request,
                           const reference::Document& document);

/// {"id", "error"}.
std::string written_refusal(std::string_view id, std::string_view code, std::string_view message,
                            std::string_view field);

}  // namespace halfway::reports
