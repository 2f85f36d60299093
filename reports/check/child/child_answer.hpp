// A line of the program under check, read: whose answer it is, and what is wrong with it.
#pragma once

#include "reports/check/child/child_lines.hpp"

#include <nlohmann/json.hpp>

namespace halfway::check {

/// Why a request has no answer.
enum class Lost {
  nothing,  ///< it has one
  timed_out,
  crashed,  ///< the program ended: by a signal, or with any exit code
  wrong_id,
  not_json,   ///< also NaN, Infinity and numbers beyond double precision
  truncated,  ///< the program ended within the line
  closed,     ///< the program closed its standard output and went on
  too_long,
  nul_byte,
  not_asked  ///< given up before its turn
};

/// What became of a request.
struct Outcome {
  enum class Sort { answered, skipped, refused, missing };
  Sort sort = Sort::missing;
  Lost lost = Lost::nothing;      ///< of a missing one
  std::string words{};            ///< skipped, refused, missing: why, for a person
  nlohmann::json line = nullptr;  ///< the answer; null of a missing one
};

/// "answered", "timed out", ...
const char* to_string(Outcome::Sort sort);
const char* to_string(Lost lost);

/// Ids are strings or numbers; 1 and 1.0 are the same, 1 and "1" are not. Of anything else, its type.
std::string id_key(const nlohmann::json& id);

struct Reading {
  bool is_answer = false;         ///< else chatter: no JSON object, nor the beginning of one; a log in JSON
  std::optional<std::string> id;  ///< its key, also where the rest of the line is broken
  Outcome outcome;                ///< if it answers the request of that id
};

/// Never throws for what the line says.
Reading read_answer(const Line& line);

}  // namespace halfway::check
