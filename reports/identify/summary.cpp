#include "reports/cli/streams.hpp"
#include "reports/identify/results.hpp"

#include "halfway/rotations/so3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reports {
namespace {

namespace id = reference::identify;

constexpr double kDegree = std::numbers::pi / 180;

/// "0.557 +- 0.004": as many digits as the interval leaves.
std::string with_interval(double value, double half) {
  if (!std::isfinite(half)) return "open";
  const double size = std::max(half, std::abs(value) * 1e-8);
  const int last = size > 0 ? int(std::floor(std::log10(size))) - 1 : -6;  // two digits of the interval
  const double unit = std::pow(10, last);
  const auto text = [&](double x) {
    const double rounded = std::round(x / unit) * unit;
    return last < 0 && last > -7 && std::abs(x) < 1e5
               ? fmt::format("{:.{}f}", rounded, -last)
               : fmt::format("{:.{}g}", x, std::max(2, int(std::ceil(std::log10(std::abs(x) / unit + 1)))));
  };
  return fmt::format("{} +- {}", text(value), half > 0 ? fmt::format("{:.2g}", half) : "0");
}

using Lines = std::vector<SummaryLine>;

void add(Lines& lines, const char* head, const std::string& text) {
  if (!text.empty()) lines.push_back({head, text});
}

std::string three(const id::Fit& fit, const Vec3<double>& values, int place, double factor,
                  bool is_relative) {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    const double half = fit.half_width(place + i) * (is_relative ? values[i] : factor);
    out += (i ? ", " : "") + with_interval(values[i], half);
  }
  return out;
}

std::string noise(const Identified& what) {
  std::string out;
  constexpr std::array<double, id::kChannels> kFactors = {1e3, 1 / kDegree, 1, 1};
  constexpr std::array<const char*, id::kChannels> kUnits = {"mm", "deg", "N", "N m"};
  std::array<bool, id::kChannels> is_there{};
  for (const int channel : id::channels(what.data)) is_there[std::size_t(channel)] = true;
  for (std::size_t c = 0; c < id::kChannels; ++c) {
    if (is_there[c])
      out +=
          fmt::format("{}{:.2g} {}", out.empty() ? "" : ", ", what.found.sigma[c] * kFactors[c], kUnits[c]);
  }
  return out;
}

/// "axis 1 (0.98, 0.17, 0)" ... of axes that are not the scene's, with the angle by which they are uncertain.
std::string axes_text(const Mat3<double>& axes, const id::Fit& fit, int place) {
  const double turn = so3::log(so3::quaternion<double>(axes)).norm();
  double half = 0;
  bool is_open = false;
  for (int i = 0; i < 3; ++i) {
    const double one = fit.half_width(place + i);
    is_open = is_open || !std::isfinite(one);
    half = std::isfinite(one) && one > half ? one : half;
  }
  if (half == 0 && is_open) return "open; taken along those of the data";
  const std::string sure = fmt::format("+- {:.2g} deg{}", half / kDegree, is_open ? ", in part open" : "");
  if (turn < 2 * half || turn < 1e-6) return fmt::format("those of the data, {}", sure);
  std::string out;
  for (int i = 0; i < 3; ++i) {
    const Vec3<double> axis = axes.col(i);
    out += fmt::format("{}({:.4g}, {:.4g}, {:.4g})", i ? ", " : "", axis[0] + 0., axis[1] + 0., axis[2] + 0.);
  }
  return out + ", " + sure;
}

std::string point_text(const Identified& what, const id::Fit& fit, const id::JointValues& v) {
  if (what.data.kind != Kind::linear_angular) return "";
  const double length = what.found.frame.length;
  double half = 0;
  for (int i = 0; i < 6; ++i)
    half = std::max(half, fit.is_active(id::kCoupling + i) ? fit.half_width(id::kCoupling + i) * length : 0);
  const double left = v.S.cwiseAbs().maxCoeff();
  return fmt::format("{} m from node b; coupling left there {:.2g} m +- {:.2g}{}",
                     three(fit, v.point, id::kJointPoint, length, false), left, half,
                     left <= 2 * half ? " (none)" : "");
}

constexpr std::array<const char*, 3> kPairs = {"2-3", "1-3", "1-2"};

