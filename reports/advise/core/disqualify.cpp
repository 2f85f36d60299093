#include "reports/advise/core/disqualify.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/joint/free_strains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::advise {
namespace {

using reference::Entry, reference::JointSpec;
using Loads = Eigen::Matrix<double, 12, 1>;

double over(double difference, double whole) {
  return whole == 0 && difference == 0 ? 0 : difference / whole;
}

JointSpec spec_of(const Question& question, const Candidate& c) {
  JointSpec spec =
      c.kind == question.scene.joint.kind ? question.scene.joint : as_kind(question.scene, c.kind)->joint;
  spec.xi = c.xi;
  return spec;
}

Loads loads_at(const Entry& entry, const JointSpec& spec, const Pose<double>& a, const Pose<double>& b) {
  return reference::node_loads<double>(entry, spec, a, b, false).q;
}

/// Does the law say the same of a strain and of its opposite? Listing the nodes the other way round turns
/// strains over.
bool is_odd(const reference::LawSpec& law) {
  return std::holds_alternative<reference::LinearSpec>(law) ||
         std::holds_alternative<reference::PolynomialSpec>(law);
}

/// Forces over forces; moments over the moments at the nodes and what the forces make of them.
double apart(const Loads& q, const Loads& other, double arm) {
  const auto part = [](const Loads& v, int first) {
    return std::hypot(v.segment<3>(first).norm(), v.segment<3>(first + 6).norm());
  };
  const Loads off = q - other;
  const double forces = over(part(off, 0), part(q, 0));
  return reference::larger(forces, over(part(off, 3), part(q, 3) + arm * part(q, 0)));
}

double node_order(const Entry& entry, const JointSpec& spec, const Pose<double>& b) {
  JointSpec exchanged = spec;
  std::swap(exchanged.a, exchanged.b);
  exchanged.axis = -exchanged.axis;  // seen from its other end the rod runs the other way
  exchanged.xi = 1 - exchanged.xi;
  const Loads turned = loads_at(entry, exchanged, b, {});
  Loads back;
  back << turned.tail<6>(), turned.head<6>();
  return apart(loads_at(entry, spec, {}, b), back, b.x.norm());
}

double unbalanced(const Entry& entry, const JointSpec& spec, const Pose<double>& b) {
  const Loads q = loads_at(entry, spec, {}, b);
  const Vec3<double> m_a = q.segment<3>(3), m_b = q.segment<3>(9),
                     by_force = b.x.cross(Vec3<double>(q.segment<3>(6)));
  return over((m_a + m_b + by_force).norm(), m_a.norm() + m_b.norm() + by_force.norm());
}

/// A law without potential does work round loops, ~ amplitude^slope, measured at kLoop (facts): once a
/// period.
double energy_made(const Question& question, const Entry& entry, Kind kind, double amplitude) {
  constexpr double kLoop = 0.4;  // rad
  if (question.periods <= 0 || entry.has_potential(kind) || entry.facts.loop_slope == 0) return 0;
  return question.periods * entry.facts.loop_work.of(kind).high *
         std::pow(amplitude / kLoop, entry.facts.loop_slope);
}

/// Moments while the node spins about the free axis of its joint frame, bent as it is: a shaft's stay.
double spin_change(const Entry& entry, const JointSpec& spec, const Pose<double>& bent, int shaft) {
  const auto moment = [&](double s) {
    Pose<double> b = bent;
    b.R = bent.R * spec.b.H * so3::exp<double>(s * Vec3<double>::Unit(shaft)) * spec.b.H.transpose();
    b.x = bent.x + (bent.R - b.R) * spec.b.o;
    return Vec3<double>(loads_at(entry, spec, {}, b).segment<3>(9));
  };
  const Vec3<double> still = moment(0);
  double worst = 0;
  // To both sides of half a turn and of one and a half, where rotation vectors and Euler angles jump.
  for (const double s : {0.4, 1.1, 1.5, 1.65, 2.2, 3.0, 3.13, 3.15, 3.9, 4.7, 5.5, 6.28, 8.0, 9.4, 9.45})
    reference::keep_largest(worst, over((moment(s) - still).norm(), still.norm()));
  return worst;
}

std::string percent(double x) { return std::isfinite(x) ? fmt::format("{:.2g} %", 100 * x) : "no number"; }

}  // namespace

