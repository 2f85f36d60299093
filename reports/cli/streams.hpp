// Standard output and error of the commands: what could not be written makes the exit code 1.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace halfway::reports {

/// Gives closed standard streams a descriptor that refuses writes: else the next file opened would become
/// standard output, and what is printed would go into it. To be called first.
void reserve_streams();

/// Writes text as it is. Never throws: what failed is remembered.
void print(std::string_view text);  ///< on standard output
void tell(std::string_view text);   ///< on standard error, after what was printed

/// Flushes; was anything lost?
bool lost_output();

/// Control characters as a person can read them, \u001b, and nothing a terminal obeys: for text that came
/// from a file or a caller.
std::string printable(std::string_view text);

/// The same as text of HTML, XML or SVG, between tags and in attributes.
std::string escaped(std::string_view text);

}  // namespace halfway::reports
