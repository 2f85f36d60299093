// The second-order fingerprint (alpha, beta) of the angular joint.
#include "verify/oracle/property.hpp"

namespace halfway::verify {
namespace {

constexpr double kResolution = 1e-9;
constexpr const char* kResolutionReason =
    "second differences at 50 digits resolve the coefficients to better than 1e-9";

using Coefficient = double Fingerprint::*;

Finding coefficient(const Entry& entry, Finding f, Coefficient member, double expected) {
  const Fingerprint print = fingerprint(of(entry), entry.probe_xi);
  f.unit = "-";
  if (!entry.facts.has_fingerprint) {
    f.value = print.residual;
    f.comparison = Comparison::within;
    f.low = 0.05;
    f.high = 2;
    f.reason = "the second-order part is not of the (alpha, beta) form; the value is its relative remainder";
    return f;
  }
  f.value = print.*member;
  f.comparison = Comparison::equal;
  f.expected = expected;
  f.high = print.residual < kResolution ? kResolution : 0;
  f.oracle = Oracle::closed_form;
  f.reason = kResolutionReason;
  return f;
}

}  // namespace

void second_order_fingerprint(Checks& checks) {
  add_property(checks, "fingerprint_alpha", {Kind::angular}, [](const Entry& entry, Kind, Finding f) {
    return coefficient(entry, f, &Fingerprint::alpha, entry.facts.alpha);
  });
  add_property(checks, "fingerprint_beta", {Kind::angular}, [](const Entry& entry, Kind, Finding f) {
    return coefficient(entry, f, &Fingerprint::beta, entry.facts.beta);
  });
}

}  // namespace halfway::verify
