#include "reports/cli/run/summary.hpp"

#include "reports/cli/run/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace halfway::reports {
namespace {

using reference::Curve;

/// More groups than these are named, without their answers.
constexpr std::size_t kMostGroups = 9;

constexpr const char* kIndent = "  ";

std::string joined(const std::vector<Curve>& curves, const std::vector<std::size_t>& at) {
  std::string out;
  for (std::size_t i : at) out += (out.empty() ? "" : ", ") + curve_label(curves[i]);
  return out;
}

std::string percent(double share) {
  return share < 0.1 ? fmt::format("{:.1g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

std::string first_line(const reference::SceneHead& scene, const std::vector<Curve>& curves,
                       const Comparison& comparison) {
  const auto all = std::ranges::count_if(curves, is_formulation);
  const auto arrived =
      std::ranges::count_if(curves, [](const Curve& c) { return is_formulation(c) && c.converged; });
  std::string out = fmt::format("{}: reached by {} of {} formulation{}",
                                scene.is_in_time ? fmt::format("Time {:g} s", scene.factor_end)
                                                 : fmt::format("Load factor {:g}", scene.factor_end),
                                arrived, all, all == 1 ? "" : "s");
  if (comparison.answers == 1 && arrived > 1)
    out += fmt::format(", which agree to {:g} % of the answer", 100 * kAgree);
  if (comparison.answers > 1)
    out += fmt::format("; {} answers more than {:g} % apart, up to {}", comparison.answers, 100 * kAgree,
                       percent(comparison.apart));
  return out + "\n";
}

/// Of all columns but the load factor, each two blanks from the one before.
std::vector<std::string> heads_of(const std::vector<std::string>& columns) {
  std::vector<std::string> out;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const std::string_view unit = reference::unit_of_output(columns[i]);
    out.push_back(fmt::format("  {}{}{}", columns[i], unit.empty() ? "" : ", ", unit));
  }
  return out;
}

std::string group_lines(const std::vector<Curve>& curves, const Comparison& comparison) {
  if (comparison.groups.empty()) return "";
  std::string out = kIndent;
  const auto heads = heads_of(curves.front().columns);
  for (const std::string& head : heads) out += fmt::format("{:>14}", head);
  out += "    error   within  formulations\n";
  std::string others;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const auto& [members, answer, apart, error] = comparison.groups[g];
    if (g >= kMostGroups) {
      others += (others.empty() ? "" : "; ") + joined(curves, members);
      continue;
    }
    out += kIndent;
    for (std::size_t i = 0; i < answer.size(); ++i)
      out += fmt::format("{:>{}.5g}", answer[i], std::max<std::size_t>(14, heads[i].size()));
    out += fmt::format("{:>9}{:>9}  {}\n", error ? fmt::format("{:.0e}", *error) : "-",
                       members.size() > 1 ? percent(apart) : "-", joined(curves, members));
  }
  return others.empty() ? out : fmt::format("{}{}other answers: {}\n", out, kIndent, others);
}

std::string ended_lines(const std::vector<Curve>& curves, const Comparison& comparison) {
  std::string out;
  for (const auto& [cause, members] : comparison.ended) {
    out += kIndent;
    for (std::size_t i : members) {
      const bool is_first = i == members.front();
      fmt::format_to(std::back_inserter(out), "{}{} ends at {:.6g}", is_first ? "" : ", ",
                     curve_label(curves[i]), curves[i].rows.empty() ? 0 : curves[i].rows.back()[0]);
    }
    out += fmt::format(": {}\n", cause);
  }
  return out;
}

/// "critical moment about joint axis 1, N m: 265.1 jointc; 415.2 attached_b, chrono_body; none: attached_a".
std::string critical_line(const reference::SceneHead& scene, const std::vector<Curve>& curves) {
  if (scene.critical_axis == 0) return "";
  std::map<double, std::pair<std::string, std::string>> found;  // moment -> its text, names
  std::string none;
  const auto add = [](std::string& names, const Curve& curve) {
    names += (names.empty() ? "" : ", ") + curve_label(curve);
  };
  for (const Curve& curve : curves) {
    if (!is_formulation(curve)) continue;
    if (!curve.critical) {
      add(none, curve);
      continue;
    }
    const std::string text = fmt::format("{:.5g}", double(curve.critical->moment));
    auto& [shown, names] = found[std::stod(text)];
    shown = text;
    add(names, curve);
  }
  std::string out = fmt::format("{}critical moment about joint axis {}, N m:", kIndent, scene.critical_axis);
  for (const auto& [moment, text] : found) out += fmt::format(" {} {};", text.first, text.second);
  out += none.empty() ? "" : fmt::format(" none: {}", none);
  if (out.ends_with(';')) out.pop_back();
  return out + "\n";
}

std::string left_out_line(const std::vector<NotRun>& left_out) {
  if (left_out.empty()) return "";
  std::string out;
  for (const auto& [name, reason] : left_out)
    out += fmt::format("{}{} {}", out.empty() ? "" : "; ", name, reason);
  return fmt::format("{}left out: {}\n", kIndent, out);
}

}  // namespace

std::string summary_text(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves,
                         const std::vector<NotRun>& left_out) {
  if (curves.empty()) return "";
  const Comparison comparison = compared(curves);
  return first_line(scene, curves, comparison) + group_lines(curves, comparison) +
         ended_lines(curves, comparison) + critical_line(scene, curves) + left_out_line(left_out);
}

}  // namespace halfway::reports
