#include "verify/studies/frames/answers.hpp"

#include "reference/solve/path.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfway::verify {
namespace {

using namespace reference;

constexpr int kPoints = 6;

/// 1 : 2 : 2.5 kg m^2 and 1 kg, about axes that are none of the joint.
BodyInertia body(const Written& written) {
  BodyInertia out{"1:2:2.5", {1, 2, 2.5}, 1};
  out.axes = written.node_b * so3::exp<double>({0.3, -0.2, 0.5});
  return out;
}

JointSpec spec_of(const LawUnderTest& law, const Written& written) {
  JointSpec spec = written.scene.joint;
  spec.xi = law.xi;
  return spec;
}

double stored(const LawUnderTest& law, const Written& written, const Pose<double>& moving) {
  JointSpec spec = spec_of(law, written);
  Pose<double> a{}, b = moving;
  if (written.setting.nodes_exchanged) {
    std::swap(spec.a, spec.b), spec.axis = -spec.axis;
    std::swap(a, b);
  }
  return stored_energy(*law.entry, spec, a, b);
}

Eigen::VectorXd modes_of(const Eigen::MatrixXd& J, const BodyInertia& body, const Mat3<double>& R) {
  const Eigen::MatrixXd A = mass_matrix(body, R, int(J.rows())).partialPivLu().solve(J);
  Eigen::VectorXd out(A.rows());
  Eigen::MatrixXd power = A;
  for (Eigen::Index k = 0; k < out.size(); ++k) {
    out[k] = std::copysign(std::pow(std::abs(power.trace()), 1. / double(k + 1)), power.trace());
    power = (A * power).eval();
  }
  return out;
}

Vec3<double> vector_of(const Path<double>& path, const std::string& name) {
  return {path.output(name + "_x"), path.output(name + "_y"), path.output(name + "_z")};
}

double size(double x) { return std::abs(x); }
double size(const Eigen::MatrixXd& x) { return x.norm(); }

/// Largest |a - b| over the largest |a|. @param least  below which no size counts
template <class Value>
Measurement largest_change(const std::vector<Value>& a, const std::vector<Value>& b, const char* what,
                           double least = 0) {
  Measurement out;  // nothing compared is NaN
  if (a.size() != b.size())
    return {std::nan(""), fmt::format("{}: {} points and {}", what, a.size(), b.size())};
  double largest = least;
  for (const Value& x : a) keep_largest(largest, size(x));
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double off = size(Value(a[i] - b[i]));
    out.include(off > 0 ? off / largest : off, fmt::format("{}, point {} of {}", what, i + 1, kPoints));
  }
  return out;
}

double relative(double a, double b) { return a == b ? 0 : std::abs(a - b) / std::abs(a); }

void include(Measurement& out, const std::optional<Critical>& a, const std::optional<Critical>& b,
             const char* what) {
  if (a.has_value() != b.has_value()) {
    out.include(std::nan(""), fmt::format("{} of one alone", what));
  } else if (a) {
    out.include(relative(double(a->load), double(b->load)),
                fmt::format("{} at {:.10g}", what, double(a->load)));
  }
}

}  // namespace

CurveAnswers curve_answers(const LawUnderTest& law, const Written& written) {
  const Scene& scene = written.scene;
  const EquilibriumProblem<double> problem(scene, *law.entry, law.xi, written.setting);
  Path<double> path(scene, *law.entry, law.xi, written.setting);
  CurveAnswers out;
  for (int i = 1; i <= kPoints; ++i) {
    if (path.advance(scene.factor_end * i / kPoints).status != Status::converged) break;
    out.theta.push_back(written.axes.transpose() * vector_of(path, "theta"));
    out.u.push_back(written.axes.transpose() * vector_of(path, "u"));
    out.energy.push_back(stored(law, written, path.node()));
    const Eigen::MatrixXd J = problem.node_tangent(path.state().joint, path.state().factor);
    out.modes.push_back(modes_of(J, body(written), path.node().R));
    if (problem.kind() != Kind::linear_angular) keep_largest(out.condition, J.norm() * J.inverse().norm());
  }
  return out;
}

CriticalLoads critical_answers(const LawUnderTest& law, const Written& written, int axis) {
  const PrimaryPath path(*law.entry, spec_of(law, written), axis, written.setting.nodes_exchanged);
  return path.critical({MomentType::fixed, false}, body(written));
}

EquilibriumPath arc_answers(const LawUnderTest& law, const Written& written) {
  ContinuationOptions options;
  options.end_factor = written.scene.factor_end;
  return Continuation(written.scene, *law.entry, law.xi, options, written.setting).from_rest();
}

CurveChanges changes(const CurveAnswers& a, const CurveAnswers& b) {
  // An orientation in double holds an angle to some eps of one radian, however small it is.
  constexpr double kLeastTurn = 1e-3;
  Measurement pose = largest_change(a.theta, b.theta, "theta", kLeastTurn), u = largest_change(a.u, b.u, "u");
  pose.include(u.value(), u.where());
  return {pose, largest_change(a.energy, b.energy, "energy"), largest_change(a.modes, b.modes, "modes")};
}

Measurement change(const CriticalLoads& a, const CriticalLoads& b) {
  Measurement out{0, "none found"};
  include(out, a.divergence, b.divergence, "divergence");
  include(out, a.flutter, b.flutter, "flutter");
  return out;
}

Measurement change(const EquilibriumPath& a, const EquilibriumPath& b) {
  Measurement out{0, a.outcome};
  if (a.end != b.end || a.singular.size() != b.singular.size())
    return {std::nan(""), fmt::format("{} singular points, {}; and {}, {}", a.singular.size(), a.outcome,
                                      b.singular.size(), b.outcome)};
  for (std::size_t i = 0; i < a.singular.size(); ++i) {
    const SingularPoint &p = a.singular[i], &q = b.singular[i];
    const bool alike = p.type == q.type;
    out.include(alike ? relative(p.state.factor, q.state.factor) : std::nan(""),
                fmt::format("{} at {:.10g}", to_string(p.type), p.state.factor));
    out.include(alike ? std::abs(p.phi - q.phi) : std::nan(""),
                fmt::format("phi of {:.10g}", p.state.factor));
  }
  return out;
}

}  // namespace halfway::verify
