#include "reports/identify/residuals.hpp"

#include "reports/cli/run/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reports {
namespace {

namespace id = reference::identify;

constexpr double kPanelHeight = 130;

/// One component of motion or load, over the number of its row.
struct Component {
  std::string name, unit;
  std::array<svg::Points, 2> points{};
};

std::vector<Component> components(const Identified& what, const id::Fit& shown, const id::Fit& scene) {
  std::vector<Component> all(12);
  Eigen::Index at = 0;
  double row_number = 0;
  for (const id::LoadCase& one : what.data.cases) {
    for (std::size_t row = 0; row < one.loads.size(); ++row, ++row_number) {
      for (int i = id::first_component(what.data.kind); i < id::end_component(what.data.kind); ++i) {
        if (!one.is_measured(i)) continue;
        const bool is_load = one.held[std::size_t(i)];
        Component& to = all[std::size_t(i + (is_load ? 6 : 0))];
        to.name = (is_load ? id::kLoadNames : id::kMotionNames)[std::size_t(i)];
        to.unit = id::kChannelUnits[std::size_t(one.channel(i))];
        to.points[0].emplace_back(row_number, shown.residual[at]);
        to.points[1].emplace_back(row_number, scene.residual[at]);
        ++at;
      }
    }
  }
  std::erase_if(all, [](const Component& one) { return one.name.empty(); });
  return all;
}

svg::Axis axis_of(const Component& one) {
  double low = 0, high = 0;
  for (const svg::Points& points : one.points) {
    for (const auto& [x, y] : points) {
      if (std::isfinite(y)) low = std::min(low, y), high = std::max(high, y);
    }
  }
  return {low, high};
}

}  // namespace

std::string residuals_svg(const Identified& what) {
  const BestJoint best = best_joint(what);
  const auto all = components(what, what.found.chosen_stage().fit, best.fit);
  std::size_t rows = 0;
  for (const id::LoadCase& one : what.data.cases) rows += one.loads.size();
  const double width = svg::kLeft + svg::kPanelWidth + 22 + 33 + svg::kLegendWidth;
  const double height = svg::kTop + double(all.size()) * (kPanelHeight + svg::kGap);
  std::string out = svg::begin(width, height, "Measured less answered");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const svg::Panel panel{{0, double(rows)},
                           axis_of(all[i]),
                           svg::kTop + double(i) * (kPanelHeight + svg::kGap),
                           svg::kPanelWidth,
                           kPanelHeight};
    svg::draw_axes(out, panel, "row", fmt::format("{}, {}", all[i].name, all[i].unit));
    for (const std::size_t curve : {1u, 0u}) svg::draw_points(out, panel, all[i].points[curve], curve);
  }
  svg::draw_legend(out, {fmt::format("fit: {}", id::to_string(what.found.chosen_stage().stage)),
                         "scene: " + best.formulation});
  return out + "</svg>\n";
}

}  // namespace halfway::reports
