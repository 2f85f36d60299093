#include "reference/truth/fe/shapes.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

/// Value and gradient at a local point.
struct Shape {
  double value;
  Vec3<double> gradient;
};

/// A product of one factor per direction, each with its derivative.
Shape product(const std::array<std::array<double, 2>, 3>& f) {
  return {f[0][0] * f[1][0] * f[2][0],
          {f[0][1] * f[1][0] * f[2][0], f[0][0] * f[1][1] * f[2][0], f[0][0] * f[1][0] * f[2][1]}};
}

Shape trilinear(const Vec3<int>& node, const Vec3<double>& s) {
  std::array<std::array<double, 2>, 3> f;
  for (int d = 0; d < 3; ++d) f[d] = {(1 + node[d] * s[d]) / 2, node[d] / 2.0};
  return product(f);
}

/// Quadratic Lagrange in each direction (hex27).
Shape triquadratic(const Vec3<int>& node, const Vec3<double>& s) {
  std::array<std::array<double, 2>, 3> f;
  for (int d = 0; d < 3; ++d) {
    if (node[d] == 0)
      f[d] = {1 - s[d] * s[d], -2 * s[d]};
    else
      f[d] = {s[d] * (s[d] + node[d]) / 2, s[d] + node[d] / 2.0};
  }
  return product(f);
}

/// Serendipity (hex20).
Shape serendipity(const Vec3<int>& node, const Vec3<double>& s) {
  std::array<std::array<double, 2>, 3> f;
  bool corner = true;
  for (int d = 0; d < 3; ++d) {
    if (node[d] == 0) {
      f[d] = {1 - s[d] * s[d], -2 * s[d]};
      corner = false;
    } else {
      f[d] = {(1 + node[d] * s[d]) / 2, node[d] / 2.0};
    }
  }
  Shape shape = product(f);
  if (!corner) return shape;
  const Vec3<double> n = node.cast<double>();
  const double sum = n.dot(s) - 2;
  return {shape.value * sum, shape.gradient * sum + shape.value * n};
}

Shape shape(ElementKind kind, const Vec3<int>& node, const Vec3<double>& s) {
  switch (kind) {
    case ElementKind::hex8i:
      return trilinear(node, s);
    case ElementKind::hex27:
      return triquadratic(node, s);
    default:
      return serendipity(node, s);
  }
}

/// Corners, edges, then (hex27) faces and centre.
std::vector<Vec3<int>> element_nodes(ElementKind kind) {
  std::vector<Vec3<int>> out = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  if (kind == ElementKind::hex8i) return out;
  for (const Vec3<int>& edge :
       {Vec3<int>(0, -1, -1), Vec3<int>(1, 0, -1), Vec3<int>(0, 1, -1), Vec3<int>(-1, 0, -1),
        Vec3<int>(0, -1, 1), Vec3<int>(1, 0, 1), Vec3<int>(0, 1, 1), Vec3<int>(-1, 0, 1),
        Vec3<int>(-1, -1, 0), Vec3<int>(1, -1, 0), Vec3<int>(1, 1, 0), Vec3<int>(-1, 1, 0)})
    out.push_back(edge);
  if (kind != ElementKind::hex27) return out;
  for (int d = 0; d < 3; ++d) {
    for (int side : {-1, 1}) out.push_back(side * Vec3<int>::Unit(d));
  }
  out.push_back(Vec3<int>::Zero());
  return out;
}

/// Gauss points of one direction: 2 for reduced integration, else 3.
std::vector<std::array<double, 2>> gauss(ElementKind kind) {
  const double a = std::sqrt(1.0 / 3), b = std::sqrt(0.6);
  if (kind == ElementKind::hex20 || kind == ElementKind::hex8i) return {{-a, 1}, {a, 1}};
  return {{-b, 5.0 / 9}, {0, 8.0 / 9}, {b, 5.0 / 9}};
}

ReferenceElement build(ElementKind kind) {
  ReferenceElement e{kind, element_nodes(kind), {}, {}, {}};
  const auto line = gauss(kind);
  for (const auto& z : line) {
    for (const auto& y : line) {
      for (const auto& x : line) {
        e.points.emplace_back(x[0], y[0], z[0]);
        e.weights.push_back(x[1] * y[1] * z[1]);
      }
    }
  }
  for (std::size_t p = 0; p < e.points.size(); ++p) {
    e.dN.emplace_back(3, Eigen::Index(e.nodes.size()));
    for (std::size_t n = 0; n < e.nodes.size(); ++n) {
      e.dN[p].col(Eigen::Index(n)) = shape(kind, e.nodes[n], e.points[p]).gradient;
    }
  }
  return e;
}

constexpr ElementKind kKinds[] = {ElementKind::hex20, ElementKind::hex20_full, ElementKind::hex27,
                                  ElementKind::hex8i};

}  // namespace

const char* to_string(ElementKind kind) {
  switch (kind) {
    case ElementKind::hex20:
      return "hex20";
    case ElementKind::hex20_full:
      return "hex20_full";
    case ElementKind::hex27:
      return "hex27";
    default:
      return "hex8i";
  }
}

ElementKind element_kind(const std::string& name) {
  for (ElementKind kind : kKinds) {
    if (name == to_string(kind)) return kind;
  }
  throw std::invalid_argument("element is \"" + name + "\"; allowed: hex20, hex20_full, hex27, hex8i");
}

const ReferenceElement& reference_element(ElementKind kind) {
  static const std::array<ReferenceElement, 4> elements = {build(kKinds[0]), build(kKinds[1]),
                                                           build(kKinds[2]), build(kKinds[3])};
  return elements[std::size_t(kind)];
}

}  // namespace halfway::reference::fe
