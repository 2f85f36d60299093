#include "reference/solve/stability/moments.hpp"

#include "halfway/rotations/so3.hpp"

#include <gsl/gsl_integration.h>

#include <array>
#include <memory>
#include <numbers>

namespace halfway::reference {
namespace {

/// (R a) x F, or its share of the magnitude.
template <class T>
struct Couple {
  Vec3<T> arm, force;
};

template <class T>
std::array<Couple<T>, 2> couples(const MomentLoad<T>& load, const Mat3<T>& R) {
  const int k = load.axis, i = (k + 1) % 3, j = (k + 2) % 3;
  const Mat3<T> arms = R * so3::exp<T>(-load.square_at * Vec3<T>::Unit(k));
  const bool two = load.type == MomentType::semi_tangential;
  const T share = two ? T(1) / T(2) : T(1), other = two ? share : T(0);
  return {{{arms.col(i), share * Vec3<T>::Unit(j)}, {arms.col(j), -other * Vec3<T>::Unit(i)}}};
}

bool of_couples(MomentType type) {
  return type == MomentType::semi_tangential || type == MomentType::quasi_tangential;
}

}  // namespace

const char* to_string(MomentType type) {
  switch (type) {
    case MomentType::fixed:
      return "fixed";
    case MomentType::follower:
      return "follower";
    case MomentType::semi_tangential:
      return "semi_tangential";
    default:
      return "quasi_tangential";
  }
}

template <class T>
AppliedMoment<T> applied_moment(const MomentLoad<T>& load, const T& M, const Mat3<T>& R) {
  AppliedMoment<T> out{Vec3<T>::Zero(), Mat3<T>::Zero(), Vec3<T>::Unit(load.axis)};
  if (load.type == MomentType::follower) {
    out.m_M = R.col(load.axis);
    out.m_w = -M * skew(out.m_M);
  } else if (of_couples(load.type)) {
    out.m_M.setZero();
    for (const Couple<T>& c : couples(load, R)) {
      out.m_M += c.arm.cross(c.force);
      // d(arm x F) = (w x arm) x F = arm (F . w) - (F . arm) w
      out.m_w += M * (c.arm * c.force.transpose() - c.arm.dot(c.force) * Mat3<T>::Identity());
    }
  }
  out.m = M * out.m_M;
  return out;
}

template <class T>
std::optional<T> moment_potential(const MomentLoad<T>& load, const T& M, const Mat3<T>& R) {
  if (!of_couples(load.type)) return std::nullopt;
  T sum(0);
  for (const Couple<T>& c : couples(load, R)) sum += c.arm.dot(c.force);
  return -M * sum;
}

double ziegler_work(MomentType type) {
  constexpr int kAxes[] = {0, 1, 2};
  constexpr double kAngles[] = {std::numbers::pi, std::numbers::pi, -std::numbers::pi};
  constexpr std::size_t kPoints = 24;  // the power is a trigonometric polynomial of degree 1 of the angle
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> gauss(
      gsl_integration_glfixed_table_alloc(kPoints), &gsl_integration_glfixed_table_free);
  Mat3<double> R = Mat3<double>::Identity();
  double work = 0;
  for (int leg = 0; leg < 3; ++leg) {
    const Vec3<double> axis = Vec3<double>::Unit(kAxes[leg]);
    for (std::size_t i = 0; i < kPoints; ++i) {
      double angle = 0, weight = 0;
      gsl_integration_glfixed_point(0, kAngles[leg], i, &angle, &weight, gauss.get());
      const Mat3<double> turned = so3::exp<double>(angle * axis) * R;
      work += weight * axis.dot(applied_moment<double>({type, 2, 0}, 1, turned).m);
    }
    R = so3::exp<double>(kAngles[leg] * axis) * R;
  }
  return work;
}

template AppliedMoment<double> applied_moment(const MomentLoad<double>&, const double&, const Mat3<double>&);
template AppliedMoment<Real50> applied_moment(const MomentLoad<Real50>&, const Real50&, const Mat3<Real50>&);
template AppliedMoment<Dual<Real50>> applied_moment(const MomentLoad<Dual<Real50>>&, const Dual<Real50>&,
                                                    const Mat3<Dual<Real50>>&);
template std::optional<double> moment_potential(const MomentLoad<double>&, const double&,
                                                const Mat3<double>&);
template std::optional<Real50> moment_potential(const MomentLoad<Real50>&, const Real50&,
                                                const Mat3<Real50>&);
template std::optional<Dual<Real50>> moment_potential(const MomentLoad<Dual<Real50>>&, const Dual<Real50>&,
                                                      const Mat3<Dual<Real50>>&);

}  // namespace halfway::reference
