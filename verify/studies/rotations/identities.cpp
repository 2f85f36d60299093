// The paper's identities, at 50 digits and in double, on generic rotations from 1e-8 rad to near pi.
//
// Perturbations are dual numbers, so no identity is checked against another formula for its derivative.
#include "reference/truth/closed_forms.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/identity_terms.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

using namespace identity;

/// dbar and R^ as dual numbers when the nodes move at (dx, w), joint points with arms.
template <class T>
struct Moved {
  explicit Moved(const At<T>& s) {
    const Mat3<Dual<T>> P_a = turning<T>(s.P_a, w_a<T>()), P_b = turning<T>(s.P_b, w_b<T>());
    const Vec3<Dual<T>> theta = so3::log<Dual<T>>(P_a.transpose() * P_b);
    frame = P_a * so3::exp<Dual<T>>(Dual<T>(s.xi) * theta);
    const Vec3<T> rate =
        dx_b<T>() + w_b<T>().cross(s.arm_b) - dx_a<T>() - w_a<T>().cross(s.arm_a);  // of d [9]
    dbar = frame.transpose() * moving<T>(s.d, rate);
  }
  Mat3<Dual<T>> frame;
  Vec3<Dual<T>> dbar;
};

/// Residual of a perturbation of dbar with the levers on w_b and w_a [29].
template <class T>
double residual_29(const At<T>& s, const Mat3<T>& on_b, const Mat3<T>& on_a) {
  const Vec3<T> claimed =
      s.frame(s.xi).transpose() * Vec3<T>(dx_b<T>() - on_b * w_b<T>() - dx_a<T>() + on_a * w_a<T>());
  return size<T>(rate_of<T, 1>(Moved<T>(s).dbar) - claimed);
}

/// The moment of [37] moving with theta at `rate`: dm of dual numbers.
template <class T>
Vec3<T> moment_rate(const At<T>& s, const Vec3<T>& rate) {
  const Vec3<Dual<T>> theta = moving<T>(s.theta, rate);
  const Mat3<Dual<T>> K = stiffness<T>().template cast<Dual<T>>();
  return rate_of<T, 1>(so3::exp<Dual<T>>(Dual<T>(s.xi) * theta) * (K * theta));
}
template <class T>
Mat3<T> bracket_44(const At<T>& s) {
  return stiffness<T>() -
         s.xi * skew<T>(stiffness<T>() * s.theta) * so3::gamma<T>(s.xi * s.theta).transpose();
}

struct Identity {
  const char* name;
  double (*real50)(const Sample&);
  double (*in_double)(const Sample&);
};

/// One residual, written once for both scalars.
#define HALFWAY_IDENTITY(label, expression) \
  Identity {                                \
    label,                                  \
        [](const Sample& sample) {          \
          using T = Real50;                 \
          const At<T> s(sample);            \
          return double(expression);        \
        },                                  \
        [](const Sample& sample) {          \
          using T = double;                 \
          const At<T> s(sample);            \
          return double(expression);        \
        }                                   \
  }

