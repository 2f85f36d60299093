// A twisted cable: forty joints between two clamped ends, one of which is free to move. Twisted far enough, a
// cable writhes; which law its joints have decides when, and whether at all.
//
// No force acts, so each joint carries the same moment. To first order in the tilts w_i (complex, x + i y) of
// the links, joint i carries alpha w_i + beta w_{i+1} across the axis, and a rigid tilt turns the twisting
// moment M: alpha + beta = -i M. So w goes on by the factor r = -alpha/beta = 1 + i M/beta about a constant,
// and tilts with clamped ends exist where r^40 = 1: at |r| = 1, arg r = 2 pi/40. beta is the moment across on
// body b, turned by one radian across.
#include "verify/studies/programs/subject.hpp"

#include <complex>
#include <numbers>

namespace halfway::verify {
namespace {

using V = Vec3<double>;
using Complex = std::complex<double>;

constexpr int kJoints = 40;
constexpr double kBend = 3, kTwist = 1;  // N m/rad

V moment(const reference::Answerer& joint, double twist, const V& tilt) {
  reference::Ask ask;
  ask.K_m = V(kBend, kBend, kTwist).asDiagonal();
  ask.b.q = reference::times(reference::quaternion_of(tilt), reference::quaternion_of(twist * V::Unit(2)));
  return reference::part(joint(ask), 3);
}

/// r of a joint that is twisted by so much.
Complex factor(const reference::Answerer& joint, double twist) {
  constexpr double h = 1e-4;
  const V up = moment(joint, twist, h * V::Unit(0)), down = moment(joint, twist, -h * V::Unit(0));
  const Complex beta((up[0] - down[0]) / (2 * h), (up[1] - down[1]) / (2 * h));
  return Complex(1) + Complex(0, moment(joint, twist, V::Zero())[2]) / beta;
}

/// The least twist of the whole cable, rad, at which `phase`, which grows with a joint's, is 2 pi/40.
template <class Phase>
double critical(const Phase& phase) {
  double low = 0, high = 1.5;
  if (!(phase(high) > 2 * std::numbers::pi / kJoints)) return NAN;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (phase(middle) > 2 * std::numbers::pi / kJoints ? high : low) = middle;
  }
  return kJoints * low;
}

/// A joint of the rotation vector in the half-way frame: beta = (t/2)/sin(t/2) (kb - 2 kt sin(t/4)^2 - i kt
/// sin(t/2)) of the twist t; r = conj(beta)/beta.
double halfway_phase(double t) {
  const double quarter = std::sin(t / 4);
  return 2 * std::atan2(kTwist * std::sin(t / 2), kBend - 2 * kTwist * quarter * quarter);
}

/// The trace potential tr(G (1 - R)): beta = kb - kt (1 - exp(-i t))/2.
double trace_phase(double t) {
  return 2 * std::atan2(kTwist * std::sin(t) / 2, kBend - kTwist * (1 - std::cos(t)) / 2);
}

/// Curvature of the two shafts, twist about their mean: beta = kb - i kt t/2.
double rod_phase(double t) { return 2 * std::atan2(kTwist * t / 2, kBend); }

struct Cable {
  const char* joint;
  double (*phase)(double);
};
constexpr Cable kCables[] = {{"invariant", halfway_phase},
                             {"quaternion", trace_phase},
                             {"fasse", trace_phase},
                             {"abaqus_bushing", rod_phase},
                             {"newton_rod", rod_phase}};

std::vector<Finding> writhing(const Cable& c) {
  const auto answer = program_subject(c.joint);
  Measurement size;
  const double found = critical([&](double t) {
    const Complex r = factor(answer, t);
    size.include(std::abs(std::abs(r) - 1), fmt::format("twist of a joint {:.3g} rad", t));
    return std::arg(r);
  });
  constexpr const char* kWhy = "differences of 1e-4: its square, and rounding over it";
  std::vector<Finding> out{program_finding("cable/keeps_size", c.joint)
                               .measured(size)
                               .in("of |r| from 1")
                               .at_most(1e-7, kWhy)
                               .by(Oracle::closed_form)};
  out.push_back(program_finding("cable/critical_twist", c.joint)
                    .measured(found)
                    .in("rad")
                    .equal(critical(c.phase), 1e-6 * critical(c.phase), kWhy)
                    .by(Oracle::closed_form));
  return out;
}

/// A law of one node's frame has no twist at which tilts go on: |r| is not 1, r^40 never 1. In node a's axes
/// r = 1
/// + kt/kb (exp(i t) - 1), in node b's its inverse's conjugate.
std::vector<Finding> straight(const char* joint, bool of_b) {
  const auto answer = program_subject(joint);
  constexpr double t = 0.5;
  const Complex inside = 1. + kTwist / kBend * (std::exp(Complex(0, t)) - 1.);
  const Complex expected = of_b ? 1. / std::conj(inside) : inside;
  return {program_finding("cable/never_writhes", joint)
              .measured(std::abs(factor(answer, t) - expected))
              .in("of r")
              .at_most(1e-7, "differences of 1e-4: its square, and rounding over it")
              .by(Oracle::closed_form),
          program_finding("cable/size", joint)
              .measured(std::abs(std::abs(factor(answer, t)) - 1))
              .in("of |r| from 1")
              .at_least(1e-2, "so that r^40 is never 1")
              .by(Oracle::closed_form)};
}

std::vector<Finding> cables() {
  std::vector<Finding> out;
  const auto add = [&](std::vector<Finding> more) { out.insert(out.end(), more.begin(), more.end()); };
  for (const Cable& c : kCables) add(writhing(c));
  add(straight("attached_a", false));
  add(straight("attached_b", true));
  return out;
}

}  // namespace

void program_cable(Checks& checks) { checks.push_back({"programs/cable", "", cables}); }

}  // namespace halfway::verify
