#include "reports/cli/chain/chain_page.hpp"

#include "reference/chain/scenes/chain_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace halfway::reports {
namespace {

using reference::ChainAnswer;
using Nodes = std::vector<std::size_t>;

/// Poses on a page, and nodes of a shape: seventy bytes each.
constexpr std::size_t kMostPoses = 40000, kMostNodes = 129, kFewestNodes = 17;

/// Evenly, the first and the last among them.
Nodes shown_nodes(std::size_t links, const std::vector<ChainAnswer>& answers) {
  const std::size_t shapes =
      std::accumulate(answers.begin(), answers.end(), std::size_t(0),
                      [](std::size_t sum, const ChainAnswer& answer) { return sum + answer.shapes.size(); });
  const std::size_t most =
      std::clamp(kMostPoses / std::max<std::size_t>(shapes, 1), kFewestNodes, kMostNodes);
  const std::size_t count = std::min(links + 1, most);
  Nodes out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(i * links / (count - 1));
  return out;
}

Json shape_json(const std::vector<reference::chain::Node>& nodes, const Nodes& shown) {
  Json out = Json::array();
  for (std::size_t i : shown) out.push_back(pose_json(reference::chain::pose(nodes[i])));
  return out;
}

Json bodies_json(const reference::ChainScene& scene, const std::vector<reference::chain::Node>& rest,
                 const Nodes& shown) {
  Json out = Json::array();
  for (std::size_t i : shown) {
    out.push_back({{"name", fmt::format("node {}", i)},
                   {"clamped", i == 0 || (scene.held && i + 1 == rest.size())},
                   {"rest", pose_json(reference::chain::pose(rest[i]))}});
  }
  return out;
}

Json loads_json(const reference::ChainScene& scene, std::size_t body) {
  Json out = Json::array();
  const auto add = [&](const char* type, const Vec3<double>& value) {
    if (value.isZero(0)) return;
    out.push_back({{"body", body},
                   {"type", type},
                   {"value", vector_json(value)},
                   {"point", vector_json(Vec3<double>::Zero())}});
  };
  if (scene.held) return out;
  add("fixed_force", scene.loads.force);
  add("follower_force", scene.loads.follower_force);
  add("fixed_moment", scene.loads.moment);
  add("follower_moment", scene.loads.follower_moment);
  return out;
}

/// Of the two ends, at each row; empty where they are not known.
Json holding_json(const reference::ChainScene& scene, const ChainAnswer& answer) {
  const auto& entry = *reference::find_formulation(answer.curve.formulation);
  const auto chain = reference::chain_of(scene, {&entry, answer.curve.xi});
  Json out = Json::array();
  for (const auto& shape : answer.shapes) {
    const auto held = reference::holding_ends(entry, chain, shape.nodes);
    if (!held) return Json::array();
    out.push_back({load_numbers((*held)[0]), load_numbers((*held)[1])});
  }
  return out;
}

Json chain_json(const reference::ChainScene& scene) {
  const auto& [GJ, EI2, EI3, EA, GA2, GA3] = scene.chain.section;
  return {{"links", scene.chain.links},
          {"length", scene.chain.length},
          {"stiffness", {EA, GA2, GA3, GJ, EI2, EI3}},
          {"curvature", vector_json(scene.chain.curvature)},
          {"held", scene.held.has_value()}};
}

}  // namespace

Json chain_page_data(const reference::ChainScene& scene, const Ran& ran,
                     const std::vector<ChainAnswer>& answers) {
  Json out = page_head(scene, ran);
  const Nodes shown = shown_nodes(std::size_t(scene.chain.links), answers);
  out["bodies"] = bodies_json(scene, reference::chain::at_rest(scene.chain), shown);
  out["joints"] = Json::array();
  out["chain"] = chain_json(scene);
  out["loads"] = loads_json(scene, shown.size() - 1);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    Json& curve = out["curves"][i];
    curve["poses"] = Json::array();
    for (const auto& shape : answers[i].shapes) curve["poses"].push_back(shape_json(shape.nodes, shown));
    curve["holding"] = holding_json(scene, answers[i]);
  }
  return out;
}

}  // namespace halfway::reports
