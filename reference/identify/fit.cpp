#include "reference/identify/fit.hpp"

#include "reference/identify/scatter.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace halfway::reference::identify {
namespace {

constexpr int kMostIterations = 60;
constexpr double kNear =
    1e-4;  // of an unknown's standard deviation: further steps change no digit that is shown
constexpr int kMostRounds = 8;       // of weights and fit in turn
constexpr double kSteady = 0.005;    // a sigma that changes by less is found
constexpr double kLost = 1e3;        // standard deviations that a row without equilibrium is taken to be off
constexpr double kRounding = 1e-12;  // of a channel's size: nothing is measured closer

/// What GSL hands back to us.
struct Problem {
  const Data& data;
  const MakeModel& make;
  const Freedom& freedom;
  Unknowns at;
  Eigen::VectorXd measured, weight;
  std::vector<Vec6> warm{};

  Unknowns unknowns(const gsl_vector* x) const {
    Unknowns p = at;
    for (std::size_t i = 0; i < freedom.active.size(); ++i) p[freedom.active[i]] = gsl_vector_get(x, i);
    return p;
  }
};

/// Derivatives by an unknown that others follow count for all of them.
MakeModel with_sources(const MakeModel& make, const Freedom& freedom) {
  return [&make, &freedom](const Unknowns& p) { return make(tied(p, freedom)); };
}

int residual(const gsl_vector* x, void* data, gsl_vector* f) {
  auto& problem = *static_cast<Problem*>(data);
  const Response r = respond(problem.data, with_sources(problem.make, problem.freedom), problem.unknowns(x),
                             {}, false, problem.warm);
  for (Eigen::Index i = 0; i < r.values.size(); ++i) {
    const double off = (r.values[i] - problem.measured[i]) * problem.weight[i];
    gsl_vector_set(f, std::size_t(i), std::isfinite(off) ? off : kLost);
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* x, void* data, gsl_matrix* J) {
  auto& problem = *static_cast<Problem*>(data);
  const Response r = respond(problem.data, with_sources(problem.make, problem.freedom), problem.unknowns(x),
                             problem.freedom.active, true, problem.warm);
  for (Eigen::Index i = 0; i < r.by_unknown.rows(); ++i) {
    for (Eigen::Index j = 0; j < r.by_unknown.cols(); ++j) {
      const double by = r.by_unknown(i, j) * problem.weight[i];
      gsl_matrix_set(J, std::size_t(i), std::size_t(j), std::isfinite(by) ? by : 0);
    }
  }
  problem.warm = r.motions;
  return GSL_SUCCESS;
}

Eigen::VectorXd weights(const std::vector<int>& channel, const std::array<double, kChannels>& sigma) {
  Eigen::VectorXd out(channel.size());
  for (std::size_t i = 0; i < channel.size(); ++i) out[Eigen::Index(i)] = 1 / sigma[std::size_t(channel[i])];
  return out;
}

/// How far the unknowns are from the minimum, over their standard deviations: the part of the residual that
/// they could still take away (Bates and Watts 1981).
double offset(const gsl_multifit_nlinear_workspace* workspace) {
  using Matrix = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>, 0,
                            Eigen::OuterStride<>>;
  const gsl_matrix* jac = gsl_multifit_nlinear_jac(workspace);
  const gsl_vector* f = gsl_multifit_nlinear_residual(workspace);
  const Matrix J(jac->data, Eigen::Index(jac->size1), Eigen::Index(jac->size2),
                 Eigen::OuterStride<>(Eigen::Index(jac->tda)));
  const Eigen::Map<const Eigen::VectorXd> r(f->data, Eigen::Index(f->size));
  const Eigen::VectorXd gradient = J.transpose() * r;
  const double taken = gradient.dot((J.transpose() * J).ldlt().solve(gradient));
  const double left = (r.squaredNorm() - taken) / std::max(1., double(r.size() - J.cols()));
  return std::sqrt(taken / double(J.cols()) / left);
}

/// One fit with weights as they are. Sets p, converged and reason.
void minimise(Problem& problem, Fit& out) {
  const std::size_t n = std::size_t(problem.measured.size()), unknowns = problem.freedom.active.size();
  if (unknowns == 0) {
    out.converged = true;
    return;
  }
  gsl_set_error_handler_off();
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  parameters.trs = gsl_multifit_nlinear_trs_lm;
  parameters.scale = gsl_multifit_nlinear_scale_more;
  using Workspace =
      std::unique_ptr<gsl_multifit_nlinear_workspace, void (*)(gsl_multifit_nlinear_workspace*)>;
  const Workspace workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, unknowns),
                            gsl_multifit_nlinear_free);
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = &residual, fdf.df = &jacobian, fdf.n = n, fdf.p = unknowns, fdf.params = &problem;
  Eigen::VectorXd x(unknowns);
  for (std::size_t i = 0; i < unknowns; ++i) x[Eigen::Index(i)] = problem.at[problem.freedom.active[i]];
  const gsl_vector_const_view start = gsl_vector_const_view_array(x.data(), unknowns);
  out.converged = false;
  gsl_multifit_nlinear_init(&start.vector, &fdf, workspace.get());
  int status = GSL_SUCCESS;
  for (int iteration = 0; iteration < kMostIterations && status == GSL_SUCCESS && !out.converged;
       ++iteration) {
    status = gsl_multifit_nlinear_iterate(workspace.get());
    out.converged = offset(workspace.get()) < kNear;
  }
  problem.at = out.p = problem.unknowns(gsl_multifit_nlinear_position(workspace.get()));
  if (!out.converged && status == GSL_SUCCESS) {
    // Of data without noise the residual is rounding, and steps stir it.
    int info = 0;
    out.converged = gsl_multifit_nlinear_test(1e-8, 1e-8, 0, &info, workspace.get()) == GSL_SUCCESS;
  }
  out.converged =
      out.converged || status == GSL_ENOPROG;  // no further step helps: as near as rounding lets it come
  if (!out.converged)
    out.reason = status == GSL_SUCCESS ? "no minimum within the iterations" : gsl_strerror(status);
}

}  // namespace

