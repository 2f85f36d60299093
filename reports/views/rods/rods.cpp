#include "reports/views/rods/rods.hpp"

#include "reports/views/parts.hpp"
#include "reports/views/rods/chains.hpp"
#include "reports/views/rounded.hpp"
#include "verify/studies/rods/end_force.hpp"
#include "verify/studies/rods/one_joint.hpp"
#include "verify/studies/solids/c3_body.hpp"

#include <stdexcept>

namespace halfway::reports {
namespace {

using namespace verify;
using nlohmann::json;
using reference::Entry, reference::formulations;
namespace fe = reference::fe;

/// The load up to which the error stays within a tolerance, and how far the rod has turned there.
json reach(const Followed& followed, double tolerance) {
  const auto last = followed.last_within(tolerance);
  if (!last) return {{"tolerance", tolerance}, {"moment", 0}, {"angle", 0}};
  return {{"tolerance", tolerance},
          {"moment", skew_moment().moment[*last]},
          {"angle", rounded(skew_moment().rod_angle[*last], 4)}};
}

json skew_record() {
  const SkewMoment& truth = skew_moment();
  json curves = json::array(), rod = json::array();
  for (const Entry& entry : formulations()) {
    const Followed& followed = follows_skew_moment(entry);
    curves.push_back({{"formulation", entry.name},
                      {"error", rounded(followed.error, 3)},
                      {"within", {reach(followed, 0.01), reach(followed, 0.05)}}});
  }
  for (const Vec3<double>& theta : truth.rod) rod.push_back(rounded({theta[0], theta[1], theta[2]}, 6));
  return {
      {"moment", truth.moment}, {"angle", rounded(truth.rod_angle, 5)}, {"theta", rod}, {"curves", curves}};
}

json random_record() {
  json out = json::array();
  for (const RandomMoments& of : random_moments()) {
    json rows = json::array();
    for (const Entry& entry : formulations()) {
      const Spread& s = error_of_random(entry, of);
      rows.push_back(
          {{"formulation", entry.name}, {"median", rounded(s.median, 4)}, {"lost", s.lost}, {"of", s.of}});
    }
    out.push_back(
        {{"stiffness", of.name}, {"drawn", to_string(of.drawn)}, {"size", of.size}, {"rows", rows}});
  }
  return out;
}

json semi_tangential_record() {
  json out = json::array();
  for (const SemiTangential& of : semi_tangential()) {
    json rows = json::array();
    for (const Entry& entry : formulations()) {
      const auto& load = critical_of(entry, of);
      rows.push_back(
          {{"formulation", entry.name}, {"ratio", load ? json(rounded(*load / of.critical, 4)) : json()}});
    }
    out.push_back({{"stiffness", of.name}, {"rod", rounded(of.critical, 12)}, {"rows", rows}});
  }
  return out;
}

json force_record() {
  json out = json::array();
  for (const Where where : kWhere) {
    json rows = json::array();
    for (const Entry& entry : formulations()) {
      const ForceErrors& errors = force_errors(entry, where);
      json error = json::array();
      for (const double x : errors) error.push_back(rounded(x, 4));
      rows.push_back({{"formulation", entry.name}, {"error", error}, {"order", rounded(growth(errors), 4)}});
    }
    out.push_back({{"where", to_string(where)}, {"force", kForces}, {"rows", rows}});
  }
  return out;
}

constexpr RecordPart kParts[] = {{"skew", skew_record},
                                 {"random", random_record},
                                 {"semi_tangential", semi_tangential_record},
                                 {"force", force_record},
                                 {"chains", chains_record}};

}  // namespace

json c3_reference_curves() {
  json out = json::array();
  const auto add = [&](const std::string& body, const char* source, const json& rows) {
    out.push_back({{"scene", "c3_buckling"},
                   {"formulation", body},
                   {"source", source},
                   {"columns", {"factor", "theta_x", "theta_y", "theta_z"}},
                   {"rows", rows}});
  };
  for (const auto law : {fe::SolidLaw::cauchy_log, fe::SolidLaw::neo_hooke}) try {
      json rows = json::array();
      for (const BodyPoint& p : body_curve(law, fe::ElementKind::hex20_full))
        rows.push_back(rounded({p.moment, p.theta[0].value, p.theta[1].value, p.theta[2].value}, 6));
      add(std::string("block, ") + to_string(law), "3D finite elements", rows);
    } catch (const std::runtime_error&) {
      continue;  // its data is not there or stale: named among what solids miss
    }
  const SkewMoment& truth = skew_moment();
  json rows = json::array();
  constexpr std::size_t kEvery = 12;  // of a load of 5 N m: marks beside lines
  for (std::size_t i = kEvery - 1; i < truth.moment.size(); i += kEvery)
    rows.push_back(rounded({truth.moment[i], truth.rod[i][0], truth.rod[i][1], truth.rod[i][2]}, 7));
  add("slender rod", "geometrically exact rod", rows);
  return out;
}

json rods_record(const std::function<void(int, int, const std::string&)>& progress) {
  return record_of(kParts, progress);
}

}  // namespace halfway::reports
