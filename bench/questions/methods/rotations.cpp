// exp and log of rotations: ours, Eigen's, and those of the libraries that CMake finds.
#include "bench/harness/case.hpp"
#include "bench/harness/inputs.hpp"
#include "bench/questions/methods/problem.hpp"
#include "reference/numbers/precision.hpp"
#include "reference/numbers/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#ifdef HALFWAY_SOPHUS
#include <sophus/so3.hpp>
#endif
#ifdef HALFWAY_MANIF
#include <manif/SO3.h>
#endif
#ifdef HALFWAY_PINOCCHIO
#include <pinocchio/spatial/explog.hpp>
#endif

namespace halfway::bench {

Cases rotation_cases();

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using reference::Real50;

// A library: name, exp, log, and the limits of their errors at the timed rotations.

struct Ours {
  static constexpr const char* name = "so3";
  static constexpr const char* implementation = "reference";
  static constexpr double limit_of_exp = 4 * kEps, limit_of_log = 4 * kEps;  // the contract of so3.hpp
  static Matrix3d exp(const Vector3d& theta) { return so3::exp<double>(theta); }
  static Vector3d log(const Matrix3d& R) { return so3::log<double>(R); }
};

/// Published: log to 5e-16. exp multiplies 1 - cos phi by rounded products: 4 eps.
struct EigenAngleAxis {
  static constexpr const char* name = "eigen_angle_axis";
  static constexpr const char* implementation = "competitor";
  static constexpr double limit_of_exp = 4 * kEps, limit_of_log = 4 * kEps;
  static Matrix3d exp(const Vector3d& theta) {
    const double phi = theta.norm();
    return phi > 0 ? Eigen::AngleAxisd(phi, theta / phi).toRotationMatrix() : Matrix3d::Identity();
  }
  static Vector3d log(const Matrix3d& R) {
    const Eigen::AngleAxisd turn(R);
    return turn.angle() * turn.axis();
  }
};

// The others' exp and log are known to be right to 1e-8 or better everywhere; their measured error is shown.
[[maybe_unused]] constexpr double kLimitOfOthers = 1e-8;

#ifdef HALFWAY_SOPHUS
struct SophusSo3 {
  static constexpr const char* name = "sophus";
  static constexpr const char* implementation = "competitor";
  static constexpr double limit_of_exp = kLimitOfOthers, limit_of_log = kLimitOfOthers;
  static Matrix3d exp(const Vector3d& theta) { return Sophus::SO3d::exp(theta).matrix(); }
  static Vector3d log(const Matrix3d& R) { return Sophus::SO3d(Eigen::Quaterniond(R)).log(); }
};
#endif
#ifdef HALFWAY_MANIF
struct ManifSo3 {
  static constexpr const char* name = "manif";
  static constexpr const char* implementation = "competitor";
  static constexpr double limit_of_exp = kLimitOfOthers, limit_of_log = kLimitOfOthers;
  static Matrix3d exp(const Vector3d& theta) { return manif::SO3Tangentd(theta).exp().rotation(); }
  static Vector3d log(const Matrix3d& R) {
    return manif::SO3d(Eigen::Quaterniond(R).normalized()).log().coeffs();
  }
};
#endif
#ifdef HALFWAY_PINOCCHIO
struct PinocchioSo3 {
  static constexpr const char* name = "pinocchio";
  static constexpr const char* implementation = "competitor";
  static constexpr double limit_of_exp = kLimitOfOthers, limit_of_log = kLimitOfOthers;
  static Matrix3d exp(const Vector3d& theta) { return pinocchio::exp3(theta); }
  static Vector3d log(const Matrix3d& R) { return pinocchio::log3(R); }
};
#endif

/// Rotation vectors and the matrices of them.
struct Rotations {
  std::vector<Vector3d> theta;
  std::vector<Matrix3d> R;
};

/// phi log-uniform in [low, high), or pi - phi where high is near pi.
Rotations rotations(const ErrorAt& range, int count) {
  reference::Generator g(1775);
  const bool near_pi = range.from > 3;
  const double low = near_pi ? std::numbers::pi - range.from : range.from;
  const double high = near_pi ? std::numbers::pi - range.to : range.to;
  Rotations out;
  for (int i = 0; i < count; ++i) {
    const double x = low * std::pow(high / low, g.uniform(0, 1));
    out.theta.push_back((near_pi ? std::numbers::pi - x : x) * g.direction());
    out.R.push_back(so3::exp<double>(out.theta.back()));
  }
  return out;
}

/// exp: absolute error of an entry. log: of an entry, relative to the largest one.
template <class Library, bool is_log>
double worst_error(const Rotations& in) {
  reference::Measurement worst;
  for (std::size_t i = 0; i < in.R.size(); ++i) {
    if (is_log) {
      const Vec3<Real50> exact = so3::log<Real50>(in.R[i].cast<Real50>());
      worst.include(largest_difference(Vector3d(Library::log(in.R[i])), exact) / largest_entry(exact), {});
    } else {
      const Mat3<Real50> exact = so3::exp<Real50>(in.theta[i].cast<Real50>());
      worst.include(largest_difference(Matrix3d(Library::exp(in.theta[i])), exact), {});
    }
  }
  return worst.value();
}

template <class Library, bool is_log>
Checked check_rotation(const Rotations& timed) {
  constexpr double limit = is_log ? Library::limit_of_log : Library::limit_of_exp;
  Checked out;
  out.error = worst_error<Library, is_log>(timed);
  if (!(out.error <= limit)) out.message = fmt::format("error {:.2e}, limit {:.2e}", out.error, limit);
  for (ErrorAt range : phi_ranges()) {
    range.error = worst_error<Library, is_log>(rotations(range, 64));
    out.errors.push_back(range);
  }
  return out;
}

template <class Library, bool is_log>
Case rotation_case(const std::shared_ptr<const Rotations>& in) {
  Case c;
  c.what = is_log ? "log" : "exp";
  c.implementation = Library::implementation;
  c.variant = Library::name;
  c.name = "rotation/" + c.what + '/' + Library::name;
  c.evaluations = kPoses;
  c.check = [in] { return check_rotation<Library, is_log>(*in); };
  c.timed = [in](benchmark::State& state) {
    for (auto _ : state) {
      for (int i = 0; i < kPoses; ++i) {
        if constexpr (is_log) {
          Vector3d result = Library::log(in->R[i]);
          benchmark::DoNotOptimize(result);
        } else {
          Matrix3d result = Library::exp(in->theta[i]);
          benchmark::DoNotOptimize(result);
        }
      }
    }
  };
  return c;
}

template <class Library>
void add_cases(Cases& cases, const std::shared_ptr<const Rotations>& in) {
  cases.push_back(rotation_case<Library, false>(in));
  cases.push_back(rotation_case<Library, true>(in));
}

}  // namespace

Cases rotation_cases() {
  const auto in = std::make_shared<const Rotations>(rotations({1e-3, 3}, kPoses));
  Cases cases;
  add_cases<Ours>(cases, in);
  add_cases<EigenAngleAxis>(cases, in);
#ifdef HALFWAY_SOPHUS
  add_cases<SophusSo3>(cases, in);
#endif
#ifdef HALFWAY_MANIF
  add_cases<ManifSo3>(cases, in);
#endif
#ifdef HALFWAY_PINOCCHIO
  add_cases<PinocchioSo3>(cases, in);
#endif
  return cases;
}

}  // namespace halfway::bench
