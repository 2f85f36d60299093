// The whole: which second order the data show, with intervals, which formulation fits best and what the
// conservative one costs.
#pragma once

#include "reference/identify/identifiable.hpp"

namespace halfway::reference::identify {

/// What a joint may have at second order, beside its stiffness.
enum class Stage {
  half_way,  ///< xi = 1/2
  one_xi,    ///< one number for all pairs of axes
  two_xi,    ///< one for moments, one for forces; of linear_angular joints
  cubic,     ///< conservative: half-way, an energy c theta_1 theta_2 theta_3, and xi of each pair of forces
  per_pair,  ///< a number for each pair of axes, of moments and of forces
  axis_laws  ///< the simplest of these that noise can explain, and k3 along each axis instead of coupling
};
const char* to_string(Stage stage);

struct StageFit {
  Stage stage;
  Fit fit;
  std::vector<Dropped> left_open{};
  double probability = 1;  ///< that noise alone makes it this much worse than the one that fits closest
};

/// One formulation of the catalog with the stiffness that suits it best.
struct CatalogFit {
  std::string name{};
  Fit fit{};
  bool is_conservative = false;
  double error = 0;        ///< root mean square of the weighted residual, standard deviations of the noise
  double probability = 1;  ///< that noise alone makes it this much worse than the best stage
  std::string left_out{};  ///< why it was not fitted; empty: it was
};

struct Identification {
  Frame frame;                            ///< of all unknowns below
  std::array<double, kChannels> sigma{};  ///< scatter of each channel, of the stage that fits closest
  std::vector<StageFit> stages{};         ///< in the order of Stage
  std::size_t closest = 0;                ///< of the stages, by variance
  std::size_t chosen = 0;                 ///< the simplest stage that noise can explain
  std::vector<LeftOpen> left_open{};      ///< of per_pair, which asks most
  std::vector<CatalogFit> catalog{};      ///< best first, those left out last
  int best = -1, best_conservative = -1;  ///< in catalog; -1: none

  const StageFit& stage(Stage which) const;
  const StageFit& chosen_stage() const { return stages[chosen]; }
  JointValues values(const Fit& fit) const { return values_of(frame, tied(fit.p, fit.freedom)); }
};

/// What identify() cannot do with data: too few numbers, nothing loaded.
struct NotIdentifiable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How likely a difference is that is taken for noise, at least.
inline constexpr double kRejected = 0.01;

/// Of a fit as much worse as this one than the closest, by noise alone: Fisher's test, both weighted alike.
double probability_of(const Fit& one, const Fit& closest);

/// @param with_catalog  also fit the formulations of the catalog
Identification identify(const Data& data, bool with_catalog = true);

/// The unknowns of a stage, and what `make` makes of them.
Freedom freedom_of(Stage stage, Kind kind);

}  // namespace halfway::reference::identify
