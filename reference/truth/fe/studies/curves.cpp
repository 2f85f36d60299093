#include "reference/truth/fe/studies/curves.hpp"

#include "reference/truth/fe/studies/vectors.hpp"

#include <chrono>

namespace halfway::reference::fe {

SolidCurve follow(const Body& body, const Vec3<double>& joint_point, SolidLaw law, ElementKind element,
                  int level, const Load& load, double factor_end, int points) {
  const auto begin = std::chrono::steady_clock::now();
  const Solid solid(body.mesh(element, level), body.material, body.face + joint_point);
  Statics statics(solid);
  SolidCurve curve{body.name, "", law, element, level, solid.unknowns(), 0, {}, "converged"};
  State state = solid.unloaded();
  for (int i = 1; i <= points; ++i) {
    const double factor = factor_end * i / points;
    const Equilibrium e = statics.solve(law, {factor * load.f, factor * load.m, load.follower}, state);
    if (!e.converged) {
      curve.outcome = "ended before factor " + std::to_string(factor) + ": " + e.reason;
      break;
    }
    state = e.state;
    curve.points.push_back({factor, state.d, e.theta(), e.iterations});
  }
  curve.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return curve;
}

void to_json(nlohmann::json& json, const SolidCurve& curve) {
  json = {{"body", curve.body},
          {"scene", curve.scene},
          {"law", to_string(curve.law)},
          {"element", to_string(curve.element)},
          {"level", curve.level},
          {"unknowns", curve.unknowns},
          {"seconds", curve.seconds},
          {"outcome", curve.outcome},
          {"points", nlohmann::json::array()}};
  for (const CurvePoint& p : curve.points) {
    json["points"].push_back(
        {{"factor", p.factor}, {"d", triple(p.d)}, {"theta", triple(p.theta)}, {"iterations", p.iterations}});
  }
}

void from_json(const nlohmann::json& json, SolidCurve& curve) {
  curve = {
      json.at("body"),   json.at("scene"),    law_named(json.at("law")), element_kind(json.at("element")),
      json.at("level"),  json.at("unknowns"), json.at("seconds"),        {},
      json.at("outcome")};
  for (const auto& p : json.at("points"))
    curve.points.push_back({p.at("factor"), vector(p.at("d")), vector(p.at("theta")), p.at("iterations")});
}

}  // namespace halfway::reference::fe
