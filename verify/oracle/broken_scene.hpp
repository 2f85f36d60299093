// A good scene broken in one place: refused by file, line, key and what is allowed.
#pragma once

#include "verify/check.hpp"

#include <filesystem>
#include <string>

namespace halfway::verify {

struct Broken {
  const char* what;
  const char* key;  ///< with which the message must name the place
  const char* from;
  const char* to;  ///< "#!" marks the line that the message must name
};

/// Is the file refused at `place`, "LINE: KEY"?
Finding refused(const std::string& what, const std::filesystem::path& file, const std::string& place);

/// The text with its one change. Throws std::logic_error where there is nothing to change.
Finding broken_refused(std::string good, const Broken& broken);

/// Line of a place in a text, from 1.
int line_at(const std::string& text, std::size_t position);

/// The text is accepted: what breaks it is the one change.
Finding accepted(const std::string& what, const std::string& good);

}  // namespace halfway::verify