std::string pairs_text(const id::Fit& fit, const Vec3<double>& xi, int place) {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    if (fit.is_active(place + i))
      out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", kPairs[std::size_t(i)],
                         with_interval(xi[i], fit.half_width(place + i)));
  }
  return out;
}

/// Of six strains: one number for moments, one for forces.
std::string two_xi_text(const Identified& what) {
  const id::StageFit& two = what.found.stage(id::Stage::two_xi);
  if (two.stage != id::Stage::two_xi) return "";
  std::string out;
  for (const auto& [place, of] : {std::pair{id::kXiAngular, "moments"}, {id::kXiLinear, "forces"}}) {
    if (two.fit.is_active(place))
      out += fmt::format("{}{}: {}", out.empty() ? "; " : ", ", of,
                         with_interval(two.fit.p[place], two.fit.half_width(place)));
  }
  return out;
}

std::string one_xi_text(const Identified& what) {
  const id::StageFit& one = what.found.stage(id::Stage::one_xi);
  if (one.stage != id::Stage::one_xi || !one.fit.is_active(id::kXiAngular)) return "";
  const double xi = one.fit.p[id::kXiAngular];
  const std::string serves =
      one.probability >= id::kRejected ? "serves all pairs of axes" : "does not serve all pairs of axes";
  return fmt::format("{}; one number {} (p = {:.2g}){}",
                     with_interval(xi, one.fit.half_width(id::kXiAngular)), serves, one.probability,
                     two_xi_text(what));
}

std::string cubic_text(const Identified& what) {
  const id::StageFit& cubic = what.found.stage(id::Stage::cubic);
  if (cubic.stage != id::Stage::cubic || !cubic.fit.is_active(id::kCubic)) return "";
  const id::JointValues v = what.found.values(cubic.fit);
  const double half = cubic.fit.half_width(id::kCubic) * v.angular.mean();
  return fmt::format("{} N m/rad^2 of the energy c theta_1 theta_2 theta_3: {} (p = {:.2g})",
                     with_interval(v.cubic, half),
                     cubic.probability >= id::kRejected ? "serves, and is conservative" : "does not serve",
                     cubic.probability);
}

std::string axis_laws_text(const Identified& what) {
  const id::StageFit& one = what.found.chosen_stage();
  if (one.stage != id::Stage::axis_laws) return "";
  const id::JointValues v = what.found.values(one.fit);
  const id::Frame& frame = what.found.frame;
  const auto is_told = [&](int place) { return std::abs(one.fit.p[place]) > one.fit.half_width(place); };
  std::string out;
  for (int i = 0; i < 3; ++i) {
    const double unit = v.angular[i] / (frame.turn * frame.turn),
                 other = v.linear[i] / (frame.reach * frame.reach);
    if (is_told(id::kAngularCube + i))
      out += fmt::format("{}about {}: {} N m/rad^3", out.empty() ? "" : ", ", i + 1,
                         with_interval(v.angular_cube[i], unit * one.fit.half_width(id::kAngularCube + i)));
    if (is_told(id::kLinearCube + i))
      out += fmt::format("{}along {}: {} N/m^3", out.empty() ? "" : ", ", i + 1,
                         with_interval(v.linear_cube[i], other * one.fit.half_width(id::kLinearCube + i)));
  }
  return "k1 e + k3 e^3, k3 " + out;
}

std::string catalog_text(const Identified& what) {
  const id::Identification& found = what.found;
  if (found.best < 0) return "";
  const id::CatalogFit& best = found.catalog[std::size_t(found.best)];
  std::string also;
  int alike = 0;
  for (const id::CatalogFit& one : found.catalog) {
    if (&one == &best || !one.left_out.empty() || one.probability < id::kRejected) continue;
    if (++alike <= 4) also += (also.empty() ? "" : ", ") + one.name;
  }
  if (alike > 4) also += fmt::format(" and {} more", alike - 4);
  const std::string xi =
      best.name == "intrinsic" ? fmt::format(" xi = {:.4g}", found.values(best.fit).xi_angular[0]) : "";
  const char* verdict = best.probability >= id::kRejected ? "" : "none; nearest ";
  return fmt::format("{}{}{}: {:.3g} times the scatter{}", verdict, best.name, xi, best.error,
                     also.empty() ? "" : "; as good within it: " + also);
}

