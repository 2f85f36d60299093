// Springs as nobody tries them first: coupled, along other axes, a million million times stiffer one way than
// another. Against the law that the joint was told to be.
#pragma once

#include "reports/check/judge/examine.hpp"

namespace halfway::check {

/// @param joint  in our convention
/// @param law    the joint that it is known to be; without one all is left out
std::vector<Result> examine_springs(const Answerer& joint, const Hello& hello,
                                    const std::optional<reference::Candidate>& law);

}  // namespace halfway::check
