// Laws as files say them: what is measured has gone through the reader.
#pragma once

#include "reference/scene/scene.hpp"

#include <string>

namespace halfway::verify {

/// A scene of one joint: these lines stand in [joint] and in [joint.law].
reference::Scene scene_of_law(Kind kind, const std::string& law, const std::string& joint = "");

/// An angular law with that curve about each axis; keys of one table [[joint.law.axis]].
std::string thrice(const std::string& axis);

/// "[1, 2, 3]", digits that give the numbers back.
std::string list_text(const std::vector<double>& numbers);

}  // namespace halfway::verify
