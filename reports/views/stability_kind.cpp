#include "reports/views/stability_kind.hpp"

#include "reference/solve/stability/critical.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfway::reports {
namespace {

using namespace reference;
using nlohmann::json;

constexpr const char* kScene = "c3_buckling";
constexpr int kModesAxis = 0, kModesPoints = 60;

struct Described {
  MomentSetting setting;
  const char* what;
};
constexpr std::array<Described, 5> kMoments = {
    {{kMomentSettings[0], "direction fixed in space"},
     {kMomentSettings[1], "turns with the body"},
     {kMomentSettings[2], "two equal couples of dead forces, arms square to them at each state"},
     {kMomentSettings[3], "one couple of dead forces, arm square to them at each state"},
     {kMomentSettings[4], "the two couples set square once, in the unstrained state"}}};

const std::array<BodyInertia, 2> kBodies = {{{}, {"1:2:2.5", {1, 2, 2.5}, 1}}};

JointSpec spec_of(const Entry& entry) {
  JointSpec spec = verify::scene(kScene).joint;
  spec.xi = entry.probe_xi;
  return spec;
}

json row(const Entry& entry, int axis, const MomentSetting& setting, const std::string& inertia,
         StabilityKind kind, const std::optional<Critical>& found, const CriticalLoads& all) {
  return {{"formulation", entry.name},
          {"axis", axis + 1},
          {"moment", to_string(setting)},
          {"inertia", inertia},
          {"kind", to_string(kind)},
          {"load", found ? json(double(found->load)) : json(nullptr)},
          {"angle", found ? json(double(found->angle)) : json(nullptr)},
          {"until", all.end_angle},
          {"end", to_string(all.end)}};
}

void add_rows(json& rows, const Entry& entry, int axis) {
  const PrimaryPath path(entry, spec_of(entry), axis);
  for (const Described& moment : kMoments) {
    for (std::size_t i = 0; i < kBodies.size(); ++i) {
      const CriticalLoads c = path.critical(moment.setting, kBodies[i]);
      if (i == 0)
        rows.push_back(row(entry, axis, moment.setting, "any", StabilityKind::divergence, c.divergence, c));
      rows.push_back(row(entry, axis, moment.setting, kBodies[i].name, StabilityKind::flutter, c.flutter, c));
    }
  }
}

/// Six digits: what a chart shows.
double rounded(double x) { return std::isfinite(x) ? std::stod(fmt::format("{:.6g}", x)) : x; }

json modes_of(const Entry& entry, const MomentSetting& setting) {
  const JointSpec spec = spec_of(entry);
  const double end = PrimaryPath(entry, spec, kModesAxis).end_angle();
  json points = json::array();
  for (int i = 0; i < kModesPoints; ++i) {
    const double angle = end * i / kModesPoints;
    const auto p = loaded_state<double>(entry, spec, kModesAxis, setting, angle);
    if (i > 0 && !(p.load > 0)) break;
    const auto mu = modes(p.J, mass_matrix(kBodies[0], p.R, 3));
    double imaginary = 0, growth = 0;
    for (const auto& m : mu) {
      keep_largest(imaginary, std::abs(m.imag()));
      keep_largest(growth, std::abs(std::sqrt(-m).real()));
    }
    points.push_back(
        {rounded(p.load), rounded(angle), rounded(mu.front().real()), rounded(imaginary), rounded(growth)});
  }
  return {{"formulation", entry.name},
          {"moment", to_string(setting)},
          {"axis", kModesAxis + 1},
          {"inertia", kBodies[0].name},
          {"columns", {"load", "angle", "lowest", "imaginary", "growth"}},
          {"points", points}};
}

}  // namespace

json stability_kind_record() {
  json out = {{"scene", kScene}, {"rows", json::array()}, {"modes", json::array()}};
  for (const Described& m : kMoments)
    out["moments"].push_back({{"name", to_string(m.setting)}, {"what", m.what}});
  for (const BodyInertia& b : kBodies)
    out["bodies"].push_back(
        {{"name", b.name}, {"principal", {b.principal[0], b.principal[1], b.principal[2]}}});
  for (const Entry& entry : formulations()) {
    for (int axis = 0; axis < 3; ++axis) add_rows(out["rows"], entry, axis);
    for (std::size_t i = 0; i < 3; ++i) out["modes"].push_back(modes_of(entry, kMoments[i].setting));
  }
  return out;
}

}  // namespace halfway::reports
