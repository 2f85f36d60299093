#include "reference/truth/fe/studies/bodies.hpp"

#include <cmath>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

constexpr double kEdgeGrading =
    3;  ///< resolves the edge singularity (exponent 0.711) at the element's own order

/// Divisions in proportion to the level: `along` and `across` the shortest edge (axis 3).
Body block(const std::string& name, const std::string& title, const TaperedBlock& size, double along,
           double across) {
  Body body;
  body.name = name;
  body.title = title;
  body.geometry = {{"family", "tapered_block"}, {"length", size.length}, {"clamped", size.clamped},
                   {"free", size.free},         {"along", along},        {"across", across},
                   {"grading", kEdgeGrading}};
  body.material = {1, 0.3};
  body.face = {size.length, 0, 0};
  body.mesh = [=](ElementKind element, int level) {
    const auto divisions = [&](double ratio) { return std::max(2, int(std::lround(ratio * level))); };
    return tapered_block(element, size, {divisions(along), divisions(across), level}, kEdgeGrading);
  };
  return body;
}

}  // namespace

const std::vector<Body>& bodies() {
  static const std::vector<Body> list = {
      block("block", "Parallelepiped 5 x 30 x 5 m (Table 2)", {5, {30, 5}, {30, 5}}, 1, 1.5),
      block("frustum_top", "Frustum of height 20 m, top clamped (Table 3)", {20, {10, 5}, {30, 5}}, 1.5, 2.5),
      block("frustum_base", "Frustum of height 20 m, base clamped", {20, {30, 5}, {10, 5}}, 1.5, 2.5),
      block("frustum_printed", "Frustum of the printed height 10 m, top clamped", {10, {10, 5}, {30, 5}}, 1,
            2.5),
  };
  return list;
}

const Body& body_named(const std::string& name) {
  std::string allowed;
  for (const Body& body : bodies()) {
    if (body.name == name) return body;
    allowed += (allowed.empty() ? "" : ", ") + body.name;
  }
  throw std::invalid_argument("body is \"" + name + "\"; allowed: " + allowed);
}

}  // namespace halfway::reference::fe
