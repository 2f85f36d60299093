#include "reports/cli/run/svg.hpp"

#include "reports/cli/streams.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

namespace halfway::reports::svg {
namespace {

/// Okabe and Ito's colours: told apart with any colour vision; dashes when they run out.
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
constexpr std::array kDashes = {"none", "7 3", "2 3"};

constexpr double kLegendRow = 18;

std::string stroke(std::size_t curve) {
  return fmt::format(R"(stroke="{}" stroke-dasharray="{}")", kColours[curve % kColours.size()],
                     kDashes[curve / kColours.size() % kDashes.size()]);
}

}  // namespace

Axis::Axis(double smallest, double largest) : low(smallest), high(largest) {
  if (!(high > low)) {
    const double margin = low == 0 ? 1 : 0.5 * std::abs(low);
    low -= margin;
    high += margin;
  }
  const double rough = (high - low) / 5;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double mantissa = rough / decade;
  step = decade * (mantissa > 5 ? 10 : mantissa > 2 ? 5 : mantissa > 1 ? 2 : 1);
  low = std::floor(low / step) * step;
  high = std::ceil(high / step) * step;
}

int Axis::ticks() const { return int(std::lround((high - low) / step)); }

double Axis::tick(int i) const {
  const double value = low + i * step;
  return std::abs(value) < step / 2 ? 0 : value;  // no -1e-17
}

std::string begin(double width, double height, std::string_view title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\">\n"
      "<style>text{{font:12px sans-serif;fill:#222}}.title{{font-size:15px;font-weight:bold}}"
      ".grid{{stroke:#ddd;fill:none}}.axis{{stroke:#222;fill:none}}.curve{{fill:none;stroke-width:1.8}}</"
      "style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<text class=\"title\" x=\"{2:g}\" y=\"28\">{3}</text>\n",
      width, height, kLeft, escaped(title));
}

void draw_axes(std::string& out, const Panel& panel, std::string_view x_label, std::string_view y_label) {
  const auto add = std::back_inserter(out);
  const double bottom = panel.top + panel.height, right = kLeft + panel.width;
  for (int i = 0; i <= panel.x.ticks(); ++i) {
    const double at = panel.px(panel.x.tick(i));
    fmt::format_to(add, "<path class=\"grid\" d=\"M{0:.2f} {1:.2f}V{2:.2f}\"/>\n", at, panel.top, bottom);
    fmt::format_to(add, "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{:g}</text>\n", at,
                   bottom + 17, panel.x.tick(i));
  }
  for (int i = 0; i <= panel.y.ticks(); ++i) {
    const double at = panel.py(panel.y.tick(i));
    fmt::format_to(add, "<path class=\"grid\" d=\"M{:.2f} {:.2f}H{:.2f}\"/>\n", kLeft, at, right);
    fmt::format_to(add, "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"end\">{:g}</text>\n", kLeft - 7,
                   at + 4, panel.y.tick(i));
  }
  fmt::format_to(add, "<path class=\"axis\" d=\"M{0:.2f} {1:.2f}V{2:.2f}H{3:.2f}\"/>\n", kLeft, panel.top,
                 bottom, right);
  fmt::format_to(add, "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{}</text>\n",
                 kLeft + panel.width / 2, bottom + 36, escaped(x_label));
  fmt::format_to(
      add,
      "<text x=\"18\" y=\"{0:.2f}\" text-anchor=\"middle\" transform=\"rotate(-90 18 {0:.2f})\">{1}"
      "</text>\n",
      panel.top + panel.height / 2, escaped(y_label));
}

void draw_line(std::string& out, const Panel& panel, const Points& points, std::size_t curve,
               double opacity) {
  const auto add = std::back_inserter(out);
  out += "<polyline class=\"curve\" points=\"";
  for (const auto& [x, y] : points) fmt::format_to(add, "{:.2f},{:.2f} ", panel.px(x), panel.py(y));
  fmt::format_to(add, "\" {}{}/>\n", stroke(curve),
                 opacity < 1 ? fmt::format(" opacity=\"{:g}\"", opacity) : "");
}

void draw_points(std::string& out, const Panel& panel, const Points& points, std::size_t curve) {
  for (const auto& [x, y] : points)
    fmt::format_to(std::back_inserter(out), "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.5\" fill=\"{}\"/>\n",
                   panel.px(x), panel.py(y), kColours[curve % kColours.size()]);
}

void draw_legend(std::string& out, const std::vector<std::string>& labels) {
  const double x = kLeft + kPanelWidth + 22;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double y = kTop + 8 + kLegendRow * double(i);
    fmt::format_to(
        std::back_inserter(out),
        "<path class=\"curve\" d=\"M{:.2f} {:.2f}h26\" {}/>\n<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", x,
        y, stroke(i), x + 33, y + 4, escaped(labels[i]));
  }
}

double legend_height(std::size_t labels) { return kLegendRow * double(labels) + 20; }

}  // namespace halfway::reports::svg
