// What can be advised: a formulation, the kind of joint, how its angle is taken and in which precision.
#pragma once

#include "reference/solve/solve.hpp"
#include "reports/advise/model/answers.hpp"

#include <optional>
#include <string>
#include <vector>

namespace halfway::advise {

struct Candidate {
  const reference::Entry* entry = nullptr;  ///< nullptr: the linear analysis
  double xi = 0.5;
  bool fitted = false;  ///< is that xi the one that comes nearest to the truth?
  Kind kind = Kind::angular;
  std::string precision = "double";  ///< or float
  std::string variant{};  ///< of the kernel's angle, as benchmarks call it: order_1 ... log_18; empty: as
                          ///< exact as the precision
  bool ends = true;       ///< joint points and frames away from the nodes are provided for

  std::string formulation() const;
  /// "invariant order_2", "intrinsic xi = 0.55", "fasse in float", "linearized", with the kind where it is
  /// not `of_scene`.
  std::string name(Kind of_scene) const;
  /// Of the benchmark that times loads and tangent of its kernel.
  std::string timing() const;
};

/// All that could serve a scene: formulations that take its law; where the law is linear each by its kernel
/// in double, cheaper angles and float where those are timed; a lower kind where the law has no coupling; the
/// linear analysis.
std::vector<Candidate> candidates_of(const reference::Scene& scene);

/// The scene with one kind less, whose `u` or `theta` then is zero; nothing where that says no more what the
/// scene says: a coupled law or one that is not linear, an arm, or no load of that kind.
std::optional<reference::Scene> as_kind(const reference::Scene& scene, Kind kind);

/// Its path through the scene at these factors, ascending.
/// @param exchanged  with the clamped node listed as b, the frame xi seen from there
Answers follow(const reference::Scene& scene, const Candidate& candidate, const std::vector<double>& factors,
               bool exchanged = false);

}  // namespace halfway::advise
