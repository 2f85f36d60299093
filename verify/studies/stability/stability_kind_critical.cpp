// Critical moments of the block of C3 about each axis: divergence and flutter, against the references of the
// scene, the zeros of the determinant, and the eigenvalues of another library.
#include "reference/solve/buckling.hpp"
#include "reference/solve/stability/critical_zeros.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/stability/block_loads.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace halfway::verify {
namespace {

using namespace reference;

Finding zero(const std::string& what, const std::optional<Real50>& found, const Real50& expected) {
  return finding("stability_kind/zeros/" + what)
      .about("stability_kind")
      .measured(found ? double(abs(tapped(*found) - expected)) : std::nan(""))
      .in("rad")
      .at_most(1e-41, "the search ends at steps of 1e-42 rad")
      .by(Oracle::closed_form);
}

/// What the search for critical loads must tell apart: a zero, a pole, and a zero that is only touched.
std::vector<Finding> zeros() {
  const Real50 one(1), meeting(0.75), pass(0.5);
  const auto parabola = [&](const Real50& x) { return Signed<Real50>{Real50(2) - x * x, one}; };
  const auto pole = [&](const Real50& x) { return Signed<Real50>{one / (sqrt(Real50(2)) - x), one}; };
  const auto touching = [&](const Real50& x) {
    return Signed<Real50>{(x - pass) * (x - pass) * (meeting - x), one};
  };
  // Two roots that become negative one after the other, at once, and a sum of products that is negative
  // alone.
  const Real50 first("0.9990"), second("1.0005");
  const auto two = [&](const Real50& x) { return Signed<Real50>{(first - x) * (second - x), one}; };
  const auto twice = [&](const Real50& x) { return Signed<Real50>{(one - x) * (one - x), one}; };
  const auto sum = [&](const Real50& x) { return Signed<Real50>{first + second - x - x, one}; };
  const auto falling = [&](const Real50& x) { return Signed<Real50>{one - x, one}; };
  const auto above = [&](const Real50& x) { return Signed<Real50>{one + x * x, one}; };
  const auto at_once = [&](const Real50& x) { return Signed<Real50>{-x * x, one}; };
  const Finding none = finding("stability_kind/zeros/pole")
                           .about("stability_kind")
                           .measured(sign_change(pole, 1.25, 1.5) || first_negative(pole, 0.25, 1.5) ? 1 : 0)
                           .in("zeros found")
                           .at_most(0, "1/(sqrt 2 - x) changes its sign and has no zero")
                           .by(Oracle::closed_form);
  return {zero("simple", sign_change(parabola, 1.25, 1.5), sqrt(Real50(2))),
          none,
          zero("touched", first_negative(touching, 0.5625, 0.8125), meeting),
          zero("at_once", first_negative(at_once, 0.125, 0.125), Real50(0)),
          zero("double", double_zero(twice, falling, 0.75, 1.25), one),
          zero("two_in_a_row", double_zero(two, sum, 0.75, 1.25), first),
          finding("stability_kind/zeros/no_double")
              .about("stability_kind")
              .measured(double_zero(above, falling, 0.75, 1.25) ? 1 : 0)
              .in("zeros found")
              .at_most(0, "a determinant that stays above 1 has no zero")
              .by(Oracle::closed_form)};
}

/// Turned by phi about its stiff axis, a quaternion joint answers with M = k sin(phi): at a right angle it
/// loses its hold about that axis and, for K = (2, 1, 3) under a semi-tangential moment, across it at the
/// same load.
std::vector<Finding> two_at_once() {
  JointSpec spec;
  spec.law = LinearSpec{Vec3<double>(2, 1, 3).asDiagonal(), false};
  const auto found = PrimaryPath(*find_formulation("quaternion"), spec, 0)
                         .critical({MomentType::semi_tangential, false}, kRound)
                         .divergence;
  return {finding("stability_kind/two_at_once/quaternion")
              .of("quaternion")
              .about("stability_kind")
              .measured(found ? double(abs(tapped(found->load) - Real50(2))) : std::nan(""))
              .in("N m")
              .at_most(1e-38, "the angle is located to 1e-42 rad, and the moment is at its largest there")
              .by(Oracle::closed_form)};
}

/// The seven values of C3, as the scene has them.
std::vector<Finding> c3_values() {
  std::vector<Finding> out;
  const Scene& s = scene(kBlockScene);
  for (const SceneReference& r : s.references) {
    if (r.output != "critical_moment") continue;
    const Entry& entry = *find_formulation(r.formulation);
    const auto& found = begun_loads(entry, s.critical_axis - 1, kFixed, kRound);
    const double expected = r.none ? 0 : double(Real50(r.value.c_str()));
    out.push_back(
        finding("stability_kind/c3/" + r.formulation)
            .of(r.formulation)
            .about("stability_kind")
            .measured(found.divergence ? double(found.divergence->load) : 0,
                      r.none ? std::string("searched up to ") + to_string(found.end) : "")
            .in("N m")
            .equal(expected, r.tolerance * std::abs(expected), r.none ? "none, shown as 0" : r.reason)
            .by(r.oracle));
  }
  return out;
}

/// The determinant's zeros by bisection of the fixed-moment tangent alone.
Finding second_road(const Entry& entry, Kind, Draft f) {
  Measurement worst;
  std::string without;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& ours = begun_loads(entry, axis, kFixed, kRound);
    std::optional<Critical> theirs;
    if (const auto found = first_buckling(entry, block_joint(entry), axis)) {
      if (double(found->angle) < ours.end_angle) theirs = Critical{found->moment, found->angle};
    }
    const std::string at = "axis " + std::to_string(axis + 1);
    if (!ours.divergence && !theirs) {
      without += (without.empty() ? "" : ", ") + at + " (up to " + to_string(ours.end) + ")";
      continue;
    }
    const bool both = ours.divergence && theirs;
    worst.include(both ? relative(ours.divergence->load, theirs->load) : std::nan(""), at);
  }
  if (worst.is_empty())
    return f.left_out("nothing to compare: neither road finds a divergence about " + without);
  const std::string none = without.empty() ? "" : "; none by both roads about " + without;
  return f.measured(worst.value(), worst.where() + none)
      .in("relative")
      .at_most(1e-40, "both locate to 42 digits or more")
      .by(Oracle::independent);
}

