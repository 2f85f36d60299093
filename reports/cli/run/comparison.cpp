#include "reports/cli/run/comparison.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace halfway::reports {
namespace {

using reference::Curve;

/// Over the outputs of each unit: the norm of x - y. Both have the load factor first.
std::map<std::string_view, double> differences(const Curve& names, const std::vector<double>& x,
                                               const std::vector<double>& y) {
  std::map<std::string_view, double> out;
  for (std::size_t i = 1; i < names.columns.size(); ++i) {
    double& norm = out[reference::unit_of_output(names.columns[i])];
    norm = std::hypot(norm, x[i] - y[i]);
  }
  return out;
}

void include_error(const Curve& curve, Agreeing& group) {
  if (curve.errors.empty()) return;
  group.error = reference::larger(group.error.value_or(0), curve.errors.back());
}

/// What two curves' last points differ by, over `sizes`.
double apart(const Curve& a, const Curve& b, const std::map<std::string_view, double>& sizes) {
  const double known = (a.errors.empty() ? 0 : a.errors.back()) + (b.errors.empty() ? 0 : b.errors.back());
  double largest = 0;
  for (const auto& [unit, difference] : differences(a, a.rows.back(), b.rows.back())) {
    if (difference > known) reference::keep_largest(largest, difference / sizes.at(unit));
  }
  return largest;
}

std::map<std::string_view, double> sizes_of(const std::vector<Curve>& curves) {
  std::map<std::string_view, double> out;
  for (const Curve& curve : curves) {
    if (!curve.converged) continue;
    for (const auto& row : curve.rows) {
      for (const auto& [unit, moved] : differences(curve, row, curve.rows.front()))
        reference::keep_largest(out[unit], moved);
    }
  }
  return out;
}

/// Outputs of the last row. What a sum of numbers of the answer's size leaves is nothing.
std::vector<double> answer_of(const Curve& curve, const std::map<std::string_view, double>& sizes) {
  constexpr double kRounding = 1e-13;
  std::vector<double> out;
  for (std::size_t i = 1; i < curve.columns.size(); ++i) {
    const double x = curve.rows.back()[i], error = curve.errors.empty() ? 0 : curve.errors.back();
    const bool is_nothing = std::abs(x) <= error ||
                            std::abs(x) <= kRounding * sizes.at(reference::unit_of_output(curve.columns[i]));
    out.push_back(is_nothing ? 0 : x);
  }
  return out;
}

/// Into the first group all of whose members agree with it, or one of its own.
void sort_in(const std::vector<Curve>& curves, std::size_t at,
             const std::map<std::string_view, double>& sizes, std::vector<Agreeing>& groups) {
  for (Agreeing& group : groups) {
    double farthest = group.apart;
    for (std::size_t other : group.curves)
      reference::keep_largest(farthest, apart(curves[at], curves[other], sizes));
    if (!(farthest <= kAgree)) continue;
    group.apart = farthest;
    include_error(curves[at], group);
    group.curves.push_back(at);
    return;
  }
  groups.push_back({{at}});
  include_error(curves[at], groups.back());
  groups.back().answer = answer_of(curves[at], sizes);
}

void add_ended(const Curve& curve, std::size_t at, std::vector<Ended>& ended) {
  const auto same = std::ranges::find(ended, curve.cause, &Ended::cause);
  if (same == ended.end())
    ended.push_back({curve.cause, {at}});
  else
    same->curves.push_back(at);
}

}  // namespace

bool is_formulation(const Curve& curve) { return reference::find_formulation(curve.formulation) != nullptr; }

Comparison compared(const std::vector<Curve>& curves) {
  Comparison out;
  const auto sizes = sizes_of(curves);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].converged)
      sort_in(curves, i, sizes, out.groups);
    else
      add_ended(curves[i], i, out.ended);
  }
  const auto has_arrived = [](const Curve& c) { return c.converged && is_formulation(c); };
  out.answers = std::size_t(std::ranges::count_if(out.groups, [&](const Agreeing& group) {
    return std::ranges::any_of(group.curves, [&](std::size_t i) { return has_arrived(curves[i]); });
  }));
  for (const Curve& a : curves) {
    for (const Curve& b : curves) {
      if (has_arrived(a) && has_arrived(b)) reference::keep_largest(out.apart, apart(a, b, sizes));
    }
  }
  return out;
}

}  // namespace halfway::reports
