// Scenes in time by another road: Newton and Euler about the nodes, positions, orientations, velocities and
// spins by the classical Runge-Kutta method in steps of one size. Springs as the solver of equilibria has
// them, in the bodies' axes at rest; dampers as the tangent of `potential` where it is without stress.
#include "reference/mechanism/outputs.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/motion.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::BodyLoad;
using reference::MechanismScene;
using Wrench = Eigen::Matrix<double, 6, 1>;
namespace mechanism = reference::mechanism;

/// Or its rate: R' beside x'.
struct NodeState {
  Vec3<double> x = Vec3<double>::Zero(), v = Vec3<double>::Zero(), w = Vec3<double>::Zero();
  Mat3<double> R = Mat3<double>::Zero();
};

struct RoadState {
  std::vector<NodeState> bodies;
  double dissipated = 0, work = 0;  ///< J
};

RoadState plus(const RoadState& s, double h, const RoadState& rate) {
  RoadState out = s;
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    out.bodies[i].x += h * rate.bodies[i].x, out.bodies[i].v += h * rate.bodies[i].v;
    out.bodies[i].w += h * rate.bodies[i].w, out.bodies[i].R += h * rate.bodies[i].R;
  }
  out.dissipated += h * rate.dissipated, out.work += h * rate.work;
  return out;
}

class Road {
 public:
  Road(const MechanismScene& scene, const Entry& entry)
      : scene_(scene), model_(scene, entry, entry.probe_xi) {}

