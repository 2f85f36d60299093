#include "reference/solve/stability/kind_motion.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>

namespace halfway::reference {
namespace {

constexpr double kTolerance = 1e-13, kDisturbance = 1e-6;

using Quaternion = so3::Quaternion<double>;

Quaternion times(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.w - p.v.dot(q.v), p.w * q.v + q.w * p.v + p.v.cross(q.v)};
}

Quaternion normalised(const double* y) {
  const double norm = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
  return {y[0] / norm, Vec3<double>(y[1], y[2], y[3]) / norm};
}

struct Motion {
  const MotionRequest& request;
  MomentLoad<double> load;
  double magnitude;
};

/// y = (quaternion of the body's principal axes seen from the clamped joint frame, angular velocity in them).
int rate(double, const double* y, double* dy, void* data) {
  const Motion& motion = *static_cast<const Motion*>(data);
  const MotionRequest& request = motion.request;
  const Quaternion q = normalised(y);
  const Vec3<double> w(y[4], y[5], y[6]);
  const Mat3<double> R = so3::matrix(q), R_ab = R * request.body.axes.transpose() * request.spec.b.H;
  const Vec3<double> inside = turned_joint<double>(*request.entry, request.spec, R_ab).m;
  const Vec3<double> moment = applied_moment(motion.load, motion.magnitude, R_ab).m - inside;
  const Vec3<double> spin = request.body.principal.cwiseProduct(w);
  const Vec3<double> turn = (R.transpose() * moment - w.cross(spin)).cwiseQuotient(request.body.principal);
  const Quaternion dq = times(q, {0, w / 2});
  dy[0] = dq.w;
  for (int i = 0; i < 3; ++i) {
    dy[1 + i] = dq.v[i];
    dy[4 + i] = turn[i];
  }
  return turn.allFinite() ? GSL_SUCCESS : GSL_EBADFUNC;
}

}  // namespace

DeviationHistory disturbed_motion(const MotionRequest& request, double duration, int points) {
  gsl_set_error_handler_off();
  const auto point =
      loaded_state<double>(*request.entry, request.spec, request.axis, request.setting, request.angle);
  Motion motion{request,
                {request.setting.type, request.axis, request.setting.square_unstrained ? 0 : request.angle},
                point.load};
  const Mat3<double> axes = point.R * request.body.axes;
  const Vec3<double> off = kDisturbance * Vec3<double>(0.48, 0.6, 0.64);
  const Quaternion start = so3::quaternion<double>(so3::exp<double>(off) * axes);
  double y[7] = {start.w, start.v[0], start.v[1], start.v[2], 0, 0, 0}, t = 0;
  gsl_odeiv2_system system{&rate, nullptr, 7, &motion};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, kTolerance, kTolerance),
      &gsl_odeiv2_driver_free);
  DeviationHistory out;
  out.interval = duration / points;
  for (int i = 1; i <= points; ++i) {
    if (gsl_odeiv2_driver_apply(driver.get(), &t, i * out.interval, y) != GSL_SUCCESS) return out;
    out.theta.push_back(so3::log<double>(so3::matrix(normalised(y)) * axes.transpose()));
  }
  out.finished = true;
  return out;
}

std::optional<std::complex<double>> dominating_mode(const DeviationHistory& history, int points) {
  // Normal equations of y(n+2) = p y(n+1) + q y(n).
  double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
  const auto& theta = history.theta;
  for (std::size_t n = theta.size() - std::size_t(points); n + 2 < theta.size(); ++n) {
    a11 += theta[n + 1].squaredNorm();
    a12 += theta[n + 1].dot(theta[n]);
    a22 += theta[n].squaredNorm();
    b1 += theta[n + 1].dot(theta[n + 2]);
    b2 += theta[n].dot(theta[n + 2]);
  }
  const double det = a11 * a22 - a12 * a12;
  const double p = (b1 * a22 - b2 * a12) / det, q = (b2 * a11 - b1 * a12) / det;
  const double under_root = -q - p * p / 4;
  if (!(under_root > 0)) return std::nullopt;
  return std::log(std::complex<double>(p / 2, std::sqrt(under_root))) / history.interval;
}

}  // namespace halfway::reference
