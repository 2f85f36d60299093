// The kernels against the readable transcription at 50 digits: another text of the same joint, from
// the very same quaternions, over every decade of the angle up to pi - 1e-12.
#include "verify/property.hpp"

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

std::vector<Case> cases(const Entry& entry, Kind kind, bool ends) {
  reference::Generator g(404);
  std::vector<Case> out;
  const auto laws = probes(entry, kind, 8, 1);
  const auto add = [&](double phi) {
    out.push_back(make_case(laws[out.size() % laws.size()], g, phi, ends));
  };
  for (int decade = -12; decade <= 0; ++decade) add(2 * std::pow(10.0, decade));
  for (const double phi : {0.1, 0.7, 1.2, 1.5707, 2.2, 2.7, 3.0, 3.1}) add(phi);
  for (int decade = -2; decade >= -12; --decade) add(std::numbers::pi - std::pow(10.0, decade));
  return out;
}

constexpr double kEps = std::numeric_limits<double>::epsilon();

struct Error {
  double loads = 0, tangent = 0;
};

template <class T>
Error error(const NodeLoads<Real50>& exact, const NodeLoads<T>& value, double stiffness, double strain) {
  const auto miss = [](const auto& exact_, const auto& value_) {
    return (value_.template cast<Real50>() - exact_)
        .template cast<double>()
        .template lpNorm<Eigen::Infinity>();
  };
  const double loads = exact.q.cast<double>().lpNorm<Eigen::Infinity>();
  return {miss(exact.q, value.q) / std::max(stiffness * strain, loads),
          miss(exact.tangent, value.tangent) / exact.tangent.cast<double>().lpNorm<Eigen::Infinity>()};
}

template <class T>
NodeLoads<T> node_loads(const AngularLoads<T>& l) {
  NodeLoads<T> out;
  out.q << Vec3<T>::Zero(), -l.m_b, Vec3<T>::Zero(), l.m_b;
  out.tangent.setZero();
  out.tangent.template block<3, 3>(9, 3) = l.m_b_wa;
  out.tangent.template block<3, 3>(9, 9) = l.m_b_wb;
  out.tangent.template block<3, 6>(3, 3) << -l.m_b_wa, Mat3<T>::Zero();
  out.tangent.template block<3, 3>(3, 9) = -l.m_b_wb;
  return out;
}

template <class T>
NodeLoads<T> kernel_loads(const reference::KernelEvaluators<T>& kernel, const Case& c, bool with_tangent) {
  const auto cast = [](const QuaternionPose<double>& p) {
    return QuaternionPose<T>{p.x.template cast<T>(), p.q.template cast<T>()};
  };
  if (c.spec.kind == Kind::angular)
    return node_loads(kernel.angular(c.spec, cast(c.a), cast(c.b), with_tangent));
  return kernel.point(c.spec, cast(c.a), cast(c.b), with_tangent);
}

/// Euler measures have a pole where the middle angle is pi/2, cayley's at pi: 1/distance of it is the
/// condition number, and nobody evaluates a pole to eps. It is kept below 3.
bool near_pole(const Entry& entry, const Case& c, const Eigen::VectorXd& strain) {
  if (c.spec.kind == Kind::linear) return false;
  if (entry.name == "cayley") return c.phi > 2.4;
  constexpr std::string_view kEuler[] = {"field_a", "field_b", "simbody_xyz", "drake_rpy"};
  if (std::ranges::find(kEuler, entry.name) == std::end(kEuler)) return false;
  const int middle = entry.name.starts_with("field") ? 0 : 1;  // 312 or 123, 321; listed by axis
  return std::abs(std::cos(strain.tail<3>()[middle])) < 1. / 3;
}

/// Where plain differences of products are taken, 4 eps of the relative quaternion are lost whatever the
/// angle: smaller strains than this count as this. Nothing is lost by compensated ones.
constexpr double kPlain = 4 * kEps / 5e-15;

