#include "reports/cli/run/run_chart.hpp"

#include "reports/cli/run/comparison.hpp"
#include "reports/cli/run/run_files.hpp"
#include "reports/cli/run/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reports {
namespace {

constexpr double kPanelHeight = 200;

svg::Axis axis_of(const std::vector<reference::Curve>& curves, std::size_t column) {
  double low = 0, high = 0;
  for (const auto& curve : curves) {
    for (const auto& row : curve.rows) {
      low = std::min(low, row[column]);
      high = std::max(high, row[column]);
    }
  }
  return {low, high};
}

void draw_curves(std::string& out, const svg::Panel& panel, const std::vector<reference::Curve>& curves,
                 std::size_t column) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    svg::Points points;
    for (const auto& row : curves[i].rows) points.emplace_back(row[0], row[column]);
    svg::draw_line(out, panel, points, i);
  }
}

}  // namespace

std::vector<std::string> legend_of(const std::vector<reference::Curve>& curves) {
  std::vector<std::string> labels;
  for (const auto& curve : curves)
    labels.push_back(curve_label(curve) + (curve.converged ? "" : " (ends early)"));
  return labels;
}

std::string curves_svg(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves) {
  const std::size_t panels = scene.outputs.size();
  const double width = svg::kLeft + svg::kPanelWidth + 22 + 33 + svg::kLegendWidth;
  const double height =
      svg::kTop + std::max(double(panels) * (kPanelHeight + svg::kGap), svg::legend_height(curves.size()));
  std::string out = svg::begin(width, height, scene.title);
  for (std::size_t i = 0; i < panels; ++i) {
    const svg::Panel panel{axis_of(curves, 0), axis_of(curves, i + 1),
                           svg::kTop + double(i) * (kPanelHeight + svg::kGap), svg::kPanelWidth,
                           kPanelHeight};
    svg::draw_axes(out, panel, scene.is_in_time ? "time (s)" : "load factor",
                   fmt::format("{} ({})", scene.outputs[i], reference::unit_of_output(scene.outputs[i])));
    draw_curves(out, panel, curves, i + 1);
  }
  svg::draw_legend(out, legend_of(curves));
  return out + "</svg>\n";
}

}  // namespace halfway::reports