  RoadState start() const {
    RoadState out;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const auto& body = scene_.bodies[i];
      const Pose<double>& rest = model_.bodies()[i].rest;
      const Mat3<double> R = so3::exp<double>(body.start.theta) * rest.R;
      const Vec3<double> w = body.start.is_spin_of_body ? Vec3<double>(R * body.start.spin) : body.start.spin;
      out.bodies.push_back({rest.x + body.start.u, body.start.velocity, w, R});
    }
    return out;
  }

  RoadState moved(long steps) const {
    const double h = scene_.factor_end / double(steps);
    RoadState s = start();
    for (long n = 0; n < steps; ++n) {
      const double t = h * double(n);
      const RoadState k1 = rate(t, s), k2 = rate(t + h / 2, plus(s, h / 2, k1));
      const RoadState k3 = rate(t + h / 2, plus(s, h / 2, k2)), k4 = rate(t + h, plus(s, h, k3));
      s = plus(plus(plus(plus(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
      for (NodeState& body : s.bodies) body.R = (3 * body.R - body.R * body.R.transpose() * body.R) / 2;
    }
    return s;
  }

 private:
  double times(const BodyLoad& load, double t) const {
    if (load.times.empty()) return 1;
    double out = load.factors.front();
    for (std::size_t i = 1; i < load.times.size(); ++i) {
      const double share = (t - load.times[i - 1]) / (load.times[i] - load.times[i - 1]);
      if (share >= 0)
        out = load.factors[i - 1] + std::fmin(share, 1) * (load.factors[i] - load.factors[i - 1]);
    }
    return out;
  }

  /// About the node; the generic motion has forces and moments.
  Wrench acts(const BodyLoad& load, const NodeState& at) const {
    const Vec3<double> value = follows(load.type) ? Vec3<double>(at.R * load.value) : load.value;
    Wrench out;
    if (is_force(load.type))
      out << value, (at.R * load.point).cross(value);
    else
      out << Vec3<double>::Zero(), value;
    return out;
  }

  mechanism::Poses<double> from_rest(const RoadState& s) const {
    mechanism::Poses<double> out;
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
      const auto& body = model_.bodies()[i];
      const Mat3<double> turned = s.bodies[i].R * body.rest.R.transpose();
      const Vec3<double> shift =
          s.bodies[i].x + s.bodies[i].R * body.point - body.rest.x - body.rest.R * body.point;
      out.push_back({body.E.transpose() * shift, body.E.transpose() * turned * body.E});
    }
    return out;
  }

  /// (f_a, m_a, f_b, m_b) of a joint's damper on the motion.
  Eigen::Matrix<double, 12, 1> damped(std::size_t j, const RoadState& s) const {
    const auto& joint = scene_.joints[j];
    const NodeState &a = s.bodies[std::size_t(joint.a)], &b = s.bodies[std::size_t(joint.b)];
    const auto& potential = reference::find_formulation("potential")->in_double;
    reference::JointSpec spec = joint.spec;
    const Eigen::VectorXd strain = potential.strain(spec, {a.x, a.R}, {b.x, b.R});
    spec.law = reference::ShiftedSpec{reference::LinearSpec{joint.damping, false}, strain,
                                      Eigen::VectorXd::Zero(strain.size())};
    Eigen::Matrix<double, 12, 1> motion;
    motion << a.v, a.w, b.v, b.w;
    return potential.point(spec, {a.x, a.R}, {b.x, b.R}, true).tangent * motion;
  }

  RoadState rate(double t, const RoadState& s) const {
    std::vector<Wrench> on(s.bodies.size(), Wrench::Zero());
    RoadState out;
    const auto at = from_rest(s);
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) {
      const std::size_t a = std::size_t(scene_.joints[j].a), b = std::size_t(scene_.joints[j].b);
      const auto q = damped(j, s);
      on[a] += mechanism::reaction(model_, at, j, true) - q.head<6>();
      on[b] += mechanism::reaction(model_, at, j, false) - q.tail<6>();
      for (const auto& [i, load] : {std::pair(a, Wrench(q.head<6>())), std::pair(b, Wrench(q.tail<6>()))})
        out.dissipated += load.head<3>().dot(s.bodies[i].v) + load.tail<3>().dot(s.bodies[i].w);
    }
    for (const BodyLoad& load : scene_.loads) {
      const NodeState& body = s.bodies[std::size_t(load.body)];
      const Wrench acting = times(load, t) * acts(load, body);
      on[std::size_t(load.body)] += acting;
      out.work += acting.head<3>().dot(body.v) + acting.tail<3>().dot(body.w);
    }
    for (std::size_t i = 0; i < s.bodies.size(); ++i) out.bodies.push_back(of_body(i, s.bodies[i], on[i]));
    return out;
  }

  /// m (a + w' x c + w x (w x c)) = f,  J w' + w x J w + c x m (...) = m, about the node.
  NodeState of_body(std::size_t i, const NodeState& s, const Wrench& on) const {
    const auto& body = scene_.bodies[i];
    if (!body.moves) return {};
    const Vec3<double> c = s.R * body.center;
    const Mat3<double> J = s.R * body.inertia * s.R.transpose(), cross = skew<double>(c);
    const Vec3<double> inward = body.mass * s.w.cross(s.w.cross(c));
    Eigen::Matrix<double, 6, 6> M;
    M << body.mass * Mat3<double>::Identity(), -body.mass * cross, body.mass * cross,
        J - body.mass * cross * cross;
    Wrench left = on;
    left.head<3>() -= inward;
    left.tail<3>() -= s.w.cross(J * s.w) + c.cross(inward);
    const Wrench a = M.partialPivLu().solve(left);
    return {s.v, a.head<3>(), a.tail<3>(), skew<double>(s.w) * s.R};
  }

  const MechanismScene& scene_;
  mechanism::Model<double> model_;
};

/// Positions, orientations, energies at the end: of both roads, the largest difference, m, rad, J.
Measurement roads_apart(const Entry& entry) {
  const MechanismScene scene = generic_motion(entry);
  const reference::Curve curve = reference::solve_motion(scene, {&entry, entry.probe_xi});
  if (!curve.converged) return {std::nan(""), curve.outcome};
  const Road road(scene, entry);
  const RoadState coarse = road.moved(200), fine = road.moved(400);
  Measurement out;
  const auto compare = [&](double by_solver, double by_fine, double by_coarse, const char* what) {
    out.include(std::abs(tapped(by_solver) - (16 * by_fine - by_coarse) / 15), what);
  };
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const Pose<double>& node = curve.poses.back()[i];
    for (int k = 0; k < 3; ++k) compare(node.x[k], fine.bodies[i].x[k], coarse.bodies[i].x[k], "position");
    for (int k = 0; k < 9; ++k)
      compare(node.R(k / 3, k % 3), fine.bodies[i].R(k / 3, k % 3), coarse.bodies[i].R(k / 3, k % 3),
              "rotation");
  }
  compare(curve.energies.back()[2], fine.dissipated, coarse.dissipated, "dissipated");
  compare(curve.energies.back()[3], fine.work, coarse.work, "work");
  return out;
}

}  // namespace

void motion_road(Checks& checks) {
  add_property(checks, "motion_road", {Kind::linear_angular}, [](const Entry& entry, Kind, Draft f) {
    return f.measured(roads_apart(entry))
        .in("m, rad or J")
        .at_most(1e-9, "steps of 1/200 and 1/400 of the time, extrapolated: what is left of the fifth order")
        .by(Oracle::independent);
  });
}

}  // namespace halfway::verify
