#include "verify/studies/chains/chain_rods.hpp"

#include "reference/chain/scenes/solve_chain_scene.hpp"
#include "reference/scene/any_scene.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

namespace halfway::verify {
namespace {

using reference::ChainScene;
using reference::SceneReference;

/// Half a unit of the last digit of a number without exponent.
double half_unit(const std::string& digits) {
  return 0.5 * std::pow(10.0, -double(digits.size() - digits.find('.') - 1));
}

ChainRod rod_of(const ChainScene& scene) {
  constexpr double kNotSure = 10;  // the last digit but one is
  ChainRod out{&scene, reference::scaled(scene.loads, scene.factor_end), Vec3<double>::Constant(std::nan("")),
               0};
  for (const SceneReference& r : scene.references) {
    const bool is_tip = r.formulation == reference::kRod && r.oracle == reference::Oracle::independent &&
                        r.factor == scene.factor_end && r.output.size() == 1;
    if (!is_tip) continue;
    out.tip[r.output[0] - 'x'] = std::stod(r.value);
    reference::keep_largest(out.uncertainty, kNotSure * half_unit(r.value));
  }
  return out;
}

}  // namespace

const std::vector<ChainScene>& chains() {
  static const std::vector<ChainScene> kept = reference::chain_scenes();
  return kept;
}

const ChainScene& chain_scene(const std::string& name) {
  for (const ChainScene& scene : chains()) {
    if (scene.name == name) return scene;
  }
  throw std::runtime_error("no scene of a chain is named " + name);
}

const ChainRod& chain_rod(const std::string& name) {
  static std::map<std::string, ChainRod> kept;
  const auto found = kept.find(name);
  return found != kept.end() ? found->second : kept.emplace(name, rod_of(chain_scene(name))).first->second;
}

reference::chain::Chain chain_with(const ChainScene& scene, const reference::Entry& entry, long links) {
  reference::chain::Chain out = reference::chain_of(scene, {&entry, entry.probe_xi});
  out.links = links;
  return out;
}

reference::chain::Chain generic_chain(const reference::Entry& entry) {
  reference::chain::Chain out = chain_with(chain_scene("precurved_anisotropic"), entry, 12);
  out.length = 1.3;
  out.root = {{1, -2, 0.5}, so3::exp<double>({0.4, -0.7, 1.1})};
  return out;
}

const Mat3<double> kDeadForces =
    (Mat3<double>() << 0.2, -0.3, 0.1, 0.4, -0.1, 0.25, -0.15, 0.2, 0.3).finished();

}  // namespace halfway::verify