template <class T>
double eq_6(const At<T>& s) {
  const T phi = s.theta.norm();
  return larger(size<T>((s.R * s.theta - s.theta) / phi),
                size<T>((s.R.transpose() * s.theta - s.theta) / phi));
}
template <class T>
double eq_44(const At<T>& s) {
  Mat3<T> dm;
  for (int k = 0; k < 3; ++k) dm.col(k) = moment_rate<T>(s, Vec3<T>::Unit(k));
  return size<T>(so3::exp<T>(s.xi * s.theta) * bracket_44(s) - dm) / 2;  // over the largest stiffness
}
template <class T>
double eq_46(const At<T>& s) {
  Mat3<T> dm;
  for (int k = 0; k < 3; ++k) dm.col(k) = moment_rate<T>(s, Vec3<T>::Unit(k));
  const T miss = bracket_44(s).determinant() - dm.determinant();
  return size<T>(Vec3<T>(miss, T(0), T(0))) / 8;  // over its cube
}
template <class T>
double eq_66(const At<T>& s) {
  const auto R = turning<T>(s.R, w_b<T>());
  const Vec3<T> half_spin = spin_of<T>(so3::half<Dual<T>>(R));
  return size<T>(half_spin - (s.one + s.tilde).inverse() * w_b<T>());
}
template <class T>
double eq_70(const At<T>& s) {
  const Mat3<T> z = skew<T>(s.zeta());
  return larger(size<T>(s.tilde - (s.one + z) * (s.one - z).inverse()),
                size<T>(s.tilde - (s.one - z).inverse() * (s.one + z)));
}
template <class T>
double eq_72(const At<T>& s) {
  return larger(size<T>(so3::cayley<T>(s.zeta()) - s.tilde),
                size<T>(so3::cayley_inverse<T>(s.tilde) - s.zeta()));
}
template <class T>
double eq_53(const At<T>& s) {
  using std::sin;
  const reference::closed::Geometry<T> g{s.P_a, s.P_b, s.arm_a, s.arm_b, s.d, s.theta};
  const Vec3<T> psi = reference::closed::Jointc::strain(g);
  const T phi = s.theta.norm();
  return larger(size<T>(psi - axial(s.R)), size<T>(psi - sin(phi) / phi * s.theta));
}
template <class T>
double eq_55(const At<T>& s) {
  namespace closed = reference::closed;
  const closed::Geometry<T> g{s.P_a, s.P_b, s.arm_a, s.arm_b, s.d, s.theta};
  closed::Geometry<Dual<T>> moved;
  moved.P_a = turning<T>(s.P_a, w_a<T>());
  moved.P_b = turning<T>(s.P_b, w_b<T>());
  const Vec3<T> claimed =
      closed::Jointc::gradient(g, true) * w_a<T>() + closed::Jointc::gradient(g, false) * w_b<T>();
  return size<T>(rate_of<T, 1>(closed::Jointc::strain(moved)) - claimed);
}

const Identity kIdentities[] = {
    HALFWAY_IDENTITY("eq_6", eq_6<T>(s)),
    HALFWAY_IDENTITY("eq_12",
                     size<T>(s.R - so3::exp<T>(s.xi * s.theta) * so3::exp<T>((T(1) - s.xi) * s.theta))),
    HALFWAY_IDENTITY("eq_13", size<T>(s.R - so3::half(s.R) * so3::half(s.R))),
    HALFWAY_IDENTITY("eq_20",
                     size<T>(s.frame(s.xi) - s.P_b * so3::exp<T>((T(1) - s.xi) * s.theta).transpose())),
    HALFWAY_IDENTITY("eq_25", size<T>(spin_of<T>(Moved<T>(s).frame) - s.spin(s.xi) * w_b<T>() -
                                      s.spin(T(1) - s.xi).transpose() * w_a<T>())),
    HALFWAY_IDENTITY("eq_27", size<T>(spin_of<T>(so3::exp<Dual<T>>(moving<T>(s.theta, w_a<T>()))) -
                                      so3::gamma(s.theta) * w_a<T>())),
    HALFWAY_IDENTITY("eq_28", size<T>(s.spin(s.xi) + s.spin(T(1) - s.xi).transpose() - s.one)),
    HALFWAY_IDENTITY("eq_29_corrected",
                     residual_29<T>(s, skew(s.arm_b) - skew(s.d) * s.spin(s.xi),
                                    skew(s.arm_a) + skew(s.d) * s.spin(T(1) - s.xi).transpose())),
    HALFWAY_IDENTITY("eq_32", size<T>(s.spin(T(0.5)) - s.frame(T(0.5)) * (s.one + s.tilde).inverse() *
                                                           s.frame(T(0.5)).transpose())),
    HALFWAY_IDENTITY("eq_44", eq_44<T>(s)),
    HALFWAY_IDENTITY("eq_45",
                     size<T>(s.R.transpose() * so3::gamma(s.theta) - so3::gamma(s.theta).transpose())),
    HALFWAY_IDENTITY("eq_46", eq_46<T>(s)),
    HALFWAY_IDENTITY("eq_52_53", eq_53<T>(s)),
    HALFWAY_IDENTITY("eq_55", eq_55<T>(s)),
    HALFWAY_IDENTITY("eq_64", size<T>(s.spin_tilde(s.xi) + s.spin_tilde(T(1) - s.xi).transpose() - s.one)),
    HALFWAY_IDENTITY("eq_66", eq_66<T>(s)),
    HALFWAY_IDENTITY("eq_67", size<T>(s.tilde.transpose() * (s.one + s.tilde) - s.one - s.tilde.transpose())),
    HALFWAY_IDENTITY("eq_68", size<T>((s.one + s.tilde) * s.tilde.transpose() - s.one - s.tilde.transpose())),
    HALFWAY_IDENTITY("eq_69",
                     size<T>(s.one - (s.one + s.tilde).inverse() - (s.one + s.tilde.transpose()).inverse())),
    HALFWAY_IDENTITY("eq_70", eq_70<T>(s)),
    HALFWAY_IDENTITY("eq_71", size<T>((s.one + s.tilde).inverse() - (s.one - skew<T>(s.zeta())) / T(2))),
    HALFWAY_IDENTITY("eq_72", eq_72<T>(s)),
};
#undef HALFWAY_IDENTITY

