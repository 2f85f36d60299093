// Words and numbers of a text file, and how one is refused.
#pragma once

#include "reports/import/record/imported.hpp"

#include <string_view>

namespace halfway::imports {

/// "KEY = TEXT: what; allowed: ...", a reference::Refusal with the line.
[[noreturn]] void refuse(const Source& at, const std::string& what, std::string_view allowed);

/// The whole text is one finite number, also as 1.5d3.
double number_of(const Source& at);

/// Of the words between blanks, `count` of them.
std::vector<double> numbers_of(const Source& at, int count);

/// Stiffness: a number that is not negative.
double stiffness_of(const Source& at);
void check_stiffness(const Source& at, const std::vector<double>& values);

std::string upper(std::string_view text);
std::string_view trimmed(std::string_view text);

/// Lines without their ends, LF or CRLF.
std::vector<std::string_view> lines_of(std::string_view text);

/// "KEY = TEXT (line N)".
std::string named(const Source& at);

/// What scenes cannot say, unless all of it is zero.
void lose(ImportedJoint& joint, const Source& at, const std::vector<double>& values, std::string_view why);
inline constexpr const char* kNoDamping = "a scene has no damping";

}  // namespace halfway::imports
