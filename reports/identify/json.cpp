#include "reports/identify/results.hpp"

#include <cmath>

namespace halfway::reports {
namespace {

namespace id = reference::identify;
using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

template <class V>
Json numbers_of(const V& v) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) out.push_back(number(v[i]));
  return out;
}

Json rows_of(const Eigen::MatrixXd& m) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) out.push_back(numbers_of(Eigen::VectorXd(m.row(i))));
  return out;
}

/// {"value", "low", "high"} of a number whose interval is symmetric; of a stiffness that of its logarithm.
Json estimate(double value, double half, bool is_logarithm = false) {
  if (!std::isfinite(half)) return {{"value", number(value)}, {"low", nullptr}, {"high", nullptr}};
  if (is_logarithm)
    return {{"value", value}, {"low", value * std::exp(-half)}, {"high", value * std::exp(half)}};
  return {{"value", value}, {"low", value - half}, {"high", value + half}};
}

Json three(const id::Fit& fit, const Vec3<double>& values, int place, double factor, bool is_logarithm) {
  Json out = Json::array();
  for (int i = 0; i < 3; ++i)
    out.push_back(estimate(values[i], factor * fit.half_width(place + i), is_logarithm));
  return out;
}

Json axes(const Mat3<double>& columns, const id::Fit& fit, int place) {
  Json half = Json::array();
  for (int i = 0; i < 3; ++i) half.push_back(number(fit.half_width(place + i)));
  return {{"columns", rows_of(columns)}, {"half_width_rad", half}};
}

Json stage_json(const id::Identification& found, const id::StageFit& one, Kind kind) {
  const id::JointValues v = found.values(one.fit);
  Json out = {{"stage", id::to_string(one.stage)},
              {"converged", one.fit.converged},
              {"probability", number(one.probability)},
              {"variance", number(one.fit.variance)},
              {"degrees_of_freedom", one.fit.degrees}};
  if (kind == Kind::linear) return out;
  if (one.stage == id::Stage::cubic)
    out["cubic"] = estimate(v.cubic, one.fit.half_width(id::kCubic) * v.angular.mean());
  else
    out["xi_moments"] = three(one.fit, v.xi_angular, id::kXiAngular, 1, false);
  if (kind == Kind::linear_angular) out["xi_forces"] = three(one.fit, v.xi_linear, id::kXiLinear, 1, false);
  return out;
}

Json catalog_json(const Identified& what) {
  Json out = Json::array();
  for (const id::CatalogFit& one : what.found.catalog) {
    Json item = {{"formulation", one.name}, {"conservative", one.is_conservative}};
    if (!one.left_out.empty()) {
      item["left_out"] = one.left_out;
    } else {
      item["error"] = number(one.error);
      item["probability"] = number(one.probability);
      Json errors;
      const auto rms = channel_errors(what.data, one.fit);
      for (std::size_t c = 0; c < id::kChannels; ++c) {
        if (std::isfinite(rms[c])) errors[id::kChannelNames[c]] = rms[c];
      }
      item["root_mean_square"] = errors;
    }
    out.push_back(std::move(item));
  }
  return out;
}

Json data_json(const Identified& what) {
  Json cases = Json::array();
  for (const id::LoadCase& one : what.data.cases)
    cases.push_back({{"name", one.name}, {"line", one.line}, {"rows", one.loads.size()}});
  Json sigma;
  for (std::size_t c = 0; c < id::kChannels; ++c) sigma[id::kChannelNames[c]] = what.found.sigma[c];
  return {{"file", what.source},
          {"kind", to_string(what.data.kind)},
          {"numbers", id::measured_count(what.data)},
          {"cases", cases},
          {"scatter", sigma},
          {"notes", what.notes}};
}

}  // namespace

nlohmann::ordered_json identify_json(const Identified& what) {
  const id::Identification& found = what.found;
  const id::Fit& fit = found.chosen_stage().fit;
  const id::JointValues v = found.values(fit);
  const Kind kind = what.data.kind;
  const BestJoint best = best_joint(what);
  Json out = {{"schema", "halfway-identify-1"},
              {"data", data_json(what)},
              {"confidence", 0.95},
              {"chosen", id::to_string(found.chosen_stage().stage)}};
  if (kind != Kind::linear) {
    out["stiffness_about"] = three(fit, v.angular, id::kAngularStiffness, 1, true);
    out["axes"] = axes(v.H, fit, id::kAngularAxes);
  }
  if (kind != Kind::angular) {
    out["stiffness_along"] = three(fit, v.linear, id::kLinearStiffness, 1, true);
    out["axes_of_translation"] = axes(v.H * v.E, fit, id::kLinearAxes);
  }
  if (kind == Kind::linear_angular) {
    out["joint_point"] = three(fit, v.point, id::kJointPoint, found.frame.length, false);
    out["coupling_left"] = rows_of(v.S);
  }
  if (found.chosen_stage().stage == id::Stage::axis_laws) {
    const id::Frame& frame = found.frame;
    const auto cubes = [&](const Vec3<double>& k3, const Vec3<double>& k1, int place, double range) {
      Json all = Json::array();
      for (int i = 0; i < 3; ++i)
        all.push_back(estimate(k3[i], fit.half_width(place + i) * k1[i] / (range * range)));
      return all;
    };
    if (kind != Kind::linear)
      out["k3_about"] = cubes(v.angular_cube, v.angular, id::kAngularCube, frame.turn);
    if (kind != Kind::angular) out["k3_along"] = cubes(v.linear_cube, v.linear, id::kLinearCube, frame.reach);
  }
  for (const id::StageFit& one : found.stages) out["second_order"].push_back(stage_json(found, one, kind));
  out["not_identified"] = Json::array();
  for (const id::LeftOpen& one : found.left_open)
    out["not_identified"].push_back({{"what", one.what}, {"reason", one.reason}});
  out["catalog"] = catalog_json(what);
  out["scene"] = {{"formulation", best.formulation}, {"xi", best.xi}};
  return out;
}

}  // namespace halfway::reports
