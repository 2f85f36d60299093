// The second-order fingerprint (alpha, beta) of the angular joint.
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

constexpr double kResolution = 1e-9;
constexpr const char* kResolutionReason =
    "second differences at 50 digits resolve the coefficients to better than 1e-9";

using Coefficient = double Fingerprint::*;

Finding coefficient(const Entry& entry, Draft f, Coefficient member, double expected) {
  const Fingerprint print = fingerprint(under_test(entry), entry.probe_xi);
  f.in("-");
  if (!entry.facts.has_fingerprint)
    return f.measured(print.residual)
        .within(0.05, 2,
                "the second-order part is not of the (alpha, beta) form; the value is its relative remainder")
        .by(Oracle::kept);
  return f
      .measured(print.residual < kResolution ? print.*member : std::nan(""),
                fmt::format("remainder of the form {:.2g}", print.residual))
      .equal(expected, kResolution, kResolutionReason)
      .by(Oracle::closed_form);
}

}  // namespace

void second_order_fingerprint(Checks& checks) {
  add_property(checks, "fingerprint_alpha", {Kind::angular}, [](const Entry& entry, Kind, Draft f) {
    return coefficient(entry, f, &Fingerprint::alpha, entry.facts.alpha);
  });
  add_property(checks, "fingerprint_beta", {Kind::angular}, [](const Entry& entry, Kind, Draft f) {
    return coefficient(entry, f, &Fingerprint::beta, entry.facts.beta);
  });
}

}  // namespace halfway::verify
