#include "reference/record/finding.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace halfway::reference {

namespace {

bool holds(const Finding& f) {
  switch (f.comparison) {
    case Comparison::at_most:
      return f.value <= f.high;
    case Comparison::at_least:
      return f.value >= f.low;
    case Comparison::within:
      return f.low <= f.value && f.value <= f.high;
    case Comparison::equal:
      return std::abs(f.value - f.expected) <= f.high;
    case Comparison::report:
      return true;
  }
  return false;
}

}  // namespace

std::string missing(const Finding& f) {
  if (f.verdict == Verdict::left_out) return f.reason.empty() ? "left out without a reason" : "";
  if (!std::isfinite(f.value)) return "measured nothing, or no number";
  if (f.comparison != Comparison::report && f.oracle == Oracle::none) return "judged by no oracle";
  return "";
}

Finding judged(Finding f) {
  const bool fails = !missing(f).empty();
  if (f.verdict == Verdict::left_out && !fails) return f;
  const bool is_band_of_defect = f.comparison == Comparison::within;
  f.verdict = fails || !holds(f) ? Verdict::fail : is_band_of_defect ? Verdict::known_failure : Verdict::pass;
  return f;
}

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::known_failure:
      return "known_failure";
    default:
      return "left_out";
  }
}

const char* to_string(Comparison comparison) {
  switch (comparison) {
    case Comparison::at_most:
      return "at_most";
    case Comparison::at_least:
      return "at_least";
    case Comparison::within:
      return "within";
    case Comparison::equal:
      return "equal";
    default:
      return "report";
  }
}

const char* to_string(Oracle oracle) {
  switch (oracle) {
    case Oracle::none:
      return "none";
    case Oracle::closed_form:
      return "closed_form";
    case Oracle::fifty_digits:
      return "fifty_digits";
    case Oracle::independent:
      return "independent";
    case Oracle::printed:
      return "printed";
    case Oracle::other_program:
      return "other_program";
    default:
      return "kept";
  }
}

void to_json(nlohmann::json& json, const Finding& f) {
  json = {{"name", f.name},
          {"formulation", f.formulation},
          {"kind", f.kind},
          {"subject", f.subject},
          {"parameter", f.parameter},
          {"value", f.value},
          {"unit", f.unit},
          {"expected", f.expected},
          {"low", f.low},
          {"high", f.high},
          {"comparison", to_string(f.comparison)},
          {"oracle", to_string(f.oracle)},
          {"uncertainty", f.uncertainty},
          {"reason", f.reason},
          {"verdict", to_string(f.verdict)}};
  if (f.verdict == Verdict::fail && !f.replay.empty()) json["replay"] = f.replay;
}

Finding named_once(const std::vector<Finding>& findings) {
  std::set<std::string> seen, twice;
  for (const Finding& f : findings)
    if (!seen.insert(f.name).second) twice.insert(f.name);
  std::string names;
  for (const std::string& name : twice) names += (names.empty() ? "" : ", ") + name;
  return finding("records/named_once")
      .about("records")
      .measured(double(twice.size()), names)
      .in("names given twice")
      .at_most(0, "a finding is kept, compared and drawn by its name")
      .by(Oracle::closed_form);
}

}  // namespace halfway::reference
