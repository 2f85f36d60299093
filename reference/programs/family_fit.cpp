#include "reference/programs/family_fit.hpp"

#include "reference/record/worst.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace halfway::reference {
namespace {

/// What a joint of the family does with the joint frames as they are asked for.
struct Seen {
  Mat3<double> P_a, K_f, K_m;
  Vec3<double> theta, d, f, m_a, m_b;  ///< moments about the joint points, all in the axes of joint frame a
};

Seen seen_of(const Answered& a) {
  const Mat3<double> P_a = matrix_of(times(a.ask.a.q, a.ask.a.h)),
                     P_b = matrix_of(times(a.ask.b.q, a.ask.b.h));
  const Vec3<double> arm_a = matrix_of(a.ask.a.q) * a.ask.a.o, arm_b = matrix_of(a.ask.b.q) * a.ask.b.o;
  Seen out{P_a, a.ask.K_f, a.ask.K_m, {}, {}, {}, {}, {}};
  out.theta = so3::log<double>(Mat3<double>(P_a.transpose() * P_b));
  out.d = P_a.transpose() * (a.ask.b.x + arm_b - a.ask.a.x - arm_a);
  out.f = P_a.transpose() * part(a.loads, 2);
  out.m_a = P_a.transpose() * (part(a.loads, 1) - arm_a.cross(part(a.loads, 0)));
  out.m_b = P_a.transpose() * (part(a.loads, 3) - arm_b.cross(part(a.loads, 2)));
  return out;
}

/// The xi in [-1, 2] whose summed squares are least, by a scan and golden section.
template <class Fn>
std::pair<double, double> least(const Fn& squares) {
  double best = -1;
  for (int i = 1; i <= 60; ++i)
    if (squares(-1 + 0.05 * i) < squares(best)) best = -1 + 0.05 * i;
  double low = best - 0.05, high = best + 0.05;
  const double golden = (std::sqrt(5.) - 1) / 2;
  for (int i = 0; i < 60; ++i) {
    const double x = high - golden * (high - low), y = low + golden * (high - low);
    (squares(x) < squares(y) ? high : low) = squares(x) < squares(y) ? y : x;
  }
  return {(low + high) / 2, squares((low + high) / 2)};
}

struct NamedMeasure {
  const char* name;
  double (*factor)(double phi);  ///< h(phi)/phi
};
constexpr NamedMeasure kMeasures[] = {
    {"rotation vector", [](double) { return 1.; }},
    {"sin", [](double phi) { return std::sin(phi) / phi; }},
    {"2 sin(phi/2)", [](double phi) { return 2 * std::sin(phi / 2) / phi; }},
    {"2 tan(phi/2)", [](double phi) { return 2 * std::tan(phi / 2) / phi; }},
    {"4 tan(phi/4)", [](double phi) { return 4 * std::tan(phi / 4) / phi; }},
};

/// Of what is left of the moment or force that the joint gives, over its size.
template <class Left>
double squares_of(const std::vector<Seen>& all, const Left& left) {
  double sum = 0;
  for (const Seen& s : all)
    sum += left(s).squaredNorm() / larger(s.f.squaredNorm() * s.d.squaredNorm(), s.m_b.squaredNorm());
  return all.empty() ? std::nan("") : sum / double(all.size());
}

/// Along the axes of exp(xi theta).
Vec3<double> by_frame(const Seen& s, double xi, const Mat3<double>& K, const Vec3<double>& strain) {
  const Mat3<double> Q = so3::exp<double>(xi * s.theta);
  return Q * (K * (Q.transpose() * strain));
}

/// Where on d the force acts on b, from the moment on b without springs of rotation; and the squares left.
std::pair<double, double> force_place(const std::vector<Seen>& all) {
  double along = 0;
  for (const Seen& s : all) {
    const Vec3<double> moment = s.d.cross(s.f);
    along += s.m_b.dot(moment) / moment.squaredNorm();
  }
  const double at = 1 + along / double(all.size());
  const auto left = [&](const Seen& s) { return Vec3<double>(s.m_b - (at - 1) * s.d.cross(s.f)); };
  return {at, squares_of(all, left)};
}

/// What is left where the force acts as virtual work on the frame exp(xi theta) has it.
double conjugate_left(const std::vector<Seen>& all, double xi) {
  return squares_of(all, [&](const Seen& s) {
    const Mat3<double> spin = xi * so3::gamma<double>(xi * s.theta) * so3::gamma_inverse<double>(s.theta);
    return Vec3<double>(s.m_b + spin.transpose() * s.d.cross(s.f));
  });
}

}  // namespace

std::string FamilyFit::words() const {
  std::vector<std::string> out;
  if (moment_xi == moment_xi) out.push_back(fmt::format("frame xi = {:.3g}, measure {}", moment_xi, measure));
  if (force_xi == force_xi && !(std::abs(force_xi - moment_xi) < 0.005))
    out.push_back(fmt::format("force along frame xi = {:.3g}", force_xi));
  if (is_conjugate)
    out.emplace_back("force where virtual work puts it");
  else if (std::abs(force_at) < 0.01)
    out.emplace_back("force at a");
  else if (std::abs(force_at - 1) < 0.01)
    out.emplace_back("force at b");
  else if (force_at == force_at)
    out.push_back(fmt::format("force {:.3g} of the way from a to b", force_at));
  return fmt::format("{}", fmt::join(out, ", "));
}

FamilyFit fit_family(const std::vector<Answered>& answers) {
  std::vector<Seen> pulled, turned;
  for (const Answered& a : answers) {
    if (a.ask.K_m.isZero(0)) pulled.push_back(seen_of(a));
    if (a.ask.K_f.isZero(0)) turned.push_back(seen_of(a));
  }
  FamilyFit out;
  double squares = 0;
  if (!pulled.empty()) {
    const auto force = least([&](double xi) {
      return squares_of(pulled, [&](const Seen& s) {
        return Vec3<double>(s.d.norm() * (by_frame(s, xi, s.K_f, s.d) - s.f));
      });
    });
    const auto place = force_place(pulled);
    out.force_xi = force.first;
    out.force_at = place.first;
    const double by_work = conjugate_left(pulled, force.first);
    out.is_conjugate = by_work < place.second;
    squares += force.second + (out.is_conjugate ? by_work : place.second);
  }
  double best = std::nan("");
  for (const NamedMeasure& measure : kMeasures) {
    const auto moment = least([&](double xi) {
      return squares_of(turned, [&](const Seen& s) {
        const Vec3<double> strain = measure.factor(s.theta.norm()) * s.theta;
        return Vec3<double>(by_frame(s, xi, s.K_m, strain) - s.m_b);
      });
    });
    if (moment.second >= best) continue;
    best = moment.second;
    out.moment_xi = moment.first;
    out.measure = measure.name;
  }
  out.distance = std::sqrt(squares + (turned.empty() ? 0 : best));
  return out;
}

}  // namespace halfway::reference