Unknowns tied(const Unknowns& p, const Freedom& freedom) {
  Unknowns out;
  for (int i = 0; i < kPlaces; ++i) out[i] = p[freedom.source[std::size_t(i)]];
  return out;
}

bool Fit::is_active(int place) const {
  return std::find(freedom.active.begin(), freedom.active.end(), freedom.source[std::size_t(place)]) !=
         freedom.active.end();
}

double Fit::deviation(int place) const {
  const auto at = std::find(freedom.active.begin(), freedom.active.end(), freedom.source[std::size_t(place)]);
  if (at == freedom.active.end()) return std::nan("");
  const Eigen::Index i = at - freedom.active.begin();
  return std::sqrt(covariance(i, i));
}

double Fit::half_width(int place, double confidence) const {
  const auto at = std::find(freedom.active.begin(), freedom.active.end(), freedom.source[std::size_t(place)]);
  if (at == freedom.active.end()) return std::nan("");
  return student_quantile(confidence, own_degrees[at - freedom.active.begin()]) * deviation(place);
}

double student_quantile(double confidence, double degrees) {
  return gsl_cdf_tdist_Pinv(0.5 + confidence / 2, degrees);
}
double fisher_tail(double f, double more, double degrees) { return gsl_cdf_fdist_Q(f, more, degrees); }

std::array<double, kChannels> first_sigma(const Data& data) {
  std::array<double, kChannels> out = sizes(data);
  for (std::size_t c = 0; c < kChannels; ++c) {
    out[c] = out[c] > 0 ? 1e-3 * out[c] : 1;
    if (data.sigma[c] > 0) out[c] = data.sigma[c];
  }
  return out;
}

Eigen::MatrixXd weighted_jacobian(const Data& data, const MakeModel& make, const Unknowns& p,
                                  const Freedom& freedom, const std::array<double, kChannels>& sigma) {
  Eigen::MatrixXd J = respond(data, with_sources(make, freedom), p, freedom.active, true, {}).by_unknown;
  J = (weights(channels(data), sigma).asDiagonal() * J).eval();
  return J.unaryExpr([](double x) { return std::isfinite(x) ? x : 0; });
}

Fit fit(const Data& data, const MakeModel& make, const Unknowns& start, const Freedom& freedom,
        const std::array<double, kChannels>& sigma) {
  const std::vector<int> channel = channels(data);
  const auto size = sizes(data), first = first_sigma(data);
  // Weights that an earlier fit found scatter as well: what the data say alone does not.
  std::array<bool, kChannels> is_found{};
  for (std::size_t c = 0; c < kChannels; ++c) is_found[c] = !(data.sigma[c] > 0);
  Fit out;
  out.freedom = freedom;
  for (std::size_t c = 0; c < kChannels; ++c) out.sigma[c] = sigma[c] > 0 ? sigma[c] : first[c];
  Problem problem{data, make, freedom, start, measured(data), {}};
  out.p = start;
  out.degrees = int(channel.size()) - int(freedom.active.size());
  for (int round = 0; round < kMostRounds; ++round) {
    problem.weight = weights(channel, out.sigma);
    minimise(problem, out);
    const Response r = respond(data, with_sources(make, freedom), out.p, freedom.active, true, problem.warm);
    out.residual = problem.measured - r.values;
    for (double& off : out.residual) {
      if (!std::isfinite(off))
        off = std::numeric_limits<double>::infinity(), out.converged = false,
        out.reason = "no equilibrium at a row of the data";
    }
    const Eigen::MatrixXd J = (problem.weight.asDiagonal() * r.by_unknown).unaryExpr([](double x) {
      return std::isfinite(x) ? x : 0;
    });
    const Scatter scatter = scatter_of(J, channel, is_found);
    const Eigen::VectorXd inflation = scatter.inflation.cwiseSqrt();
    out.covariance = inflation.asDiagonal() * scatter.covariance * inflation.asDiagonal();
    out.weighted = out.residual.cwiseProduct(problem.weight);
    out.own_degrees = Eigen::VectorXd::Constant(J.cols(), std::max(1, out.degrees));
    if (!out.converged) break;
    std::array<double, kChannels> sum{}, count{}, next = out.sigma;
    for (std::size_t i = 0; i < channel.size(); ++i) {
      sum[std::size_t(channel[i])] += out.residual[Eigen::Index(i)] * out.residual[Eigen::Index(i)];
      count[std::size_t(channel[i])] += 1;
    }
    const auto& left = scatter.left;
    out.own_degrees = scatter.degrees;
    bool is_steady = true;
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (sigma[c] > 0 || count[c] == 0) continue;
      if (left[c] < 0.5) continue;  // it has no say in its own noise
      next[c] = std::max(std::sqrt(sum[c] / left[c]), kRounding * size[c]);
      is_steady = is_steady && std::abs(next[c] / out.sigma[c] - 1) < kSteady;
    }
    if (is_steady) break;
    out.sigma = next;
  }
  out.variance = out.degrees > 0 ? out.weighted.squaredNorm() / out.degrees : std::nan("");
  for (std::size_t c = 0; c < kChannels; ++c) {  // data without noise leave rounding, or nothing
    const double least = kRounding * size[c] / out.sigma[c];
    if (size[c] > 0 && out.variance < least * least) out.variance = least * least;
  }
  out.covariance *= out.variance;
  return out;
}

}  // namespace halfway::reference::identify
