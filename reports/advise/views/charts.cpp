#include "reports/advise/views/charts.hpp"

#include "reports/advise/views/words.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::advise {
namespace {

using reports::escaped;

constexpr double kWidth = 760, kHeight = 420, kLeftEdge = 74, kTopEdge = 16, kBottomEdge = 46,
                 kRightEdge = 16;

/// A logarithmic axis onto pixels.
struct LogAxis {
  double low, high, from, to;
  double at(double x) const {
    return from + (to - from) * std::log(std::clamp(x, low, high) / low) / std::log(high / low);
  }
};

std::string begin_svg(const std::string& label) {
  return fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" class=\"advice-chart\">\n",
                     kWidth, kHeight, escaped(label));
}

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const char* kind = "tick") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n", x, y,
                     anchor, kind, escaped(text));
}

std::string axis_titles(const std::string& x, const std::string& y) {
  return text_at((kLeftEdge + kWidth - kRightEdge) / 2, kHeight - 8, "middle", x, "axis-title") +
         fmt::format(
             "<text transform=\"translate(16 {:.0f}) rotate(-90)\" text-anchor=\"middle\" "
             "class=\"axis-title\">{}</text>\n",
             kHeight / 2, escaped(y));
}

struct Extremes {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void include(double x) {
    if (x > 0 && std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
  }
};

constexpr double kLeastError = 1e-9;  // below: rounding, of no interest in an advice

bool is_drawn(const Judged& j) { return j.cost.ns > 0 && std::isfinite(j.error); }

std::string mark_of(const Advice& advice, std::size_t i, const LogAxis& x, const LogAxis& y) {
  const Judged& j = advice.judged[i];
  const bool chosen = advice.choice == i;
  const double cx = x.at(j.cost.ns), cy = y.at(std::max(j.error, kLeastError));
  const std::string name = j.candidate.name(advice.truth.scene.joint.kind);
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" data-law=\"{}\" class=\"{}\"><title>{}: {:.3g} ns, {} "
      "{}; {}</title></circle>\n",
      cx, cy, chosen ? 8 : 5, escaped(j.candidate.formulation()),
      j.disqualified.empty() ? "mark" : "mark hollow", escaped(name), j.cost.ns, word_for_error(advice),
      percent(j.error), escaped(remark(advice, i)));
}

/// Names, from the cheapest on, where no other stands.
std::string labels_of(const Advice& advice, const LogAxis& x, const LogAxis& y) {
  std::string out;
  std::vector<std::pair<double, double>> taken;
  const auto put = [&](std::size_t i) {
    const Judged& j = advice.judged[i];
    const double tx = x.at(j.cost.ns), ty = y.at(std::max(j.error, kLeastError)) - 9;
    const bool free = std::ranges::none_of(
        taken, [&](const auto& t) { return std::abs(t.first - tx) < 95 && std::abs(t.second - ty) < 13; });
    if (!free) return;
    taken.emplace_back(tx, ty);
    out += text_at(tx, ty, tx > kWidth - 130 ? "end" : "middle",
                   j.candidate.name(advice.truth.scene.joint.kind), "mark-label");
  };
  if (advice.choice) put(*advice.choice);
  for (std::size_t i = 0; i < advice.judged.size(); ++i)
    if (is_drawn(advice.judged[i])) put(i);
  return out;
}

std::string decades(const LogAxis& x, const LogAxis& y) {
  std::string out;
  for (int n = -9; n <= 1; ++n) {
    const double value = std::pow(10., n);
    if (value < y.low * 0.999 || value > y.high * 1.001) continue;
    out += fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\" class=\"grid-line\"/>\n",
                       kLeftEdge, kWidth - kRightEdge, y.at(value), y.at(value));
    out += text_at(kLeftEdge - 6, y.at(value) + 4, "end", percent(value));
  }
  for (const double value : {1., 2., 5., 10., 20., 50., 100., 200., 500., 1000., 2000., 5000.}) {
    if (value < x.low || value > x.high) continue;
    out += fmt::format("<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\" class=\"grid-line\"/>\n",
                       x.at(value), x.at(value), kTopEdge, kHeight - kBottomEdge);
    out += text_at(x.at(value), kHeight - kBottomEdge + 17, "middle", fmt::format("{:g}", value));
  }
  return out;
}

