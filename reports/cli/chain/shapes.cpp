#include "reports/cli/chain/shapes.hpp"

#include "halfway/joint/unwrapped.hpp"
#include "reference/record/worst.hpp"
#include "reports/cli/run/run_chart.hpp"
#include "reports/cli/run/run_files.hpp"
#include "reports/cli/run/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace halfway::reports {
namespace {

constexpr double kTallest = 420, kLowest = 60;  // of a panel, px

/// A polyline of more is no smoother.
constexpr std::size_t kMostPoints = 1000;

void add_rows(std::string& out, const reference::ChainScene& scene, const reference::Curve& curve,
              const reference::Shape& shape) {
  const double h = scene.chain.length / double(scene.chain.links);
  UnwrappedRotation<double> turned(so3::log<double>(scene.chain.root.R));
  const std::string label = fmt::format("{},{},{:.17g}", curve.formulation, xi_text(curve), shape.factor);
  for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
    const auto& [x, q] = shape.nodes[i];
    turned.update(so3::Quaternion<double>{q[0], {q[1], q[2], q[3]}});
    const Vec3<double>& theta = turned.theta();
    fmt::format_to(std::back_inserter(out), "{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n",
                   label, h * double(i), x[0], x[1], x[2], theta[0], theta[1], theta[2]);
  }
}

/// Of all shapes, along each global axis.
std::array<reference::Extent, 3> extents(const std::vector<reference::ChainAnswer>& answers) {
  std::array<reference::Extent, 3> out;
  for (const auto& answer : answers) {
    for (const auto& shape : answer.shapes) {
      for (const auto& node : shape.nodes) {
        for (std::size_t axis = 0; axis < 3; ++axis) out[axis].include(node.x[axis]);
      }
    }
  }
  return out;
}

struct Plane {
  std::size_t across, up;  ///< global axes
};

/// The planes in which the shapes are no line; at least one.
std::vector<Plane> planes_of(const std::array<reference::Extent, 3>& extent) {
  const auto size = [&](std::size_t axis) { return extent[axis].high() - extent[axis].low(); };
  const double seen = 1e-3 * std::max({size(0), size(1), size(2)});
  std::vector<Plane> out;
  for (const Plane plane : {Plane{0, 1}, Plane{0, 2}, Plane{1, 2}}) {
    if (size(plane.across) > seen && size(plane.up) > seen) out.push_back(plane);
  }
  if (out.empty()) out.push_back(size(2) > seen ? Plane{0, 2} : Plane{0, 1});
  return out;
}

/// To scale; what is flat gets room above and below.
svg::Panel panel_of(const reference::Extent& across, const reference::Extent& up, double top) {
  const double width = std::max(across.high() - across.low(), (up.high() - up.low()) / 4);
  const double height = std::max(up.high() - up.low(), width * kLowest / svg::kPanelWidth);
  const auto widened = [](const reference::Extent& e, double size) {
    const double margin = (size - (e.high() - e.low())) / 2;
    return svg::Axis(e.low() - margin, e.high() + margin);
  };
  svg::Panel out{widened(across, width), widened(up, height), top, 0, 0};
  const double dx = out.x.high - out.x.low, dy = out.y.high - out.y.low;
  const double scale = std::min(svg::kPanelWidth / dx, kTallest / dy);
  out.width = scale * dx;
  out.height = scale * dy;
  return out;
}

svg::Points points_of(const std::vector<reference::chain::Node>& nodes, const Plane& plane) {
  const std::size_t step = nodes.size() / kMostPoints + 1;
  svg::Points out;
  for (std::size_t i = 0; i < nodes.size(); i += step)
    out.emplace_back(nodes[i].x[plane.across], nodes[i].x[plane.up]);
  out.emplace_back(nodes.back().x[plane.across], nodes.back().x[plane.up]);
  return out;
}

void draw_shapes(std::string& out, const svg::Panel& panel, const Plane& plane,
                 const std::vector<reference::ChainAnswer>& answers) {
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (const auto& shape : answers[i].shapes) {
      const bool is_last = &shape == &answers[i].shapes.back();
      svg::draw_line(out, panel, points_of(shape.nodes, plane), i, is_last ? 1 : 0.3);
    }
  }
}

std::vector<reference::Curve> curves_of(const std::vector<reference::ChainAnswer>& answers) {
  std::vector<reference::Curve> out;
  for (const auto& answer : answers) out.push_back(answer.curve);
  return out;
}

}  // namespace

std::string shapes_csv(const reference::ChainScene& scene,
                       const std::vector<reference::ChainAnswer>& answers) {
  std::string out = "formulation,xi,factor,s,x,y,z,theta_x,theta_y,theta_z\n";
  for (const auto& answer : answers) {
    for (const auto& shape : answer.shapes) add_rows(out, scene, answer.curve, shape);
  }
  return out;
}

std::string shapes_svg(const reference::ChainScene& scene,
                       const std::vector<reference::ChainAnswer>& answers) {
  const auto extent = extents(answers);
  std::string panels;
  double bottom = svg::kTop;
  for (const Plane& plane : planes_of(extent)) {
    const svg::Panel panel = panel_of(extent[plane.across], extent[plane.up], bottom);
    svg::draw_axes(panels, panel, fmt::format("{} (m)", "xyz"[plane.across]),
                   fmt::format("{} (m)", "xyz"[plane.up]));
    draw_shapes(panels, panel, plane, answers);
    bottom += panel.height + svg::kGap;
  }
  svg::draw_legend(panels, legend_of(curves_of(answers)));
  const double width = svg::kLeft + svg::kPanelWidth + 22 + 33 + svg::kLegendWidth;
  const double height = std::max(bottom, svg::kTop + svg::legend_height(answers.size()));
  return svg::begin(width, height, scene.title) + panels + "</svg>\n";
}

}  // namespace halfway::reports
