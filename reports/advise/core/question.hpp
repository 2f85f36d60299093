// What is asked: a scene, how exact, and what the joint will be put to.
#pragma once

#include "reports/advise/truth/truth.hpp"

#include <optional>

namespace halfway::advise {

struct Question {
  reference::Scene scene;
  double tolerance = 1e-2;     ///< relative
  std::string truth = "auto";  ///< as of truth_of
  std::optional<double>
      degrees{};  ///< the envelope ends where the truth has turned so far; else at the scene's load
  std::optional<Measure> measure{};  ///< else the truth's own
  bool is_moving = false;  ///< does node a turn as well? Then the linear analysis of the scene says nothing
  double periods = 0;      ///< of the motion that the joint is used in: energy that a law makes adds up
};

/// Load factors from rest on: so many are the envelope, the rest lies beyond it, for margins.
struct Envelope {
  std::vector<double> factors;
  std::size_t rows = 0;
  bool is_cut = false;  ///< the truth's data end before what was asked for

  double end() const { return factors[rows - 1]; }
};

/// The truth at these factors; without one the half-way law, by which loads and rotations of an envelope go
/// together.
Answers leading(const Truth& truth, const std::vector<double>& factors);

/// Throws BadInput where the degrees asked for are not reached.
Envelope envelope_of(const Question& question, const Truth& truth);

}  // namespace halfway::advise