std::string conservative_text(const Identified& what) {
  const id::Identification& found = what.found;
  if (found.best_conservative < 0) return "";
  const id::CatalogFit &best = found.catalog[std::size_t(found.best)],
                       &other = found.catalog[std::size_t(found.best_conservative)];
  if (&best == &other) return fmt::format("{}: it is the best", other.name);
  const auto here = channel_errors(what.data, other.fit), there = channel_errors(what.data, best.fit);
  std::string costs;
  for (std::size_t c = 0; c < id::kChannels; ++c) {
    if (std::isfinite(here[c]))
      costs += fmt::format("{}{} {:.2g} {} off instead of {:.2g}", costs.empty() ? "" : ", ",
                           id::kChannelNames[c], here[c], id::kChannelUnits[c], there[c]);
  }
  return fmt::format("{}: {:.3g} times the scatter; {}", other.name, other.error, costs);
}

/// "xi of moments 2-3, xi of moments 1-3" as "xi of moments 2-3, 1-3": what names have in common is said
/// once.
std::string shorter(const std::vector<std::string>& names) {
  std::string out, before;
  for (const std::string& name : names) {
    const std::size_t last = name.find_last_of(' ');
    const std::string begin = name.substr(0, last);
    out += begin == before ? ", " + name.substr(last + 1) : (out.empty() ? "" : "; ") + name;
    before = begin;
  }
  return out;
}

/// One line a reason.
void add_open(Lines& lines, const Identified& what) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;  // reason, names
  for (const id::LeftOpen& one : what.found.left_open) {
    const auto at = std::find_if(by_reason.begin(), by_reason.end(),
                                 [&](const auto& pair) { return pair.first == one.reason; });
    if (at == by_reason.end())
      by_reason.push_back({one.reason, {one.what}});
    else
      at->second.push_back(one.what);
  }
  for (const auto& [reason, names] : by_reason)
    add(lines, "not identified", fmt::format("{}: {}", shorter(names), reason));
}

}  // namespace

std::string summary_head(const Identified& what) {
  std::size_t rows = 0;
  for (const id::LoadCase& one : what.data.cases) rows += one.loads.size();
  return fmt::format("{}: {} joint, {} case{}, {} rows, {} numbers; scatter {}; intervals of 95 %",
                     printable(what.source), to_string(what.data.kind), what.data.cases.size(),
                     what.data.cases.size() == 1 ? "" : "s", rows, id::measured_count(what.data),
                     noise(what));
}

std::vector<SummaryLine> summary_lines(const Identified& what) {
  const id::Identification& found = what.found;
  const id::Fit& fit = found.chosen_stage().fit;
  const id::JointValues v = found.values(fit);
  const bool turns = what.data.kind != Kind::linear, moves = what.data.kind != Kind::angular;
  const id::Fit& rich = found.stage(id::Stage::per_pair).fit;
  const id::JointValues pairs = found.values(rich);
  Lines out;
  if (turns)
    add(out, "stiffness about axes", three(fit, v.angular, id::kAngularStiffness, 1, true) + " N m/rad");
  if (turns) add(out, "axes", axes_text(v.H, fit, id::kAngularAxes));
  if (moves) add(out, "stiffness along axes", three(fit, v.linear, id::kLinearStiffness, 1, true) + " N/m");
  if (moves) add(out, "their axes", axes_text(Mat3<double>(v.H * v.E), fit, id::kLinearAxes));
  add(out, "joint point", point_text(what, fit, v));
  add(out, "xi", one_xi_text(what));
  add(out, "xi of moments", pairs_text(rich, pairs.xi_angular, id::kXiAngular));
  add(out, "xi of forces", pairs_text(rich, pairs.xi_linear, id::kXiLinear));
  add(out, "cubic term", cubic_text(what));
  add(out, "curved laws", axis_laws_text(what));
  add_open(out, what);
  add(out, "fits best", catalog_text(what));
  add(out, "conservative", conservative_text(what));
  return out;
}

std::string identify_summary(const Identified& what) {
  std::string out = summary_head(what) + "\n";
  for (const auto& [name, text] : summary_lines(what)) out += fmt::format("  {:<22}{}\n", name, text);
  return out;
}

}  // namespace halfway::reports
