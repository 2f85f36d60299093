#include "reference/programs/properties.hpp"

#include "reference/numbers/random.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace halfway::reference {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// NaN where there is nothing to be relative to.
double ratio(double x, double scale) { return scale > 0 ? x / scale : kNothing; }

template <class Fn>
Defect worst_of(const std::vector<Ask>& asks, const Fn& defect) {
  Defect out;
  for (std::size_t i = 0; i < asks.size(); ++i) {
    const double angle = 2 * std::acos(std::min(1., std::abs(times(conjugate(times(asks[i].a.q, asks[i].a.h)),
                                                                   times(asks[i].b.q, asks[i].b.h))[0])));
    if (out.worst.include(defect(asks[i]), fmt::format("pose {}, relative rotation {:.3g} rad", i, angle)))
      out.at = asks[i];
  }
  return out;
}

/// How the answer to a changed question differs from the answer to the question.
template <class Change>
Defect changed(const Answerer& joint, const std::vector<Ask>& asks, const Change& change) {
  return worst_of(asks, [&](const Ask& ask) {
    Ask other = ask;
    change(other);
    return apart(joint(ask), joint(other));
  });
}

Eigen::Vector4d as_q(const Mat3<double>& R) {
  const auto q = so3::quaternion(R);
  return {q.w, q.v[0], q.v[1], q.v[2]};
}

Mat3<double> stiffness(Generator& g, Springs springs) {
  const double k = std::exp(g.uniform(std::log(3.), std::log(100.)));
  if (springs == Springs::isotropic) return k * Mat3<double>::Identity();
  Vec3<double> diagonal;
  for (int i = 0; i < 3; ++i) diagonal[i] = k * std::exp(g.uniform(-1.2, 1.2));
  const Mat3<double> axes =
      springs == Springs::full ? g.rotation(0.1, 3) : Mat3<double>(Mat3<double>::Identity());
  const Mat3<double> K = axes * diagonal.asDiagonal() * axes.transpose();
  return (K + K.transpose()) / 2;
}

/// Moment on b of a turn theta of b from a, both at the origin.
Vec3<double> moment(const Answerer& joint, const Mat3<double>& K_m, const Vec3<double>& theta,
                    double k_f = 0) {
  Ask ask;
  ask.K_f = k_f * Mat3<double>::Identity();
  ask.K_m = K_m;
  ask.b.q = quaternion_of(theta);
  return part(joint(ask), 3);
}

struct LoopPoint {
  Vec3<double> theta, theta_rate, p, p_rate;
};

LoopPoint loop_point(double s) {
  using std::cos, std::sin;
  LoopPoint out;
  out.theta = 0.64 * Vec3<double>(cos(s), sin(s), sin(2 * s + 0.7) / 2);
  out.theta_rate = 0.64 * Vec3<double>(-sin(s), cos(s), cos(2 * s + 0.7));
  out.p = Vec3<double>(0.3 * cos(s), 0.2 * sin(s + 0.4), 0.25 * cos(2 * s));
  out.p_rate = Vec3<double>(-0.3 * sin(s), 0.2 * cos(s + 0.4), -0.5 * sin(2 * s));
  return out;
}

}  // namespace

double apart(const TwelveLoads& q, const TwelveLoads& other) {
  const auto relative = [&](int first) {
    const double size = std::hypot(part(q, first).norm(), part(q, first + 2).norm());
    const double off = std::hypot((part(q, first) - part(other, first)).norm(),
                                  (part(q, first + 2) - part(other, first + 2)).norm());
    return off == 0 && size == 0 ? 0 : ratio(off, size);
  };
  return q.isZero(0) ? kNothing : larger(relative(0), relative(1));
}

std::vector<Ask> generic_asks(int count, double least, double largest, Springs springs, bool bond) {
  Generator g(20112);
  std::vector<Ask> out;
  for (int i = 0; i < count; ++i) {
    Ask ask;
    ask.is_bond = bond;
    ask.K_f = 10 * stiffness(g, springs);
    ask.K_m = stiffness(g, springs);
    if (bond) ask.K_f(1, 1) = ask.K_f(0, 0), ask.K_m(1, 1) = ask.K_m(0, 0);
    for (AskedBody* body : {&ask.a, &ask.b}) {
      body->o = g.vector(0.4);
      body->h = as_q(g.rotation(0.1, 2));
    }
    ask.a.x = g.vector(1);
    ask.a.q = as_q(g.rotation(0.1, 3));
    const double phi = least + (largest - least) * (count > 1 ? double(i) / (count - 1) : 1);
    const Vec3<double> rest = bond ? Vec3<double>::Unit(2) : Vec3<double>(Vec3<double>::Zero());
    place_b(ask, phi * g.direction(), rest + g.vector(0.3));
    out.push_back(ask);
  }
  return out;
}

