#include "verify/oracle/measures.hpp"

#include "verify/oracle/replay.hpp"

#include <Eigen/LU>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

using Loads50 = Eigen::Matrix<Real50, 12, 1>;
using Tangent50 = Eigen::Matrix<Real50, 12, 12>;
using V50 = Vec3<Real50>;
using M50 = Mat3<Real50>;

/// NaN where there is nothing to be relative to: loads or a tangent of zero on generic probes.
double ratio(const Real50& defect, const Real50& scale) {
  return scale > Real50(0) ? double(defect / scale) : std::numeric_limits<double>::quiet_NaN();
}

Real50 largest(const auto& m) { return largest_entry<Real50>(m); }

/// Keeps the worst of the probes; a NaN is the worst of all.
template <class Fn>
Measurement worst(const JointUnderTest& joint, const std::vector<Probe>& probes, const Fn& defect_of) {
  Measurement out;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Probe& probe = probes[i];
    const double defect =
        defect_of(probe, exact_pose(probe.a, probe.spec.a), exact_pose(probe.b, probe.spec.b));
    const bool is_worst =
        out.include(defect, fmt::format("probe {}, relative rotation {:.4g} rad", i, probe.phi));
    if (is_worst && !joint.formulation.empty())
      out.set_replay(eval_request(joint.formulation, probe.spec, probe.a, probe.b));
  }
  return out;
}

/// Pose moved along coordinate k of (dx, w): derivative in the dual part.
Pose<Dual50> moved(const Pose<Real50>& pose, int k) {
  Pose<Dual50> out = reference::cast<Dual50>(pose);
  if (k < 3) {
    out.x[k].d = Real50(1);
    return out;
  }
  const M50 rate = skew<Real50>(V50::Unit(k - 3)) * pose.R;
  for (int i = 0; i < 9; ++i) out.R.data()[i].d = rate.data()[i];
  return out;
}

/// Calls fn(k, a, b) with the duals of the two poses moved along coordinate k = 0 ... 11.
template <class Fn>
void each_direction(const Pose<Real50>& a, const Pose<Real50>& b, const Fn& fn) {
  for (int k = 0; k < 6; ++k) fn(k, moved(a, k), reference::cast<Dual50>(b));
  for (int k = 0; k < 6; ++k) fn(k + 6, reference::cast<Dual50>(a), moved(b, k));
}

V50 vector(double x, double y, double z) { return {Real50(x), Real50(y), Real50(z)}; }

}  // namespace

double loads_apart(const Eigen::Matrix<Real50, 12, 1>& q, const Eigen::Matrix<Real50, 12, 1>& other) {
  const auto part = [](const Loads50& v, int first) {
    Eigen::Matrix<Real50, 6, 1> out;
    out << v.segment<3>(first), v.segment<3>(first + 6);
    return out;
  };
  const auto relative = [&](int first) {
    const auto mine = part(q, first), theirs = part(other, first);
    const bool both_zero = largest(mine) == Real50(0) && largest(theirs) == Real50(0);
    return both_zero ? 0 : ratio((mine - theirs).norm(), mine.norm());
  };
  return largest(q) == Real50(0) ? ratio(Real50(0), Real50(0)) : larger(relative(0), relative(3));
}

JointUnderTest under_test(const Entry& entry) {
  const Entry* e = &entry;
  return {[e](const JointSpec& s, const Pose<Real50>& a, const Pose<Real50>& b, bool with_tangent) {
            return reference::node_loads<Real50>(*e, s, a, b, with_tangent);
          },
          [e](const JointSpec& s, const Pose<Dual50>& a, const Pose<Dual50>& b, bool with_tangent) {
            return reference::node_loads<Dual50>(*e, s, a, b, with_tangent);
          },
          [e](const JointSpec& s, const Pose<Dual50>& a, const Pose<Dual50>& b) {
            return e->in_dual50.energy(s, a, b);
          },
          std::string(entry.name)};
}

Pose<Real50> exact_pose(const Pose<double>& pose, const JointEnd<double>& end) {
  const M50 H = end.H.cast<Real50>();
  const M50 P = so3::matrix(so3::quaternion<Real50>(pose.R.cast<Real50>() * H));
  return {pose.x.cast<Real50>(), P * H.inverse()};
}

Measurement force_balance(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    const Loads50 q = joint.loads(probe.spec, a, b, false).q;
    return ratio((q.segment<3>(0) + q.segment<3>(6)).norm(), q.segment<3>(6).norm());
  });
}

Measurement moment_balance(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    const Loads50 q = joint.loads(probe.spec, a, b, false).q;
    const V50 m_a = q.segment<3>(3), m_b = q.segment<3>(9), f_b = q.segment<3>(6);
    return ratio((m_a + m_b + (b.x - a.x).cross(f_b)).norm(), m_a.norm() + m_b.norm());
  });
}

