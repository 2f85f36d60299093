#include "reports/cli/run/run_chart.hpp"

#include "reports/cli/run/run_files.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace halfway::reports {
namespace {

// Pixels of the drawing.
constexpr double kPanelWidth = 520, kPanelHeight = 200, kLeft = 84, kTop = 52, kGap = 66, kLegendWidth = 200;

/// Okabe and Ito's colours: told apart with any colour vision; dashes when they run out.
constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
constexpr std::array kDashes = {"none", "7 3", "2 3"};

/// XML 1.0 has no way to write control characters: shown as a person would write them.
std::string escaped(std::string_view text) {
  std::string out;
  for (char c : printable(text)) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string stroke(std::size_t curve) {
  return fmt::format(R"(stroke="{}" stroke-dasharray="{}")", kColours[curve % kColours.size()],
                     kDashes[curve / kColours.size() % kDashes.size()]);
}

/// An axis from low to high in data, with round ticks 1, 2 or 5 times a power of ten apart.
struct Axis {
  double low = 0, high = 1, step = 1;

  Axis(double smallest, double largest) : low(smallest), high(largest) {
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
  int ticks() const { return int(std::lround((high - low) / step)); }
  double tick(int i) const {
    const double value = low + i * step;
    return std::abs(value) < step / 2 ? 0 : value;  // no -1e-17
  }
  double fraction(double value) const { return (value - low) / (high - low); }
};

Axis axis_of(const std::vector<reference::Curve>& curves, std::size_t column) {
  double low = 0, high = 0;
  for (const auto& curve : curves) {
    for (const auto& row : curve.rows) {
      low = std::min(low, row[column]);
      high = std::max(high, row[column]);
    }
  }
  return {low, high};
}

std::string_view unit_of(std::string_view column) {
  if (column.starts_with("theta")) return " (rad)";
  return column.starts_with("u_") ? " (m)" : "";
}

struct Panel {
  Axis x, y;
  double top;
  double px(double value) const { return kLeft + kPanelWidth * x.fraction(value); }
  double py(double value) const { return top + kPanelHeight * (1 - y.fraction(value)); }
};

void draw_axes(std::string& out, const Panel& panel, const std::string& label) {
  const auto add = std::back_inserter(out);
  for (int i = 0; i <= panel.x.ticks(); ++i) {
    const double at = panel.px(panel.x.tick(i));
    fmt::format_to(add, "<path class=\"grid\" d=\"M{0:.2f} {1:.2f}V{2:.2f}\"/>\n", at, panel.top,
                   panel.top + kPanelHeight);
    fmt::format_to(add, "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{:g}</text>\n", at,
                   panel.top + kPanelHeight + 17, panel.x.tick(i));
  }
  for (int i = 0; i <= panel.y.ticks(); ++i) {
    const double at = panel.py(panel.y.tick(i));
    fmt::format_to(add, "<path class=\"grid\" d=\"M{:.2f} {:.2f}H{:.2f}\"/>\n", kLeft, at,
                   kLeft + kPanelWidth);
    fmt::format_to(add, "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"end\">{:g}</text>\n", kLeft - 7,
                   at + 4, panel.y.tick(i));
  }
  fmt::format_to(add, "<path class=\"axis\" d=\"M{0:.2f} {1:.2f}V{2:.2f}H{3:.2f}\"/>\n", kLeft, panel.top,
                 panel.top + kPanelHeight, kLeft + kPanelWidth);
  fmt::format_to(add, "<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">load factor</text>\n",
                 kLeft + kPanelWidth / 2, panel.top + kPanelHeight + 36);
  fmt::format_to(
      add,
      "<text x=\"18\" y=\"{0:.2f}\" text-anchor=\"middle\" transform=\"rotate(-90 18 {0:.2f})\">{1}"
      "</text>\n",
      panel.top + kPanelHeight / 2, escaped(label));
}

void draw_curves(std::string& out, const Panel& panel, const std::vector<reference::Curve>& curves,
                 std::size_t column) {
  const auto add = std::back_inserter(out);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    out += "<polyline class=\"curve\" points=\"";
    for (const auto& row : curves[i].rows) {
      fmt::format_to(add, "{:.2f},{:.2f} ", panel.px(row[0]), panel.py(row[column]));
    }
    fmt::format_to(add, "\" {}/>\n", stroke(i));
  }
}

void draw_legend(std::string& out, const std::vector<reference::Curve>& curves) {
  const double x = kLeft + kPanelWidth + 22;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double y = kTop + 8 + 18 * double(i);
    const char* early = curves[i].converged ? "" : " (ends early)";
    fmt::format_to(std::back_inserter(out),
                   "<path class=\"curve\" d=\"M{:.2f} {:.2f}h26\" {}/>\n<text x=\"{:.2f}\" y=\"{:.2f}\">{}{}"
                   "</text>\n",
                   x, y, stroke(i), x + 33, y + 4, escaped(curve_label(curves[i])), early);
  }
}

}  // namespace

std::string curves_svg(const reference::Scene& scene, const std::vector<reference::Curve>& curves) {
  const std::size_t panels = scene.outputs.size();
  const double width = kLeft + kPanelWidth + 22 + 33 + kLegendWidth;
  const double height =
      std::max(kTop + double(panels) * (kPanelHeight + kGap), kTop + 18 * double(curves.size()) + 20);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\">\n"
      "<style>text{{font:12px sans-serif;fill:#222}}.title{{font-size:15px;font-weight:bold}}"
      ".grid{{stroke:#ddd;fill:none}}.axis{{stroke:#222;fill:none}}.curve{{fill:none;stroke-width:1.8}}</"
      "style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<text class=\"title\" x=\"{2:g}\" y=\"28\">{3}</text>\n",
      width, height, kLeft, escaped(scene.title));
  for (std::size_t i = 0; i < panels; ++i) {
    const Panel panel{axis_of(curves, 0), axis_of(curves, i + 1), kTop + double(i) * (kPanelHeight + kGap)};
    draw_axes(out, panel, fmt::format("{}{}", scene.outputs[i], unit_of(scene.outputs[i])));
    draw_curves(out, panel, curves, i + 1);
  }
  draw_legend(out, curves);
  return out + "</svg>\n";
}

}  // namespace halfway::reports
