// Flutter seen: the full nonlinear motion grows above the critical moment at the rate of the eigenvalue, and
// stays where it is below.
#include "reference/solve/stability/kind_motion.hpp"
#include "verify/oracle/property.hpp"
#include "verify/studies/stability/block_loads.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using namespace reference;

constexpr int kAxis = 2;  // the stiffest of the block: most formulations flutter about it
constexpr int kPoints = 400, kLast = 100;

MotionRequest request_of(const Entry& entry) {
  return {&entry, block_joint(entry), kAxis, {MomentType::fixed, false}, kLong, 0};
}

/// Where flutter begins, if it is the first instability: beyond a divergence motions leave in another way.
std::optional<double> flutter_angle(const MotionRequest& r) {
  const auto& c = begun_loads(*r.entry, r.axis, r.setting, r.body);
  if (c.first() != StabilityKind::flutter) return std::nullopt;
  return double(c.flutter->angle);
}

constexpr const char* kNone = "no flutter under a fixed moment about axis 3 of the block of C3";

Finding growth_above(const Entry& entry, Kind, Draft f) {
  MotionRequest r = request_of(entry);
  const auto critical = flutter_angle(r);
  if (!critical) return f.left_out(kNone);
  r.angle = 1.01 * *critical;
  const double expected = block_modes(entry, r.axis, r.setting, r.body, r.angle).growth;
  const double until = std::log(1e3) / expected;  // from 1e-6 to 1e-3 rad, where it is linear to 1e-3
  const auto mode = dominating_mode(disturbed_motion(r, until, kPoints), kLast);
  return f.measured(mode ? mode->real() : std::nan(""), "1 % above the critical angle")
      .in("1/s")
      .equal(expected, 0.01 * expected,
             "modes that do not grow are 1e-2 of the growing one by then, and are fitted with it")
      .by(Oracle::independent);
}

Finding rest_below(const Entry& entry, Kind, Draft f) {
  MotionRequest r = request_of(entry);
  const auto critical = flutter_angle(r);
  if (!critical) return f.left_out(kNone);
  r.angle = 0.99 * *critical;
  const auto history = disturbed_motion(r, 20, kPoints);
  Measurement worst;
  for (const auto& theta : history.theta) worst.include(theta.norm(), "1 % below the critical angle, 20 s");
  if (!history.finished) worst.include(std::nan(""), "the motion ends before 20 s");
  return f.measured(worst)
      .in("rad")
      .at_most(
          2e-5,
          "nearly parallel modes raise 1e-6 rad by 1/sqrt(distance from the meeting), about 10; the growth "
          "rate of 1 % above would raise it by 1e10")
      .by(Oracle::independent);
}

}  // namespace

void stability_kind_motion(Checks& checks) {
  add_property(checks, "flutter_growth", {Kind::angular}, growth_above);
  add_property(checks, "rest_below_flutter", {Kind::angular}, rest_below);
}

}  // namespace halfway::verify