Measurement node_swap(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    JointSpec exchanged = probe.spec;
    std::swap(exchanged.a, exchanged.b);
    exchanged.axis = -exchanged.axis;  // seen from its other end the rod runs the other way
    const Loads50 q_b_a = joint.loads(exchanged, b, a, false).q;
    Loads50 back;
    back << q_b_a.tail<6>(), q_b_a.head<6>();
    return loads_apart(joint.loads(probe.spec, a, b, false).q, back);
  });
}

Measurement objectivity(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  const M50 Q = so3::exp<Real50>(vector(1.1, -0.7, 1.9));
  const V50 shift = vector(0.3, -5, 2);
  const auto carried = [&](const Pose<Real50>& pose) { return Pose<Real50>{Q * pose.x + shift, Q * pose.R}; };
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    Loads50 seen = joint.loads(probe.spec, carried(a), carried(b), false).q;
    for (int i = 0; i < 12; i += 3) seen.segment<3>(i) = V50(Q.transpose() * seen.segment<3>(i));
    return loads_apart(joint.loads(probe.spec, a, b, false).q, seen);
  });
}

Measurement tangent_by_duals(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    Tangent50 derivative;
    each_direction(a, b, [&](int k, const Pose<Dual50>& da, const Pose<Dual50>& db) {
      const auto q = joint.dual_loads(probe.spec, da, db, false).q;
      for (int i = 0; i < 12; ++i) derivative(i, k) = q[i].d;
    });
    const Tangent50 tangent = joint.loads(probe.spec, a, b, true).tangent;
    return ratio(largest(tangent - derivative), largest(derivative));
  });
}

Measurement energy_gradient(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    Loads50 gradient = Loads50::Zero();
    bool has_energy = true;
    each_direction(a, b, [&](int k, const Pose<Dual50>& da, const Pose<Dual50>& db) {
      const std::optional<Dual50> energy = joint.dual_energy(probe.spec, da, db);
      has_energy = has_energy && energy;
      if (energy) gradient[k] = energy->d;
    });
    if (!has_energy) return std::numeric_limits<double>::quiet_NaN();
    const Loads50 q = joint.loads(probe.spec, a, b, false).q;
    return ratio(largest(q - gradient), largest(gradient));
  });
}

Measurement symmetry_defect(const JointUnderTest& joint, const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    const NodeLoads<Real50> r = joint.loads(probe.spec, a, b, true);
    Tangent50 defect = r.tangent - r.tangent.transpose();
    for (int i : {3, 9}) defect.block<3, 3>(i, i) += skew<Real50>(r.q.segment<3>(i));
    return ratio(largest(defect), largest(r.tangent));
  });
}

Measurement load_difference(const JointUnderTest& joint, const JointUnderTest& other,
                            const std::vector<Probe>& probes) {
  return worst(joint, probes, [&](const Probe& probe, const Pose<Real50>& a, const Pose<Real50>& b) {
    return loads_apart(other.loads(probe.spec, a, b, false).q, joint.loads(probe.spec, a, b, false).q);
  });
}

Fingerprint fingerprint(const JointUnderTest& joint, double xi) {
  const Vec3<double> k(2, 3, 7);
  JointSpec spec;
  spec.kind = Kind::angular;
  spec.xi = xi;
  spec.law = reference::LinearSpec{Eigen::MatrixXd(k.asDiagonal()), false};
  const Real50 h("1e-12");  // truncation h^2 = 1e-24, cancellation 1e-50/h^2 = 1e-26
  const auto moment = [&](const V50& theta) -> V50 {
    return joint.loads(spec, {}, {V50::Zero(), so3::exp<Real50>(theta)}, false).q.tail<3>();
  };
  Fingerprint out;
  Eigen::Matrix<double, 9, 2> form;
  Eigen::Matrix<double, 9, 1> second;
  const V50 directions[] = {vector(1, 0.5, -0.7), vector(-0.3, 1.1, 0.6), vector(0.8, -0.2, 0.9)};
  for (int i = 0; i < 3; ++i) {
    const V50& u = directions[i];
    const V50 Ku = k.cast<Real50>().cwiseProduct(u);
    const V50 plus = moment(h * u), minus = moment(-h * u);
    const V50 first = (plus - minus) / (Real50(2) * h);
    keep_largest(out.linear_defect, ratio((first - Ku).norm(), Ku.norm()));
    second.segment<3>(3 * i) = V50((plus + minus) / (Real50(2) * h * h)).cast<double>();
    form.block<3, 1>(3 * i, 0) = V50(u.cross(Ku)).cast<double>();
    form.block<3, 1>(3 * i, 1) =
        V50((k[0] - k[1] + k[2]) * V50(u[1] * u[2], u[2] * u[0], u[0] * u[1])).cast<double>();
  }
  // Normal equations: the two columns are far from parallel, and Householder's takes nine seconds to compile.
  const Eigen::Matrix2d normal = form.transpose() * form;
  const Eigen::Vector2d fit = normal.inverse() * (form.transpose() * second);
  out.alpha = fit[0];
  out.beta = fit[1];
  out.residual = (form * fit - second).norm() / form.norm();
  return out;
}

}  // namespace halfway::verify
