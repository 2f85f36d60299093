#include "reference/record/finding.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace halfway::reference {

Finding judged(Finding f) {
  if (f.verdict == Verdict::left_out) return f;
  const bool ok = [&] {
    if (!std::isfinite(f.value)) return false;
    switch (f.comparison) {
      case Comparison::at_most:
        return f.value <= f.high;
      case Comparison::within:
        return f.low <= f.value && f.value <= f.high;
      case Comparison::equal:
        return std::abs(f.value - f.expected) <= f.high;
      case Comparison::report:
        return true;
    }
    return false;
  }();
  const bool is_band_of_defect = f.comparison == Comparison::within;
  f.verdict = !ok ? Verdict::fail : is_band_of_defect ? Verdict::known_failure : Verdict::pass;
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
    default:
      return "other_program";
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
}

}  // namespace halfway::reference
