// Least squares by GSL's trust region: unknowns, their covariance, the noise of each channel.
#pragma once

#include "reference/identify/response.hpp"

namespace halfway::reference::identify {

/// What is fitted: the unknowns that are free, and those that follow another one (one xi for three).
struct Freedom {
  std::vector<int> active{};
  std::array<int, kPlaces> source{};  ///< place -> the place whose value it takes
};

struct Fit {
  Unknowns p = no_unknowns();
  Freedom freedom{};
  Eigen::MatrixXd
      covariance{};            ///< of freedom.active, by the residual's variance and the weights' own scatter
  Eigen::VectorXd residual{};  ///< measured - answered, SI
  Eigen::VectorXd weighted{};  ///< over the standard deviation of the channel
  std::array<double, kChannels> sigma{};  ///< of each channel: found, or as the data say
  Eigen::VectorXd own_degrees{};  ///< of freedom behind the deviation of each active unknown (Satterthwaite)
  int degrees = 0;                ///< of freedom left: numbers less unknowns
  double variance = 0;            ///< of the weighted residual, near 1 where sigma was found
  bool converged = false;
  std::string reason{};  ///< why not

  double sum_of_squares() const { return weighted.squaredNorm(); }
  /// Half the interval of that confidence round an unknown, by Student's t; NaN of one that is not active.
  double half_width(int place, double confidence = 0.95) const;
  double deviation(int place) const;
  bool is_active(int place) const;
};

/// Applies the sources.
Unknowns tied(const Unknowns& p, const Freedom& freedom);

/// @param sigma  of the channels, to weigh by; those that are 0 are found from the residual, in turn with the
/// fit
Fit fit(const Data& data, const MakeModel& make, const Unknowns& start, const Freedom& freedom,
        const std::array<double, kChannels>& sigma);

/// Weighted derivatives of all answers by the active unknowns.
Eigen::MatrixXd weighted_jacobian(const Data& data, const MakeModel& make, const Unknowns& p,
                                  const Freedom& freedom, const std::array<double, kChannels>& sigma);

/// Standard deviations to begin with: a thousandth of the size of each channel.
std::array<double, kChannels> first_sigma(const Data& data);

/// P(F > f) of Fisher's distribution, and the quantile of Student's.
double fisher_tail(double f, double more, double degrees);
double student_quantile(double confidence, double degrees);

}  // namespace halfway::reference::identify
