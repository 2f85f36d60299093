// What a model answers along an envelope of loads, and how far that is from the truth.
#pragma once

#include "halfway/joint/pose.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::advise {

/// Outputs (rad, m) at ascending load factors. A path that ends early has fewer rows than were asked for.
struct Answers {
  std::vector<std::string> outputs;        ///< theta_x ... u_z
  std::vector<double> factor;              ///< of each row, > 0
  std::vector<std::vector<double>> value;  ///< of each row, in the order of `outputs`
  std::vector<Pose<double>> node{};  ///< the loaded node, where the model has one; node a is the identity
  double error = 0;                  ///< that they carry, rad or m, the worst
  std::string ended{};               ///< why it does not reach what was asked for; empty: it does
};

/// Of what an error is relative.
enum class Measure {
  norm,  ///< |difference| over |truth|, rotations and displacements each for themselves
  each   ///< each output over itself
};
const char* to_string(Measure measure);

/// The error at each row of `truth`: the worst over rotations and displacements. Infinity from where the
/// model ends. An output that the truth has not (below 1e-9 of the largest of its unit) is taken over that
/// largest one, a unit that it has not at all over 1 rad or 1 m. Rows of both are at the same factors.
std::vector<double> errors_of(const Answers& model, const Answers& truth, Measure measure);

/// The worst of the first `rows`; NaN of none.
double worst_of(const std::vector<double>& errors, std::size_t rows);

/// Up to where errors stay within a tolerance, straight in between the rows, from rest on.
struct Reach {
  double factor = 0;
  double rotation = 0;  ///< of the truth there, rad
  bool to_the_end = false;
};
Reach reach_of(const std::vector<double>& errors, const Answers& truth, double tolerance);

/// |theta| of a row, rad; nothing where not all three components are outputs.
std::optional<double> rotation_at(const Answers& answers, std::size_t row);

}  // namespace halfway::advise