Defect force_balance(const Answerer& joint, const std::vector<Ask>& asks) {
  return worst_of(asks, [&](const Ask& ask) {
    const TwelveLoads q = joint(ask);
    return ratio((part(q, 0) + part(q, 2)).norm(), part(q, 2).norm());
  });
}

Defect moment_balance(const Answerer& joint, const std::vector<Ask>& asks) {
  return worst_of(asks, [&](const Ask& ask) {
    const TwelveLoads q = joint(ask);
    const Vec3<double> sum = part(q, 1) + part(q, 3) + (ask.b.x - ask.a.x).cross(part(q, 2));
    return ratio(sum.norm(), larger(part(q, 1).norm(), part(q, 3).norm()));
  });
}

Defect body_order(const Answerer& joint, const std::vector<Ask>& asks) {
  return worst_of(asks, [&](const Ask& ask) {
    Ask exchanged = ask;
    std::swap(exchanged.a, exchanged.b);
    if (ask.is_bond) {  // it points from the other end: z the other way
      for (AskedBody* body : {&exchanged.a, &exchanged.b}) body->h = times(body->h, Eigen::Vector4d::Unit(1));
    }
    const TwelveLoads q = joint(exchanged);
    TwelveLoads back;
    back << q.tail<6>(), q.head<6>();
    return apart(joint(ask), back);
  });
}

Defect objectivity(const Answerer& joint, const std::vector<Ask>& asks) {
  const Eigen::Vector4d turn = quaternion_of(Vec3<double>(1.1, -0.7, 1.9));
  const Mat3<double> Q = matrix_of(turn);
  return worst_of(asks, [&](const Ask& ask) {
    Ask moved = ask;
    for (AskedBody* body : {&moved.a, &moved.b}) {
      body->x = Q * body->x + Vec3<double>(0.3, -0.5, 0.2);
      body->q = times(turn, body->q);
    }
    const TwelveLoads q = joint(moved);
    TwelveLoads seen;
    for (int i = 0; i < 4; ++i) seen.segment<3>(3 * i) = Q.transpose() * part(q, i);
    return apart(joint(ask), seen);
  });
}

Defect ends(const Answerer& joint, const std::vector<Ask>& asks) {
  return worst_of(asks, [&](const Ask& ask) {
    Ask ended = ask;
    Vec3<double> arm[2];
    for (int node = 0; node < 2; ++node) {
      AskedBody& body = node == 0 ? ended.a : ended.b;
      arm[node] = matrix_of(body.q) * body.o;
      body.x += arm[node], body.q = times(body.q, body.h);
      body.o.setZero(), body.h = Eigen::Vector4d(1, 0, 0, 0);
    }
    TwelveLoads back = joint(ended);
    for (int node = 0; node < 2; ++node)
      back.segment<3>(6L * node + 3) += arm[node].cross(Vec3<double>(part(back, 2 * node)));
    return apart(joint(ask), back);
  });
}

Defect double_cover(const Answerer& joint, const std::vector<Ask>& asks) {
  return changed(joint, asks, [](Ask& ask) { ask.b.q = -ask.b.q; });
}

Defect mass_dependence(const Answerer& joint, const std::vector<Ask>& asks) {
  return changed(joint, asks,
                 [](Ask& ask) { ask.a.mass = 3, ask.a.inertia = 0.4, ask.b.mass = 0.5, ask.b.inertia = 2; });
}

Defect far_away(const Answerer& joint, const std::vector<Ask>& asks) {
  return changed(joint, asks, [](Ask& ask) {
    for (AskedBody* body : {&ask.a, &ask.b}) body->x += Vec3<double>(1024, -512, 256);  // exact to 1e-13 m
  });
}

Defect proportionality(const Answerer& joint, const std::vector<Ask>& asks) {
  return worst_of(asks, [&](const Ask& ask) {
    Ask stiffer = ask;
    stiffer.K_f *= 4, stiffer.K_m *= 4;
    return apart(joint(ask), TwelveLoads(joint(stiffer) / 4));
  });
}

Defect tensoriality(const Answerer& joint, double k_f) {
  Generator g(20113);
  const Mat3<double> K = Mat3<double>::Identity();
  Defect out;
  for (int i = 0; i < 40; ++i) {
    const Vec3<double> theta = 1.3 * (i + 1) / 40 * g.direction();
    const Mat3<double> Q = g.rotation(0.1, 3);
    const Vec3<double> m = moment(joint, K, theta, k_f), turned = moment(joint, K, Q * theta, k_f);
    if (out.worst.include(ratio((turned - Q * m).norm(), m.norm()),
                          fmt::format("relative rotation {:.3g} rad", theta.norm()))) {
      out.at.K_m = K;
      out.at.b.q = quaternion_of(Q * theta);
    }
  }
  return out;
}