/// A scalar's poses: rounded to it, and as exact as their quaternions then are.
template <class T>
QuaternionPose<double> rounded(const QuaternionPose<double>& p) {
  return {p.x.cast<T>().template cast<double>(), p.q.cast<T>().template cast<double>()};
}

struct Worst {
  Error error;
  std::string loads_at, tangent_at;
};

/// Worst errors over all cases; `floor` is the strain below which loads are not relative.
template <class T>
Worst worst(const Entry& entry, Kind kind, const reference::KernelEvaluators<T>& kernel, double floor,
            bool ends = true, double largest = std::numbers::pi) {
  Worst out;
  // Nearer to pi than the scalar can tell, a rounded pose is on the other side, with the opposite moment.
  const double last = std::is_same_v<T, float> ? std::numbers::pi - 1e-4 : largest;
  for (Case c : cases(entry, kind, ends)) {
    if (c.phi > last) continue;
    c.a = rounded<T>(c.a), c.b = rounded<T>(c.b);
    const auto a = reference::exact_pose(c.a), b = reference::exact_pose(c.b);
    const auto exact = reference::node_loads<Real50>(entry, c.spec, a, b, true);
    const Eigen::VectorXd strain = entry.in_real50.strain(c.spec, a, b).template cast<double>();
    if (near_pole(entry, c, strain)) continue;
    const double stiffness = std::get<reference::LinearSpec>(c.spec.law).matrix.norm();
    const std::string at = fmt::format("phi = {:.3g} rad", c.phi);
    for (const bool with_tangent : {true, false}) {
      const auto value = kernel_loads(kernel, c, with_tangent);
      const Error e = error(exact, value, stiffness, std::max(strain.norm(), floor));
      if (!(e.loads <= out.error.loads)) out.error.loads = e.loads, out.loads_at = at;
      if (with_tangent && !(e.tangent <= out.error.tangent))
        out.error.tangent = e.tangent, out.tangent_at = at;
    }
  }
  return out;
}

Finding held(Finding f, double value, double limit, const std::string& reason) {
  f.value = value;
  f.unit = "relative";
  f.high = limit;
  f.oracle = Oracle::independent;
  f.reason = reason;
  return judged(f);
}

/// A dozen products in a row, half an eps each in the mean; the target of the kernels.
constexpr double kLimit = 5e-15;

std::vector<Finding> both(const Entry& entry, Kind kind, const std::string& suffix, const Worst& worst,
                          double limit, const std::string& reason) {
  Finding loads = property_finding(entry, kind, "kernel_loads" + suffix);
  Finding tangent = property_finding(entry, kind, "kernel_tangent" + suffix);
  loads.parameter = worst.loads_at, tangent.parameter = worst.tangent_at;
  return {held(loads, worst.error.loads, limit, reason),
          held(tangent, worst.error.tangent, limit, "of the largest entry")};
}

std::vector<Finding> in_double(const Entry& entry, Kind kind) {
  return both(entry, kind, "", worst(entry, kind, entry.kernel.in_double, kPlain), kLimit,
              "of |K| |strain|, but 4 eps of |K|, what rounding the poses' products leaves of any strain");
}

std::vector<Finding> in_float(const Entry& entry, Kind kind) {
  return both(entry, kind, "_float", worst(entry, kind, entry.kernel.in_float, kPlain),
              kLimit / kEps * std::numeric_limits<float>::epsilon(), "as in double, in eps of float");
}

std::vector<Finding> compensated(const Entry& entry) {
  Finding loads = property_finding(entry, Kind::angular, "kernel_compensated");
  const Worst w = worst(entry, Kind::angular, entry.kernel.compensated, 0, false, 1);
  loads.parameter = w.loads_at;
  return {held(loads, w.error.loads, 1e-15,
               "of |K| |strain| from 2e-12 to 1 rad: a few roundings, none of them magnified")};
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
