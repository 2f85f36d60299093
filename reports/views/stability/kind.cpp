#include "reports/views/stability/kind.hpp"

#include "reports/views/rounded.hpp"
#include "verify/studies/stability/block_loads.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halfway::reports {
namespace {

using namespace reference;
using namespace verify;
using nlohmann::json;

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
  for (const Described& moment : kMoments) {
    for (const BodyInertia& body : kBlockBodies) {
      const CriticalLoads& c = critical_loads(entry, axis, moment.setting, body);
      if (&body == &kRound)
        rows.push_back(row(entry, axis, moment.setting, "any", StabilityKind::divergence, c.divergence, c));
      rows.push_back(row(entry, axis, moment.setting, body.name, StabilityKind::flutter, c.flutter, c));
    }
  }
}

json modes_of(const Entry& entry, const MomentSetting& setting) {
  json points = json::array();
  for (const BlockModes& m : modes_along(entry, setting)) {
    points.push_back({rounded(m.load, 6), rounded(m.angle, 6), rounded(m.lowest, 6), rounded(m.imaginary, 6),
                      rounded(m.growth, 6)});
  }
  return {{"formulation", entry.name},
          {"moment", to_string(setting)},
          {"axis", kModesAxis + 1},
          {"inertia", kRound.name},
          {"columns", {"load", "angle", "lowest", "imaginary", "growth"}},
          {"points", points}};
}

}  // namespace

json stability_kind_record() {
  json out = {{"scene", kBlockScene}, {"rows", json::array()}, {"modes", json::array()}};
  for (const Described& m : kMoments)
    out["moments"].push_back({{"name", to_string(m.setting)}, {"what", m.what}});
  for (const BodyInertia& b : kBlockBodies)
    out["bodies"].push_back(
        {{"name", b.name}, {"principal", {b.principal[0], b.principal[1], b.principal[2]}}});
  for (const Entry& entry : formulations()) {
    for (int axis = 0; axis < 3; ++axis) add_rows(out["rows"], entry, axis);
    for (std::size_t i = 0; i < 3; ++i) out["modes"].push_back(modes_of(entry, kMoments[i].setting));
  }
  return out;
}

}  // namespace halfway::reports