double loop_work(const Answerer& joint, const Vec3<double>& k_f, const Vec3<double>& k_m, bool moves,
                 const Vec3<double>& around) {
  constexpr int kPoints = 128;  // the trapezoidal rule of a smooth loop converges faster than any power
  double net = 0, path = 0;
  for (int i = 0; i < kPoints; ++i) {
    const LoopPoint at = loop_point(2 * std::numbers::pi * i / kPoints);
    Ask ask;
    ask.K_f = k_f.asDiagonal();
    ask.K_m = k_m.asDiagonal();
    place_b(ask, at.theta, moves ? Vec3<double>(around + at.p) : around);
    const TwelveLoads q = joint(ask);
    const Vec3<double> spin = so3::gamma<double>(at.theta) * at.theta_rate;
    const double by_turning = part(q, 3).dot(spin), by_moving = moves ? part(q, 2).dot(at.p_rate) : 0;
    net += by_turning + by_moving;
    path += std::abs(by_turning) + std::abs(by_moving);
  }
  return path > 0 ? net / path : kNothing;
}

double free_spin(const Answerer& joint, int shaft) {
  constexpr double kBend = 0.2;
  constexpr double kTurns[] = {0.2, 0.7, 1.1, 1.6, 2,   2.5, 3,    3.14, 3.15, 3.6,
                               4.2, 4.7, 5.3, 6,   6.6, 7.9, 9.42, 9.43, 11,   12.4};
  Vec3<double> k = Vec3<double>::Ones();
  k[shaft] = 0;
  const Vec3<double> about = Vec3<double>::Unit((shaft + 1) % 3), along = Vec3<double>::Unit(shaft);
  double worst = 0;
  for (const double s : kTurns) {  // to both sides of pi and 3 pi
    Ask ask;
    ask.K_m = k.asDiagonal();
    ask.b.q = times(quaternion_of(kBend * about), quaternion_of(s * along));
    keep_largest(worst, (part(joint(ask), 3) - kBend * about).norm() / kBend);
  }
  return worst;
}

double secant_stiffness(const Answerer& joint, int axis, double phi, double k_f) {
  return moment(joint, Mat3<double>::Identity(), phi * Vec3<double>::Unit(axis), k_f)[axis] / phi;
}

SecondOrder second_order(const Answerer& joint, double digits) {
  const Vec3<double> k(2, 3, 7);
  const double h = std::pow(10, -digits / 6);  // errors h^4 and 10^-digits / h^2 are alike
  const auto even = [&](const Vec3<double>& u, double step) {
    return Vec3<double>((moment(joint, k.asDiagonal(), step * u) + moment(joint, k.asDiagonal(), -step * u)) /
                        (2 * step * step));
  };
  const auto odd = [&](const Vec3<double>& u, double step) {
    return Vec3<double>((moment(joint, k.asDiagonal(), step * u) - moment(joint, k.asDiagonal(), -step * u)) /
                        (2 * step));
  };
  const auto extrapolated = [&](const auto& at, const Vec3<double>& u) {
    return Vec3<double>((4 * at(u, h) - at(u, 2 * h)) / 3);
  };
  SecondOrder out;
  Measurement first, residual;
  const Vec3<double> directions[] = {{1, 0.5, -0.7}, {-0.3, 1.1, 0.6}, {0.8, -0.2, 0.9}};
  Vec3<double> up = Vec3<double>::Zero(), down = Vec3<double>::Zero();
  std::vector<std::pair<Vec3<double>, Vec3<double>>> seen;  // products, what is left
  for (const Vec3<double>& u : directions) {
    const Vec3<double> Ku = k.cwiseProduct(u), products(u[1] * u[2], u[2] * u[0], u[0] * u[1]);
    first.include((extrapolated(odd, u) - Ku).norm() / Ku.norm(), "");
    const Vec3<double> left = extrapolated(even, u) - u.cross(Ku) / 2;
    up += products.cwiseProduct(left), down += products.cwiseProduct(products);
    seen.emplace_back(products, left);
  }
  out.b = up.cwiseQuotient(down);
  for (const auto& [products, left] : seen)
    residual.include((left - out.b.cwiseProduct(products)).norm() / k.norm(), "");
  out.first_defect = first.value();
  out.residual = residual.value();
  return out;
}

}  // namespace halfway::reference
