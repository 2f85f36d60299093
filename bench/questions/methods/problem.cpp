#include "bench/questions/methods/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace halfway::bench {
namespace {

using reference::Real50;
using Tangent50 = Eigen::Matrix<Real50, Eigen::Dynamic, Eigen::Dynamic>;

Tangent50 exact_tangent(const std::string& formulation, const Inputs& in, int i) {
  const reference::Entry& entry = *reference::find_formulation(formulation);
  const auto a = reference::cast<Real50>(in.a[i]), b = reference::cast<Real50>(in.b[i]);
  if (in.spec.kind != Kind::angular) return entry.in_real50.point(in.spec, a, b, true).tangent;
  const auto r = entry.in_real50.angular(in.spec, a, b, true);
  Tangent50 t(3, 6);
  t << r.m_b_wa, r.m_b_wb;
  return t;
}

std::vector<Evaluated> evaluate_all(const Evaluate& evaluate, const Inputs& in) {
  std::vector<Evaluated> values;
  for (std::size_t i = 0; i < in.a.size(); ++i) values.push_back(evaluate(in.a[i], in.b[i]));
  return values;
}

TangentProblem make_problem(const std::string& formulation, Kind kind) {
  const Inputs in = inputs(kind, {}, false);
  TangentProblem p{formulation, kind, {formulation, in}, {}};
  for (const ErrorAt& range : phi_ranges()) p.ranges.emplace_back(formulation, moved_into(in, range));
  return p;
}

}  // namespace

double TangentTruth::error(const std::vector<Evaluated>& values) {
  if (exact_.empty()) {
    for (int i = 0; i < int(in_.a.size()); ++i) exact_.push_back(exact_tangent(formulation_, in_, i));
  }
  reference::Measurement worst;
  for (std::size_t i = 0; i < values.size(); ++i)
    worst.include(largest_difference(values[i].tangent, exact_[i]) / largest_entry(exact_[i]), {});
  return worst.value();
}

std::shared_ptr<TangentProblem> tangent_problem(const std::string& formulation, Kind kind) {
  static std::map<std::pair<std::string, Kind>, std::shared_ptr<TangentProblem>> made;
  auto& problem = made[{formulation, kind}];
  if (!problem) problem = std::make_shared<TangentProblem>(make_problem(formulation, kind));
  return problem;
}

Checked check_tangent(TangentProblem& problem, const Evaluate& evaluate, double limit) {
  std::vector<Evaluated> values = evaluate_all(evaluate, problem.timed.inputs());
  const double error = problem.timed.error(values);
  for (Evaluated& value : values) value.tangent.resize(0, 0);  // the loads alone have the usual limit
  Checked out = compare(problem.formulation, problem.timed.inputs(), values);
  out.error = error;
  if (!(error <= limit) && out.message.empty()) {
    out.message = fmt::format("tangent: relative error {:.2e}, limit {:.2e}", error, limit);
  }
  const std::vector<ErrorAt> ranges = phi_ranges();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    TangentTruth& truth = problem.ranges[i];
    out.errors.push_back({ranges[i].from, ranges[i].to, truth.error(evaluate_all(evaluate, truth.inputs()))});
  }
  return out;
}

}  // namespace halfway::bench
