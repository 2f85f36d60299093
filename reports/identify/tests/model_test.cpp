// The terms of second order beside a formulation: what they are at small motion, and which do no work round a
// loop.
#include "reference/identify/coverage.hpp"
#include "reference/identify/response.hpp"

#include "halfway/rotations/so3.hpp"

#include <boost/test/unit_test.hpp>

namespace id = halfway::reference::identify;
using halfway::Vec3;

namespace {

id::Frame unit_frame(halfway::Kind kind) {
  id::Frame out;
  out.kind = kind;
  return out;
}

/// The full joint of the coverage with other xi.
id::JointValues values(const Vec3<double>& angular, const Vec3<double>& linear) {
  id::JointValues v = id::bench("full").truth;
  v.xi_angular = angular, v.xi_linear = linear;
  return v;
}

/// Work round a closed loop of poses, by the trapezoidal rule on fine steps.
double loop_work(const id::Model& model, int steps) {
  const auto motion = [&](int i) -> id::Vec6 {
    const double t = 2 * M_PI * i / steps;
    id::Vec6 z;
    z << 0.004 * std::sin(t), 0.003 * std::cos(t), -0.002 * std::sin(2 * t), 0.1 * std::cos(t),
        0.08 * std::sin(t), 0.06 * std::cos(t + 1);
    return z;
  };
  double work = 0;
  for (int i = 0; i < steps; ++i) {
    const id::Vec6 from = motion(i), to = motion(i + 1), middle = (from + to) / 2;
    id::Vec6 step = to - from;
    step.tail<3>() =
        halfway::so3::gamma<double>(Vec3<double>(middle.tail<3>())) * Vec3<double>(step.tail<3>());
    work += id::loads_at(model, middle, false).q.dot(step);
  }
  return work;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(model)

/// Three times the same xi is `intrinsic`; by the terms beside another frame it is so up to third order:
/// halving the motion makes the difference eight times smaller.
BOOST_AUTO_TEST_CASE(terms_are_those_of_xi) {
  const id::Frame frame = unit_frame(halfway::Kind::linear_angular);
  const id::JointValues v = values(Vec3<double>::Constant(0.37), Vec3<double>::Constant(0.37));
  const id::Model one = id::second_order_model(frame, v);
  BOOST_TEST(one.entry->name == "intrinsic");
  id::Model other = one;
  other.entry = halfway::reference::find_formulation("invariant");
  other.spec.xi = 0.5;
  for (int i = 0; i < 3; ++i)
    other.pair[i] = (0.37 - 0.5) * (v.angular[(i + 2) % 3] - v.angular[(i + 1) % 3]);
  other.bending.setConstant(0.37 - 0.5);
  other.K_u = v.E * v.linear.asDiagonal() * v.E.transpose();
  // Coupling left takes part at second order as well, which the terms leave to the formulation: without it.
  id::JointValues plain = v;
  plain.S.setZero();
  const id::Model exact = id::second_order_model(frame, plain);
  other.spec.law = exact.spec.law;
  id::Vec6 z;
  z << 0.004, -0.003, 0.002, 0.1, 0.08, -0.06;
  z.head<3>() += plain.point - halfway::so3::exp<double>(Vec3<double>(z.tail<3>())) * plain.point;
  const auto apart = [&](double factor) {
    const id::Vec6 at = factor * z;
    return (id::loads_at(exact, at, false).q - id::loads_at(other, at, false).q).norm();
  };
  BOOST_TEST(apart(0.1) / apart(0.05) == 8, boost::test_tools::tolerance(0.1));
  other.pair *= -1;  // the wrong sign is of second order: four times
  BOOST_TEST(apart(0.1) / apart(0.05) == 4, boost::test_tools::tolerance(0.2));
}

/// With the cubic term the joint has a potential, with three xi none.
BOOST_AUTO_TEST_CASE(cubic_does_no_work) {
  const id::Frame frame = unit_frame(halfway::Kind::linear_angular);
  id::JointValues v = values({0.5, 0.5, 0.5}, {0.6, 0.3, 0.9});
  v.cubic = 20;
  const id::Model conservative = id::second_order_model(frame, v);
  v.cubic = 0;
  v.xi_angular = {0.6, 0.3, 0.9};
  const id::Model not_conservative = id::second_order_model(frame, v);
  const double stored = 10 * 0.01;  // k theta^2
  // The rule's error falls with the square of the step; what is left at 4000 steps is below 1e-8 of the
  // energy.
  BOOST_TEST(std::abs(loop_work(conservative, 4000)) < 1e-7 * stored);
  BOOST_TEST(std::abs(loop_work(not_conservative, 4000)) > 1e-3 * stored);
}

/// Derivatives by the unknowns, where node b is loaded and where it is held, against responses to changed
/// unknowns.
BOOST_AUTO_TEST_CASE(derivatives) {
  const id::Bench bench = id::bench("held");
  const id::Identification found = id::identify(bench.data, false);
  const id::MakeModel make = [&](const id::Unknowns& p) {
    return id::second_order_model(found.frame, id::values_of(found.frame, p));
  };
  id::Unknowns p = found.stage(id::Stage::per_pair).fit.p;
  p.segment<3>(id::kXiAngular) = Vec3<double>(0.3, 0.5, 0.6);
  const auto active = id::freedom_of(id::Stage::per_pair, bench.data.kind).active;
  const id::Response at = id::respond(bench.data, make, p, active, true, {});
  for (std::size_t c = 0; c < active.size(); ++c) {
    id::Unknowns up = p, down = p;
    up[active[c]] += 1e-4, down[active[c]] -= 1e-4;
    const Eigen::VectorXd differences = (id::respond(bench.data, make, up, {}, false, {}).values -
                                         id::respond(bench.data, make, down, {}, false, {}).values) /
                                        2e-4;
    const Eigen::VectorXd derivative = at.by_unknown.col(Eigen::Index(c));
    // Truncation of both differences: 1e-8 of the third derivative.
    BOOST_TEST_CONTEXT(id::name_of(active[c]))
    BOOST_TEST((differences - derivative).norm() < 1e-5 * derivative.norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()
