// The one record that crosses from verify and bench to the reports.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace halfway::reference {

enum class Verdict { pass, fail, known_failure, left_out };

/// What a value is held against.
enum class Comparison {
  at_most,  ///< value <= limit
  within,   ///< low <= value <= high (a known failure's band)
  equal,    ///< |value - expected| <= limit
  report    ///< nothing: a measured number that the report shows
};

/// How the expected value was obtained (house rule: never by the code under test).
enum class Oracle { none, closed_form, fifty_digits, independent, printed, other_program };

struct Finding {
  std::string name{};         ///< formulation/kind/property or scene/formulation/output; unique
  std::string formulation{};  ///< empty when none is meant
  std::string kind{};         ///< angular, linear, linear_angular, or empty
  std::string subject{};      ///< the property or the scene
  std::string parameter{};    ///< where the worst case was: pose, load, angle; for people
  double value = 0;
  std::string unit{};
  double expected = 0;
  double low = 0;
  double high = 0;  ///< at_most and equal: the limit
  Comparison comparison = Comparison::at_most;
  Oracle oracle = Oracle::none;
  double uncertainty = 0;  ///< of the expected value, same unit
  std::string reason{};    ///< why the limit is what it is; or why it was left out
  Verdict verdict = Verdict::pass;
};

/// Sets the verdict from value, comparison and limits; NaN fails. A band that is met is a known failure.
Finding judged(Finding finding);

const char* to_string(Verdict verdict);
const char* to_string(Comparison comparison);
const char* to_string(Oracle oracle);

void to_json(nlohmann::json& json, const Finding& finding);

}  // namespace halfway::reference
