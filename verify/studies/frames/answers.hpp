// What a scene answers, in axes that do not depend on how it was written.
#pragma once

#include "reference/solve/paths/continuation.hpp"
#include "reference/solve/stability/critical.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/frames/rewriting.hpp"

#include <string>
#include <vector>

namespace halfway::verify {

/// A formulation and its xi, where it has one.
struct LawUnderTest {
  const reference::Entry* entry;
  double xi;
};

/// At some load factors, as far as the path goes.
struct CurveAnswers {
  std::vector<Vec3<double>> theta, u;  ///< of the loaded node, axes of the original scene
  std::vector<double> energy;          ///< that the law stores, J
  /// trace((M^-1 J)^k)^(1/k), k = 1 ...: the modes of small motions as smooth numbers (their eigenvalues have
  /// roots where two meet).
  std::vector<Eigen::VectorXd> modes;
  double condition = 1;  ///< of the tangent, the worst; where forces have other units than moments: 1
};
CurveAnswers curve_answers(const LawUnderTest& law, const Written& written);

/// Of the joint under a moment about its axis i; the body has the same place in space in every writing.
reference::CriticalLoads critical_answers(const LawUnderTest& law, const Written& written, int axis);

/// By arc length from rest, to the last load factor.
reference::EquilibriumPath arc_answers(const LawUnderTest& law, const Written& written);

/// Largest change from one answer to the other, over the largest size of it along the path (of rotations, at
/// least a thousandth of a radian); NaN where one
/// goes further than the other, or has what the other has not.
struct CurveChanges {
  Measurement pose, energy, modes;
};
CurveChanges changes(const CurveAnswers& a, const CurveAnswers& b);
Measurement change(const reference::CriticalLoads& a, const reference::CriticalLoads& b);
Measurement change(const reference::EquilibriumPath& a, const reference::EquilibriumPath& b);

}  // namespace halfway::verify
