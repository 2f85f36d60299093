#include "verify/studies/stability/block_loads.hpp"

#include "verify/once.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace halfway::verify {
namespace {

using namespace reference;

/// Sampled once for all moments and bodies.
const PrimaryPath& primary_path(const Entry& entry, int axis) {
  static Once<PrimaryPath, int> known;
  return known(entry, axis, [&] { return PrimaryPath(entry, block_joint(entry), axis); });
}

}  // namespace

JointSpec block_joint(const Entry& entry) {
  JointSpec spec = scene(kBlockScene).joint;
  spec.xi = entry.probe_xi;
  return spec;
}

const CriticalLoads& critical_loads(const Entry& entry, int axis, const MomentSetting& setting,
                                    const BodyInertia& body) {
  static Once<CriticalLoads, int, std::string, std::string> known;
  return known(entry, axis, to_string(setting), body.name,
               [&] { return primary_path(entry, axis).critical(setting, body); });
}

const CriticalLoads& begun_loads(const Entry& entry, int axis, const MomentSetting& setting,
                                 const BodyInertia& body) {
  const CriticalLoads& out = critical_loads(entry, axis, setting, body);
  if (out.end_angle > 0) return out;
  throw std::runtime_error(
      fmt::format("{} has no path about axis {}: it ends where it begins", entry.name, axis + 1));
}

BlockModes block_modes(const Entry& entry, int axis, const MomentSetting& setting, const BodyInertia& body,
                       double angle) {
  const auto p = loaded_state<double>(entry, block_joint(entry), axis, setting, angle);
  const auto mu = modes(p.J, mass_matrix(body, p.R, 3));
  BlockModes out{p.load, angle, mu.front().real()};
  for (const auto& m : mu) {
    keep_largest(out.imaginary, std::abs(m.imag()));
    keep_largest(out.growth, std::abs(std::sqrt(-m).real()));
  }
  return out;
}

std::vector<BlockModes> modes_along(const Entry& entry, const MomentSetting& setting) {
  constexpr int kPoints = 60;
  const double end = primary_path(entry, kModesAxis).end_angle();
  std::vector<BlockModes> out;
  for (int i = 0; i < kPoints; ++i) {
    const BlockModes at = block_modes(entry, kModesAxis, setting, kRound, end * i / kPoints);
    if (i > 0 && !(at.load > 0)) break;
    out.push_back(at);
  }
  return out;
}

}  // namespace halfway::verify