constexpr double kMapDegrees[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100};

}  // namespace

std::string evidence_svg(const Advice& advice) {
  Extremes costs, errors;
  errors.include(advice.question.tolerance);
  for (const Judged& j : advice.judged)
    if (is_drawn(j)) costs.include(j.cost.ns), errors.include(std::max(j.error, kLeastError));
  if (!(costs.high > 0)) return "";
  const LogAxis x{costs.low / 1.3, costs.high * 1.3, kLeftEdge, kWidth - kRightEdge};
  const LogAxis y{errors.low / 2, std::min(errors.high, 10.) * 2, kHeight - kBottomEdge, kTopEdge};
  std::string out = begin_svg("Error against cost of every candidate") + decades(x, y);
  const double line = y.at(advice.question.tolerance);
  out += fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\" class=\"limit\"/>\n", kLeftEdge,
                     kWidth - kRightEdge, line, line);
  out += text_at(kWidth - kRightEdge, line - 5, "end", "tolerance " + percent(advice.question.tolerance),
                 "mark-label");
  for (std::size_t i = 0; i < advice.judged.size(); ++i)
    if (is_drawn(advice.judged[i])) out += mark_of(advice, i, x, y);
  out += labels_of(advice, x, y);
  out += axis_titles("ns of loads and tangent, this machine",
                     advice.has_truth() ? "error" : "distance to the farthest admissible law");
  return out + "</svg>\n";
}

std::string map_svg(const Advice& advice, const std::vector<MapColumn>& columns) {
  if (columns.empty()) return "";
  double most = kMapLeast;
  for (const MapColumn& column : columns) most = std::max(most, column.pieces.back().to);
  const LogAxis y{kMapLeast, most, kHeight - kBottomEdge, kTopEdge};
  const double width = (kWidth - kRightEdge - kLeftEdge) / double(columns.size());
  std::string out = begin_svg("The cheapest law that suffices, by rotation and stiffness ratio");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double left = kLeftEdge + width * double(i);
    double from = kMapLeast;
    for (const MapPiece& piece : columns[i].pieces) {
      const double top = y.at(piece.to), bottom = y.at(from);
      out += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {} class=\"{}\"><title>ratio "
          "{:g}, {:.3g} to {:.3g} deg: {}</title></rect>\n",
          left + 1, top, width - 2, std::max(0., bottom - top - 1),
          piece.name.empty() ? "" : fmt::format("data-law=\"{}\"", escaped(piece.formulation)),
          piece.name.empty() ? "map none" : "map", columns[i].ratio, from / kDegree, piece.to / kDegree,
          piece.name.empty() ? "none suffices" : escaped(piece.name));
      if (bottom - top > 15)
        out += text_at(left + width / 2, (top + bottom) / 2 + 4, "middle",
                       piece.name.empty() ? "none" : piece.formulation,
                       piece.name.empty() ? "tick" : "map-label");
      from = piece.to;
    }
    out += text_at(left + width / 2, kHeight - kBottomEdge + 17, "middle",
                   fmt::format("{:g}", columns[i].ratio));
  }
  for (const double degrees : kMapDegrees)
    if (degrees * kDegree >= kMapLeast && degrees * kDegree <= most)
      out += text_at(kLeftEdge - 6, y.at(degrees * kDegree) + 4, "end", fmt::format("{:g}", degrees));
  return out +
         axis_titles("largest over smallest stiffness",
                     fmt::format("rotation, deg, within {}", percent(advice.question.tolerance))) +
         "</svg>\n";
}

std::string map_csv(const std::vector<MapColumn>& columns) {
  std::string out = "ratio,from_deg,to_deg,advised\n";
  for (const MapColumn& column : columns) {
    double from = kMapLeast;
    for (const MapPiece& piece : column.pieces) {
      out += fmt::format("{:g},{:.6g},{:.6g},{}\n", column.ratio, from / kDegree, piece.to / kDegree,
                         piece.name);
      from = piece.to;
    }
  }
  return out;
}

}  // namespace halfway::advise
