// What the charts of `run` are drawn with.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfway::reports::svg {

// Pixels: room for the numbers of an axis, for the title, between panels, and for a legend.
inline constexpr double kLeft = 84, kTop = 52, kGap = 66, kLegendWidth = 200;
inline constexpr double kPanelWidth = 520;

/// An axis from low to high in data, with round ticks 1, 2 or 5 times a power of ten apart.
struct Axis {
  double low = 0, high = 1, step = 1;

  Axis(double smallest, double largest);
  int ticks() const;
  double tick(int i) const;
  double fraction(double value) const { return (value - low) / (high - low); }
};

/// Two axes; `top` from the upper edge of the drawing, px.
struct Panel {
  Axis x, y;
  double top, width, height;
  double px(double value) const { return kLeft + width * x.fraction(value); }
  double py(double value) const { return top + height * (1 - y.fraction(value)); }
};

/// The drawing up to its title. Ends with "</svg>\n".
std::string begin(double width, double height, std::string_view title);

void draw_axes(std::string& out, const Panel& panel, std::string_view x_label, std::string_view y_label);

using Points = std::vector<std::pair<double, double>>;

/// In the colour and dash of the `curve`-th, counted from 0.
void draw_line(std::string& out, const Panel& panel, const Points& points, std::size_t curve,
               double opacity = 1);

/// Dots in the colour of the `curve`-th.
void draw_points(std::string& out, const Panel& panel, const Points& points, std::size_t curve);

/// The `labels` of the curves beside panels of kPanelWidth, and what height they take.
void draw_legend(std::string& out, const std::vector<std::string>& labels);
double legend_height(std::size_t labels);

}  // namespace halfway::reports::svg
