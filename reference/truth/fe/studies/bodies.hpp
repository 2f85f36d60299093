// The bodies of the paper and their variants: THE list of what is characterised.
#pragma once

#include "reference/truth/fe/laws.hpp"
#include "reference/truth/fe/mesh.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace halfway::reference::fe {

struct Body {
  std::string name;         ///< of its data file
  std::string title;        ///< for people
  nlohmann::json geometry;  ///< everything that the mesh follows from, m; part of the data's key
  Material material;
  Vec3<double> face;                                 ///< centre of the rigid face, m
  std::function<Mesh(ElementKind, int level)> mesh;  ///< level: elements along the shortest edge
};

/// Parallelepiped, frustum in both directions and with its printed height.
const std::vector<Body>& bodies();
/// Throws std::invalid_argument naming the value and what is allowed.
const Body& body_named(const std::string& name);

}  // namespace halfway::reference::fe
