#include "verify/studies/limits/turns.hpp"

#include "reference/face/instantiations.hpp"
#include "reference/record/worst.hpp"
#include "verify/once.hpp"

#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

constexpr double kLargestStiffness = kTurnStiffness[2];
constexpr double kNegligible = 1e-6;  ///< far above what 1e-20 rad changes, far below any jump

bool is_finite(const AngularLoads<Real50>& loads) {
  return loads.m_b.cast<double>().allFinite() && loads.m_b_wb.cast<double>().allFinite();
}

double size(const Vec3<Real50>& v) { return v.cast<double>().norm(); }
double size(const Mat3<Real50>& m) { return m.cast<double>().norm(); }

/// Singular values, largest first.
Vec3<double> singular_values(const Mat3<double>& m) {
  Mat3<double> rows = m.transpose();  // GSL reads rows; the values are the same
  Mat3<double> V;
  Vec3<double> values, work;
  gsl_matrix_view a = gsl_matrix_view_array(rows.data(), 3, 3), v = gsl_matrix_view_array(V.data(), 3, 3);
  gsl_vector_view s = gsl_vector_view_array(values.data(), 3), w = gsl_vector_view_array(work.data(), 3);
  gsl_linalg_SV_decomp(&a.matrix, &v.matrix, &s.vector, &w.vector);
  return values;
}

TurnPoint point(const Entry& entry, const Vec3<Real50>& axis, const std::string& name, const Real50& phi) {
  const AngularLoads<Real50> loads = turned_loads(entry, axis, phi);
  TurnPoint out{name, double(phi)};
  const Mat3<double> tangent = loads.m_b_wb.cast<double>() / kLargestStiffness;
  out.is_finite = is_finite(loads);
  if (!out.is_finite) return out;
  const Vec3<double> values = singular_values(tangent);
  out.moment = size(loads.m_b) / (kLargestStiffness * out.phi);
  out.smallest = values[2];
  out.condition = values[0] / values[2];
  out.is_finite = std::isfinite(out.condition);
  if (!out.is_finite) out.condition = 0;
  return out;
}

/// One distance on both sides.
struct Sides {
  AngularLoads<Real50> before, after;
  double loads() const { return larger(size(before.m_b), size(after.m_b)); }
  double tangent() const { return larger(size(before.m_b_wb), size(after.m_b_wb)); }
};

/// near = far * (distance ratio)^-order.
double order(double far, double near, double decades) {
  return far == 0 || near == 0 ? 0 : std::log10(near / far) / decades;
}

std::string behaviour(const Crossing& c) {
  constexpr double kGrows = 0.5;
  if (c.order > kGrows) return "pole";
  if (c.jump > kNegligible) return "jump";
  if (c.tangent_order > kGrows) return "tangent pole";
  if (c.moment < kNegligible) return "zero moment";
  return c.tangent_jump > kNegligible ? "kink" : "smooth";
}

}  // namespace

Vec3<Real50> turn_axis(int axis) {
  if (axis > 0) return Vec3<Real50>::Unit(axis - 1);
  return Vec3<Real50>(Real50(2) / Real50(7), Real50(3) / Real50(7), Real50(6) / Real50(7));
}

std::string axis_name(int axis) { return axis > 0 ? std::to_string(axis) : "generic"; }

JointSpec turn_joint(const Entry& entry) {
  JointSpec spec;
  spec.kind = Kind::angular;
  spec.xi = entry.probe_xi;
  const Vec3<double> k(kTurnStiffness[0], kTurnStiffness[1], kTurnStiffness[2]);
  spec.law = LinearSpec{k.asDiagonal(), false};
  return spec;
}

AngularLoads<Real50> turned_loads(const Entry& entry, const Vec3<Real50>& axis, const Real50& phi) {
  Pose<Real50> b;
  b.R = so3::exp<Real50>(phi * axis);
  return entry.in_real50.angular(turn_joint(entry), {}, b, true);
}

Crossing crossing(const Entry& entry, const Vec3<Real50>& axis, const std::string& name, const Real50& phi) {
  const auto sides = [&](const char* distance) {
    return Sides{turned_loads(entry, axis, phi - Real50(distance)),
                 turned_loads(entry, axis, phi + Real50(distance))};
  };
  const Sides far = sides("1e-10"), near = sides("1e-20");
  Crossing c{name, double(phi)};
  for (const auto* loads : {&far.before, &far.after, &near.before, &near.after}) {
    if (is_finite(*loads)) continue;
    c.behaviour = "not finite";
    return c;
  }
  const double unit = kLargestStiffness * c.phi;
  c.order = order(far.loads(), near.loads(), 10);
  c.tangent_order = order(far.tangent(), near.tangent(), 10);
  c.moment = near.loads() / unit;
  c.jump = size(Vec3<Real50>(near.after.m_b - near.before.m_b)) / unit;
  c.tangent_jump = size(Mat3<Real50>(near.after.m_b_wb - near.before.m_b_wb)) / kLargestStiffness;
  c.behaviour = behaviour(c);
  return c;
}

const Crossing& LargeRotation::across(std::string_view angle) const {
  return *std::ranges::find(crossings, angle, &Crossing::angle);
}

static LargeRotation measured(const Entry& entry, int axis) {
  const Real50 pi = pi50(), half = pi / Real50(2), eps("1e-9");
  const Vec3<Real50> n = turn_axis(axis);
  LargeRotation out{std::string(entry.name), axis};
  const auto add = [&](const std::string& name, const Real50& phi) {
    out.points.push_back(point(entry, n, name, phi));
  };
  add("pi/2", half), add("pi - 1e-9", pi - eps), add("pi", pi), add("pi + 1e-9", pi + eps);
  add("3 pi/2", pi + half), add("2 pi", pi + pi);
  out.crossings = {crossing(entry, n, "pi/2", half), crossing(entry, n, "pi", pi),
                   crossing(entry, n, "3 pi/2", pi + half), crossing(entry, n, "2 pi", pi + pi)};
  return out;
}

const LargeRotation& large_rotation(const Entry& entry, int axis) {
  static verify::Once<LargeRotation, int> known;
  return known(entry, axis, [&] { return measured(entry, axis); });
}

}  // namespace halfway::reference