std::optional<int> free_shaft(const Question& question) {
  if (question.degrees || question.scene.joint.kind == Kind::linear) return std::nullopt;
  const Eigen::MatrixXd K = reference::rest_stiffness(question.scene.joint.law, question.scene.joint.kind);
  if (K.size() == 0) return std::nullopt;
  const Eigen::Index first = K.rows() - 3;
  std::optional<int> out;
  for (int axis = 0; axis < 3; ++axis) {
    if (!K.col(first + axis).isZero(0)) continue;
    if (out) return std::nullopt;  // two of them: no shaft
    out = axis;
  }
  return out;
}

std::vector<double> node_order_errors(const reference::Scene& scene, const Candidate& c,
                                      const Answers& answers) {
  if (!c.entry || !is_odd(scene.joint.law) || c.entry->facts.node_order.of(c.kind).holds()) return {};
  const std::vector<double> factors(answers.factor.begin(),
                                    answers.factor.begin() + std::ptrdiff_t(answers.value.size()));
  return errors_of(follow(scene, c, factors, true), answers, Measure::norm);
}

Defects defects_of(const Question& question, const Candidate& c, const Answers& answers, std::size_t rows) {
  Defects out;
  if (!c.entry) return out;
  const JointSpec spec = spec_of(question, c);
  double amplitude = 0;
  const std::size_t last = std::min(rows, answers.node.size());
  for (std::size_t i = 0; i < last; ++i) {
    const Pose<double>& b = answers.node[i];
    if (is_odd(spec.law)) reference::keep_largest(out.node_order, node_order(*c.entry, spec, b));
    reference::keep_largest(out.balance, unbalanced(*c.entry, spec, b));
    reference::keep_largest(amplitude, so3::log<double>(spec.a.H.transpose() * b.R * spec.b.H).norm());
  }
  if (!answers.factor.empty())
    for (std::size_t i = 0; const double change : node_order_errors(question.scene, c, answers))
      if (i++ < rows) reference::keep_largest(out.node_order, change);
  out.energy = energy_made(question, *c.entry, c.kind, amplitude);
  if (const auto shaft = free_shaft(question); shaft && last > 0)
    out.spin = spin_change(*c.entry, spec, answers.node[last - 1], *shaft);
  return out;
}

std::string disqualified(const Question& question, const Candidate& c, const Answers& answers,
                         const Envelope& envelope, const Defects& defects) {
  if (answers.value.size() < envelope.rows)
    return fmt::format("ends at load factor {:.4g}: {}",
                       answers.value.empty() ? 0 : envelope.factors[answers.value.size() - 1], answers.ended);
  const double limit = question.tolerance;
  // Written so that what is no number is out.
  if (!(defects.node_order <= limit))
    return fmt::format("depends on the order of the nodes, by {}", percent(defects.node_order));
  if (!(defects.balance <= limit))
    return fmt::format("moments do not balance: {} of them", percent(defects.balance));
  if (!(defects.energy <= limit))
    return fmt::format("makes or loses {} of the energy in {:g} periods", percent(defects.energy),
                       question.periods);
  if (!(defects.spin <= limit))
    return fmt::format("is no shaft: as it spins freely the moment changes by {}", percent(defects.spin));
  if (!c.entry && question.is_moving) return "does not turn with node a";
  if (!c.entry && free_shaft(question)) return "is no shaft: linear rotations do not turn through";
  return "";
}

}  // namespace halfway::advise