/// First instability by GSL's eigenvalues in double, sampled and bisected.
struct FirstInstability {
  StabilityKind kind = StabilityKind::stable;
  double angle = 0;
};
FirstInstability by_eigenvalues(const Entry& entry, int axis, const MomentSetting& setting,
                                const BodyInertia& body, double end) {
  const JointSpec spec = block_joint(entry);
  const auto kind_at = [&](double angle) {
    const auto p = loaded_state<double>(entry, spec, axis, setting, angle);
    return reference::stability_kind(modes(p.J, mass_matrix(body, p.R, 3)));
  };
  constexpr double kStep = 5e-3;
  for (double angle = kStep; angle < end; angle += kStep) {
    const StabilityKind kind = kind_at(angle);
    if (kind == StabilityKind::stable) continue;
    double low = angle - kStep, high = angle;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      (kind_at(middle) == StabilityKind::stable ? low : high) = middle;
    }
    return {kind_at(high), high};
  }
  return {};
}

Finding eigenvalue_road(const Entry& entry, Kind, Draft f) {
  Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    for (const MomentSetting& setting : kMomentSettings) {
      const auto& c = begun_loads(entry, axis, setting, kLong);
      const auto found = by_eigenvalues(entry, axis, setting, kLong, c.end_angle);
      const auto& first = c.first() == StabilityKind::flutter ? c.flutter : c.divergence;
      const double expected = first ? double(first->angle) : 0;
      worst.include(found.kind == c.first() ? std::abs(found.angle - expected) : std::nan(""),
                    std::string(to_string(setting)) + " moment about " + std::to_string(axis + 1));
    }
  }
  return f.measured(worst)
      .in("rad")
      .at_most(1e-9,
               "an imaginary part counts from 1e-6 of the largest eigenvalue, which is its square beyond the "
               "meeting")
      .by(Oracle::independent);
}

}  // namespace

void stability_kind_critical(Checks& checks) {
  checks.push_back({"stability_kind/zeros", "stability", zeros});
  checks.push_back({"stability_kind/two_at_once", "stability", two_at_once});
  checks.push_back({"stability_kind/c3", "stability", c3_values});
  add_property(checks, "critical_second_road", {Kind::angular}, second_road);
  add_property(checks, "critical_by_eigenvalues", {Kind::angular}, eigenvalue_road);
}

}  // namespace halfway::verify
