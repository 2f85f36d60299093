// The kernels against the readable transcription at 50 digits: another text of the same joint, from
// the very same quaternions, over every decade of the angle up to pi - 1e-12.
#include "reference/record/effort.hpp"
#include "verify/oracle/poles.hpp"
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace halfway::verify {
namespace {

using reference::QuaternionPose;

struct Case {
  JointSpec spec;
  QuaternionPose<double> a, b;
  double phi = 0;
};

/// A generic law of the probes, node b turned by phi against a; with `ends`, joint frames turned by
/// thirds and the probes' joint points.
Case make_case(const Probe& probe, reference::Generator& g, double phi, bool ends) {
  Case c{probe.spec, {}, {}, phi};
  c.spec.a.H = reference::third_of_turn(1), c.spec.b.H = reference::third_of_turn(-1);
  if (!ends) c.spec.a = c.spec.b = {};
  const auto pair = reference::turned_pair(g, phi, ends);
  const Vec3<double> x_a = g.vector(1);
  c.a = {x_a, pair.a};
  c.b = {x_a + g.vector(0.5), pair.b};
  return c;
}

/// @param draws  how often each angle is drawn, with another axis and law
std::vector<Case> cases(const Entry& entry, Kind kind, bool ends, int draws) {
  reference::Generator g(404);
  std::vector<Case> out;
  const auto laws = probes(entry, kind, 8, 1);
  const auto add = [&](double phi) {
    out.push_back(make_case(laws[out.size() % laws.size()], g, phi, ends));
  };
  for (int draw = 0; draw < draws; ++draw) {
    for (int decade = -12; decade <= 0; ++decade) add(2 * std::pow(10.0, decade));
    for (const double phi : {0.1, 0.7, 1.2, 1.5707, 2.2, 2.7, 3.0, 3.1}) add(phi);
    for (int decade = -2; decade >= -12; --decade) add(std::numbers::pi - std::pow(10.0, decade));
  }
  return sampled(out, 4);
}

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Largest |value - exact| of any entry, relative to `scale`.
template <class E, class V>
double miss(const E& exact, const V& value, double scale) {
  return double(largest_entry<Real50>((value.template cast<Real50>() - exact).eval())) / scale;
}

template <class T>
NodeLoads<T> kernel_loads(const reference::KernelEvaluators<T>& kernel, const Case& c, bool with_tangent) {
  const auto cast = [](const QuaternionPose<double>& p) {
    return QuaternionPose<T>{p.x.template cast<T>(), p.q.template cast<T>()};
  };
  if (c.spec.kind == Kind::angular)
    return reference::node_loads(kernel.angular(c.spec, cast(c.a), cast(c.b), with_tangent), true);
  return kernel.point(c.spec, cast(c.a), cast(c.b), with_tangent);
}

/// Where plain differences of products are taken, 4 eps of the relative quaternion are lost whatever the
/// angle: smaller strains than this count as this. Nothing is lost by compensated ones.
constexpr double kPlainProducts = 4 * kEps / 5e-15;

/// A scalar's poses: rounded to it, and as exact as their quaternions then are.
template <class T>
QuaternionPose<double> rounded(const QuaternionPose<double>& p) {
  return {p.x.cast<T>().template cast<double>(), p.q.cast<T>().template cast<double>()};
}

struct Worst {
  Measurement loads, tangent;
};

/// Worst errors over all cases; `floor` is the strain below which loads are not relative.
template <class T>
Worst worst(const Entry& entry, Kind kind, const reference::KernelEvaluators<T>& kernel, double floor,
            bool ends = true, double largest = std::numbers::pi, int draws = 1) {
  Worst out;
  // Nearer to pi than the scalar can tell, a rounded pose is on the other side, with the opposite moment.
  const double last = std::is_same_v<T, float> ? std::numbers::pi - 1e-4 : largest;
  for (Case c : cases(entry, kind, ends, draws)) {
    if (c.phi > last) continue;
    c.a = rounded<T>(c.a), c.b = rounded<T>(c.b);
    const auto a = reference::exact_pose(c.a), b = reference::exact_pose(c.b);
    const auto exact = reference::node_loads<Real50>(entry, c.spec, a, b, true);
    if (steepness(entry, c.spec, a, b) > kSteepest) continue;
    const double strain = double(Real50(entry.in_real50.strain(c.spec, a, b).norm()));
    const double stiffness = std::get<reference::LinearSpec>(c.spec.law).matrix.norm();
    const double of_loads = larger(stiffness * larger(strain, floor), double(largest_entry<Real50>(exact.q)));
    const std::string at = fmt::format("phi = {:.3g} rad", c.phi);
    for (const bool with_tangent : {true, false}) {
      const auto value = kernel_loads(kernel, c, with_tangent);
      out.loads.include(miss(exact.q, value.q, of_loads), at);
      if (!with_tangent) continue;
      const double entry_size = double(largest_entry<Real50>(exact.tangent));
      out.tangent.include(miss(exact.tangent, value.tangent, entry_size), at);
    }
  }
  return out;
}

/// A dozen products in a row, half an eps each in the mean; the target of the kernels.
constexpr double kKernelLimit = 5e-15;

std::vector<Finding> both(const Entry& entry, Kind kind, const std::string& suffix, const Worst& worst,
                          double limit, const std::string& reason) {
  const auto held = [&](const std::string& what, const Measurement& m, const std::string& why) {
    return property_finding(entry, kind, what + suffix)
        .measured(m)
        .in("relative")
        .at_most(limit, why)
        .by(Oracle::independent);
  };
  return {held("kernel_loads", worst.loads, reason),
          held("kernel_tangent", worst.tangent, "of the largest entry")};
}

std::vector<Finding> in_double(const Entry& entry, Kind kind) {
  return both(entry, kind, "", worst(entry, kind, entry.kernel.in_double, kPlainProducts), kKernelLimit,
              "of |K| |strain|, but 4 eps of |K|, what rounding the poses' products leaves of any strain");
}

std::vector<Finding> in_float(const Entry& entry, Kind kind) {
  return both(entry, kind, "_float", worst(entry, kind, entry.kernel.in_float, kPlainProducts),
              kKernelLimit / kEps * std::numeric_limits<float>::epsilon(), "as in double, in eps of float");
}

std::vector<Finding> compensated(const Entry& entry) {
  constexpr int kDraws = 8;  // one may be lucky: twenty single ones were from 0.5e-15 to 1.3e-15
  return {
      property_finding(entry, Kind::angular, "kernel_compensated")
          .measured(worst(entry, Kind::angular, entry.kernel.compensated, 0, false, 1, kDraws).loads)
          .in("relative")
          .at_most(
              2e-15,
              "of |K| |strain| from 2e-12 to 1 rad: nine eps, for the relative quaternion, its angle, the "
              "law and two turns of vectors are each two or less, and none is magnified")
          .by(Oracle::independent)};
}

}  // namespace

void kernels(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    if (entry.kernel.in_double.angular == nullptr) continue;
    for (const Kind kind : kKinds) {
      const std::string name = fmt::format("{}/{}/kernel", entry.name, to_string(kind));
      checks.push_back({name, "kernels", [&entry, kind] { return in_double(entry, kind); }});
      checks.push_back({name + "_float", "kernels", [&entry, kind] { return in_float(entry, kind); }});
    }
    checks.push_back({fmt::format("{}/angular/kernel_compensated", entry.name), "kernels",
                      [&entry] { return compensated(entry); }});
  }
}

}  // namespace halfway::verify
