// Nonlinear curves: a body's rigid face under a growing load, each point by Newton (Statics::solve).
#pragma once

#include "reference/truth/fe/statics.hpp"
#include "reference/truth/fe/studies/bodies.hpp"

namespace halfway::reference::fe {

struct CurvePoint {
  double factor;
  Vec3<double> d;      ///< of the joint point, m
  Vec3<double> theta;  ///< rad
  int iterations;
};

struct SolidCurve {
  std::string body;
  std::string scene;  ///< the lumped case it is the truth of
  SolidLaw law;
  ElementKind element;
  int level;
  int unknowns;
  double seconds;                  ///< wall
  std::vector<CurvePoint> points;  ///< as many as converged
  std::string outcome;             ///< "converged" or why it ended
};

/// load: at factor 1, at the joint point (given from the face's centre, m); points up to factor_end, evenly.
SolidCurve follow(const Body& body, const Vec3<double>& joint_point, SolidLaw law, ElementKind element,
                  int level, const Load& load, double factor_end, int points);

void to_json(nlohmann::json& json, const SolidCurve& curve);
void from_json(const nlohmann::json& json, SolidCurve& curve);

}  // namespace halfway::reference::fe
