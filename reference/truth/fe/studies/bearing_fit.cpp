#include "reference/truth/fe/studies/bearing_fit.hpp"

#include "reference/truth/decoupling.hpp"
#include "reference/truth/fe/statics.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace halfway::reference::fe {
namespace {

constexpr double kStep = 1e-5;  ///< of forward differences: far above the rounding of a solution, far below 1
constexpr double kTolerance = 1e-6;  ///< on parameters and gradient: far below what a mesh is good for
constexpr int kMostIterations = 40;

/// Part of the interval (0, 1) <-> all numbers.
double logit(double part) { return std::log(part / (1 - part)); }
double part(double logit) { return 1 / (1 + std::exp(-logit)); }

/// Free of bounds: logarithms of inner radius and thickness, the rim's angle on the inner bowl as a part of
/// what lies between hole and pi, and the hole's there as a part of pi / 2.
using Parameters = std::vector<double>;

Parameters parameters(const Bearing& b, bool width) {
  const double edge = b.hole_edge(b.inner);
  Parameters p = {std::log(b.inner), std::log(b.outer - b.inner),
                  logit((b.rim(b.inner) - edge) / (std::numbers::pi - edge))};
  if (width) p.push_back(logit(edge / (std::numbers::pi / 2)));
  return p;
}

Bearing bearing(const Parameters& p, const Bearing& like) {
  Bearing b = like;
  b.inner = std::exp(p[0]);
  b.outer = b.inner + std::exp(p[1]);
  if (p.size() > 3) {
    const double edge = std::numbers::pi / 2 * part(p[3]);
    b.width = b.hole == Hole::cone ? edge : b.inner * std::sin(edge);
  }
  const double edge = b.hole_edge(b.inner);
  const double rim = edge + (std::numbers::pi - edge) * part(p[2]);
  b.extent = b.cut == Cut::cone ? rim : b.outer - b.inner * std::cos(rim);
  return b;
}

BearingData relative(const BearingData& data) {
  BearingData r;
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = data[i] / kTable4[i] - 1;
  return r;
}

struct Problem {
  const Bearing& like;
  const FitPlan& plan;
  std::size_t residuals() const { return plan.joint_point ? kTable4.size() : kTable4.size() - 1; }
};

BearingAnswer answer(const Bearing& b, const FitPlan& plan) {
  return bearing_data(b, plan.element, bearing_divisions(b, plan.level), plan.grading);
}

Parameters read(const gsl_vector* x) {
  Parameters p(x->size);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = gsl_vector_get(x, i);
  return p;
}

int residuals(const gsl_vector* x, void* problem, gsl_vector* f) try {
  const auto& at = *static_cast<const Problem*>(problem);
  const BearingData r = relative(answer(bearing(read(x), at.like), at.plan).data);
  for (std::size_t i = 0; i < at.residuals(); ++i) gsl_vector_set(f, i, r[i]);
  return GSL_SUCCESS;
} catch (const std::invalid_argument&) {
  return GSL_EDOM;
} catch (const std::exception&) {
  return GSL_EFAILED;  // no exception may pass through GSL
}

void judge(const Problem& problem, BearingFit& fit) {
  const BearingAnswer last = answer(fit.bearing, problem.plan);
  fit.data = last.data;
  fit.residual = relative(last.data);
  fit.unknowns = last.unknowns;
  const Eigen::Map<const Eigen::VectorXd> fitted(fit.residual.data(), Eigen::Index(problem.residuals()));
  fit.rms = fitted.norm() / std::sqrt(double(fitted.size()));
  fit.largest = fitted.lpNorm<Eigen::Infinity>();
}

}  // namespace

BearingAnswer bearing_data(const Bearing& bearing, ElementKind element, const BearingDivisions& divisions,
                           double grading) {
  // The centre as reference point: any will do, the joint point follows from the decoupling.
  const Solid solid(bearing_mesh(element, bearing, divisions, grading), kBearingMaterial,
                    Vec3<double>::Zero());
  Statics statics(solid);
  const auto d = decouple<double>(statics.linear().compliance);
  BearingAnswer answer;
  answer.data = {d.F_u(1, 1), (d.F_u(0, 0) + d.F_u(2, 2)) / 2, (d.F_psi(0, 0) + d.F_psi(2, 2)) / 2,
                 d.F_psi(1, 1), bearing.outer + d.x[1]};
  answer.unknowns = solid.unknowns();
  return answer;
}

BearingFit fit_bearing(const Bearing& start, const FitPlan& plan) {
  start.check();
  gsl_set_error_handler_off();
  if (plan.width && start.hole == Hole::none)
    throw std::invalid_argument(
        "bearing fit: hole is none; allowed: cone, cylinder when its width is to be fitted");
  Problem problem{start, plan};
  const Parameters p = parameters(start, plan.width);
  gsl_multifit_nlinear_fdf system{};
  system.f = &residuals;
  system.n = problem.residuals();
  system.p = p.size();
  system.params = &problem;

  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.h_df = kStep;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, system.n, system.p),
      &gsl_multifit_nlinear_free);
  const gsl_vector_const_view view = gsl_vector_const_view_array(p.data(), p.size());
  int why = 0;
  int status = gsl_multifit_nlinear_init(&view.vector, &system, work.get());
  if (status == GSL_SUCCESS)
    status = gsl_multifit_nlinear_driver(kMostIterations, kTolerance, kTolerance, 0, nullptr, nullptr, &why,
                                         work.get());
  BearingFit fit{};
  fit.bearing = bearing(read(gsl_multifit_nlinear_position(work.get())), start);
  fit.iterations = int(gsl_multifit_nlinear_niter(work.get()));
  fit.converged = status == GSL_SUCCESS;
  fit.message = gsl_strerror(status);
  judge(problem, fit);
  return fit;
}

std::vector<BearingFit> scan_holes(const Bearing& start, const std::vector<double>& widths,
                                   const FitPlan& plan) {
  std::vector<BearingFit> fits;
  Bearing from = start;
  for (const double width : widths) {
    from.width = width;
    fits.push_back(fit_bearing(from, plan));
    if (!fits.back().converged) break;
    from = fits.back().bearing;
  }
  return fits;
}

}  // namespace halfway::reference::fe
