// Curves of the samples and of texts, identified.
#pragma once

#include "reports/identify/results.hpp"

#include <string>

namespace halfway::reports::tests {

/// A file of reports/identify/samples.
std::string sample(const std::string& name);

/// A file of reference/data/fe or of import's samples, as text.
std::string fe_result(const std::string& name);
std::string bushing(const std::string& name);

/// What a text is refused with; empty: it is not.
std::string refusal_of(const std::string& text);

Identified identified(const std::string& text, const std::string& law = "");

}  // namespace halfway::reports::tests