Measurement worst_sample(double (*residual)(const Sample&), double unit) {
  Measurement out;
  for (const Sample& s : samples()) {
    out.include(residual(s) / unit,
                fmt::format("phi = {:.9g} rad, n = ({:.3g}, {:.3g}, {:.3g}), xi = {}", s.theta.norm(),
                            s.theta[0] / s.theta.norm(), s.theta[1] / s.theta.norm(),
                            s.theta[2] / s.theta.norm(), s.xi));
  }
  return out;
}

constexpr double kDoubleLimit = 16;
constexpr const char* kDoubleReason =
    "entries of order 1; four factors of up to 4 eps each (contract of so3.hpp)";

double residual_as_printed(const Sample& sample) {
  using T = Real50;
  const At<T> s(sample);
  return residual_29<T>(s, skew(s.arm_b) - s.spin(s.xi), skew(s.arm_a) + s.spin(T(1) - s.xi).transpose());
}

double residual_as_corrected(const Sample& sample) {
  using T = Real50;
  const At<T> s(sample);
  return residual_29<T>(s, skew(s.arm_b) - skew(s.d) * s.spin(s.xi),
                        skew(s.arm_a) + skew(s.d) * s.spin(T(1) - s.xi).transpose());
}

Finding missing_arm(double (*residual)(const Sample&)) {
  return known_defect(
      "identities/eq_29_printed", "identities", worst_sample(residual, 1), 0.1, 10, Oracle::independent,
      "the paper's print lacks [d]: it must miss by the order of the spins, or the erratum is wrong");
}

/// A tenth more or less of what is missing is still of that order: only a print that misses nothing shows
/// that the band can fail.
Finding erratum_is_seen() {
  const Finding of_corrected = missing_arm(residual_as_corrected);
  return finding("mutants/eq_29_as_it_should_be")
      .about("mutants")
      .measured(tapped(double(of_corrected.verdict == Verdict::fail)))
      .equal(1, 0, "were [29] printed right, eq_29_printed would have to fail")
      .by(Oracle::independent);
}

}  // namespace

void identities(Checks& checks) {
  for (const Identity& identity : kIdentities) {
    const std::string name = fmt::format("identities/{}", identity.name);
    checks.push_back({name, "identities", [=]() -> std::vector<Finding> {
                        return {
                            at_most(name + "/50_digits", "identities", worst_sample(identity.real50, 1),
                                    1e-45, "", Oracle::independent,
                                    "50 digits; five of them for sums, products and 3x3 inverses"),
                            at_most(name + "/double", "identities",
                                    worst_sample(identity.in_double, std::numeric_limits<double>::epsilon()),
                                    kDoubleLimit, "eps", Oracle::independent, kDoubleReason)};
                      }});
  }
  checks.push_back({"identities/eq_29_printed", "identities",
                    [] { return std::vector{missing_arm(residual_as_printed)}; }});
  checks.push_back(
      {"mutants/eq_29_as_it_should_be", "identities", [] { return std::vector{erratum_is_seen()}; }});
}

}  // namespace halfway::verify
