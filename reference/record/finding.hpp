// The one record that crosses from verify and bench to the reports.
#pragma once

#include "reference/record/worst.hpp"

#include <nlohmann/json_fwd.hpp>

#include <limits>
#include <string>
#include <vector>

namespace halfway::reference {

enum class Verdict { pass, fail, known_failure, left_out };

/// What a value is held against.
enum class Comparison {
  at_most,   ///< value <= limit
  at_least,  ///< value >= low
  within,    ///< low <= value <= high (a known failure's band)
  equal,     ///< |value - expected| <= limit
  report     ///< nothing: a measured number that the report shows
};

/// How the expected value was obtained (house rule: never by the code under test).
enum class Oracle {
  none,  ///< nowhere: a finding that is judged by nothing fails
  closed_form,
  fifty_digits,
  independent,
  printed,
  other_program,
  kept  ///< this code's own answer of an earlier day: it shows a change, not a mistake
};

struct Finding {
  std::string name{};         ///< formulation/kind/property or scene/formulation/output; unique
  std::string formulation{};  ///< empty when none is meant
  std::string kind{};         ///< angular, linear, linear_angular, or empty
  std::string subject{};      ///< the property or the scene
  std::string parameter{};    ///< where the worst case was: pose, load, angle; for people
  std::string replay{};       ///< a request of `halfway eval`, or a scene, that has the worst case
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing was measured
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

/// Sets the verdict from value, comparison and limits. NaN fails, and so does a limit that no oracle gave.
/// A band that is met is a known failure.
Finding judged(Finding finding);

/// Why a failed finding would fail whatever its limits are, or nothing: it measured nothing, or no oracle
/// stands behind it.
std::string missing(const Finding& finding);

/// A finding in the making, judged where it becomes one:
///   finding("invariant/angular/tangent").measured(worst).at_most(1e-15, "why").by(Oracle::independent)
class Draft {
 public:
  explicit Draft(std::string name) { f_.name = std::move(name); }

  Draft& about(std::string subject);
  Draft& of(std::string formulation, std::string kind = {});
  Draft& measured(const Measurement& worst);
  Draft& measured(double value, std::string where = {});
  Draft& in(std::string unit);
  Draft& at_most(double limit, std::string why);
  Draft& at_least(double limit, std::string why);
  Draft& within(double low, double high, std::string why);
  Draft& equal(double expected, double tolerance, std::string why);
  Draft& reported(std::string why);
  Draft& left_out(std::string why);
  Draft& by(Oracle oracle, double uncertainty = 0);

  operator Finding() const { return judged(f_); }

 private:
  Finding f_;
};

/// Findings are kept, compared and drawn by their names: none may be another's. Fails with the names given
/// twice.
Finding named_once(const std::vector<Finding>& findings);

inline Draft finding(std::string name) { return Draft(std::move(name)); }

const char* to_string(Verdict verdict);
const char* to_string(Comparison comparison);
const char* to_string(Oracle oracle);

void to_json(nlohmann::json& json, const Finding& finding);

}  // namespace halfway::reference
