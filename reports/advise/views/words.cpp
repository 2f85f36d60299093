#include "reports/advise/views/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::advise {
namespace {

std::string envelope_text(const Advice& advice) {
  const double end = advice.envelope.end();
  std::string out = fmt::format("up to load factor {:.4g}", end);
  if (advice.envelope.rows <= advice.answers.value.size()) {
    if (const auto rotation = rotation_at(advice.answers, advice.envelope.rows - 1))
      out += fmt::format(", {:.3g} deg", *rotation / kDegree);
  }
  if (advice.envelope.is_cut) out += " (there the data end)";
  const auto& rows = advice.truth.rows;
  if (!rows.empty() && advice.envelope.rows == 1 && end == rows.front()) out += " (there the data begin)";
  return out;
}

/// The candidate that comes farthest within a tolerance, of those that nothing disqualifies on the way.
const Judged* farthest(const Advice& advice, double tolerance, Reach& reach) {
  const Judged* best = nullptr;
  for (const Judged& j : advice.judged) {
    // One that ends early is good up to there; another defect stays whatever the load.
    const bool out = !j.disqualified.empty() && !j.disqualified.starts_with("ends");
    if (out || j.by_theory || !(j.cost.ns > 0)) continue;
    const Reach own = reach_of(j.errors, advice.answers, tolerance);
    if (best == nullptr || own.factor > reach.factor) best = &j, reach = own;
  }
  return best;
}

std::string reach_text(const Reach& reach) {
  if (reach.rotation > 0) return fmt::format("{:.2g} deg", reach.rotation / kDegree);
  return fmt::format("load factor {:.3g}", reach.factor);
}

std::string instead_text(const Change& change) { return change.instead.empty() ? "none" : change.instead; }

std::string cost_text(const Judged& j) {
  return j.cost.ns > 0 ? fmt::format("{:.3g} ns", j.cost.ns) : std::string("no cost");
}

std::string load_margin(const Advice& advice) {
  const Margin& m = advice.margin;
  const auto at = [](const Change& c) {
    return c.rotation > 0 ? fmt::format("{:.3g} deg", c.rotation / kDegree)
                          : fmt::format("load factor {:.3g}", c.at);
  };
  std::string out = "load: ";
  out += m.less_load.beyond ? "the same from rest on"
                            : fmt::format("up to {} {}", at(m.less_load), instead_text(m.less_load));
  out += m.more_load.beyond ? fmt::format("; no other up to {}", at(m.more_load))
                            : fmt::format("; beyond {} {}", at(m.more_load), instead_text(m.more_load));
  return out;
}

std::string tolerance_margin(const Advice& advice) {
  const Margin& m = advice.margin;
  std::string out = "tolerance: ";
  out += m.tighter.beyond ? "no other however tight"
                          : fmt::format("below {} {}", percent(m.tighter.at), instead_text(m.tighter));
  out += m.looser.beyond ? "; no other however loose"
                         : fmt::format("; from {} on {}", percent(m.looser.at), instead_text(m.looser));
  return out;
}

std::string ratio_margin(const Advice& advice) {
  const Margin& m = advice.margin;
  if (m.ratio == 0) return "";
  std::string out = fmt::format("stiffness ratio (here {:.3g}): ", m.ratio);
  out += m.less_ratio.beyond ? fmt::format("no other down to {:.3g}", m.less_ratio.at)
                             : fmt::format("below {:.3g} {}", m.less_ratio.at, instead_text(m.less_ratio));
  out += m.more_ratio.beyond ? fmt::format("; no other up to {:.3g}", m.more_ratio.at)
                             : fmt::format("; above {:.3g} {}", m.more_ratio.at, instead_text(m.more_ratio));
  return "  " + out + "\n";
}

std::string waste_text(const Advice& advice) {
  const Judged& chosen = *advice.chosen();
  if (!advice.plain || *advice.plain == *advice.choice)
    return "  nothing wasted: every kind, digit and end of it is needed\n";
  const Judged& plain = advice.judged[*advice.plain];
  return fmt::format("  {} in full would cost {}: {:.0f} % of it for nothing\n",
                     plain.candidate.name(advice.truth.scene.joint.kind), cost_text(plain),
                     100 * (1 - chosen.cost.ns / plain.cost.ns));
}

/// The nearest that fail, and who is out, in two lines.
std::string others_text(const Advice& advice) {
  std::vector<std::string> cheaper, out;
  for (std::size_t i = 0; i < advice.judged.size(); ++i) {
    const Judged& j = advice.judged[i];
    const std::string name = j.candidate.name(advice.truth.scene.joint.kind);
    const bool is_cheaper = !advice.choice || i < *advice.choice;
    if (!j.disqualified.empty() && out.size() < 3 && j.error <= 10 * advice.question.tolerance)
      out.push_back(fmt::format("{} {}", name, j.disqualified));
    else if (is_cheaper && j.disqualified.empty() && j.error > advice.question.tolerance && j.cost.ns > 0)
      cheaper.push_back(fmt::format("{} {} ({})", name, percent(j.error), cost_text(j)));
  }
  std::string text;
  if (!cheaper.empty()) {
    const std::size_t most = 4, left = cheaper.size() > most ? cheaper.size() - most : 0;
    cheaper.resize(cheaper.size() - left);
    text += fmt::format("  {}: {}{}\n", advice.choice ? "cheaper, and not enough" : "not enough",
                        fmt::join(cheaper, ", "), left ? fmt::format(", {} more", left) : "");
  }
  if (!out.empty())
    text += fmt::format("  out whatever the {}: {}\n", word_for_error(advice), fmt::join(out, "; "));
  return text;
}

}  // namespace

std::string percent(double share) {
  if (!std::isfinite(share)) return "no number";
  return fmt::format("{:.2g} %", 100 * share);
}

const char* word_for_error(const Advice& advice) { return advice.has_truth() ? "error" : "distance"; }

std::string measured_in(const Advice& advice) {
  const auto& outputs = advice.truth.scene.outputs;
  const auto has = [&](const char* prefix) {
    return std::ranges::any_of(outputs, [&](const std::string& o) { return o.starts_with(prefix); });
  };
  if (advice.measure() == Measure::each) return fmt::format("in each of {}", fmt::join(outputs, ", "));
  return has("theta_") && has("u_") ? "in the norm of theta and of u"
         : has("u_")                ? "in the norm of u"
                                    : "in the norm of theta";
}

std::optional<double> known_to(const Advice& advice) {
  const auto rotation = rotation_at(advice.answers, advice.envelope.rows - 1);
  if (!(advice.answers.error > 0) || !(rotation.value_or(0) > 0)) return std::nullopt;
  return advice.answers.error / *rotation;
}

std::string reason(const Advice& advice) {
  const Candidate& c = advice.chosen()->candidate;
  const std::string name = c.formulation();
  if (!c.entry) {
    constexpr double kSmall = 0.1;  // rad
    const bool is_small = rotation_at(advice.answers, advice.envelope.rows - 1).value_or(0) < kSmall;
    return is_small ? "rotations are so small that no law of finite rotations is needed"
                    : "under this load alone the answer is nearly linear, while node a stays as it is";
  }
  if (free_shaft(advice.question))
    return "the shaft turns freely: its moments do not change as it spins, and it has no angle to jump";
  if (!c.variant.empty()) return "the first terms of the series of its angle suffice up to there";
  if (c.precision == "float") return "the tolerance asks for no more than seven digits";
  if (name.starts_with("attached") || name == "field_a" || name == "field_b")
    return "rotations are so small that the law may sit at a node";
  if (name == "rod4" || name == "rod34")
    return "the tolerance asks for the rod's own next order, which no half-way law has";
  if (c.entry->needs_xi) return "the body is not the same from either end: its frame is not half-way";
  if (name == "quaternion" || name == "fasse")
    return "a polynomial of quaternions: no angle is computed, and its measure is near enough";
  return fmt::format(
      "half-way laws are right to second order, and of those that come near enough none is cheaper by a "
      "tenth");
}

std::string instead_of_none(const Advice& advice) {
  std::string out;
  const double asked = advice.question.tolerance;
  for (const double tolerance : {asked, 0.01, 0.02, 0.05, 0.1, 0.2}) {
    if (tolerance < asked || (tolerance == asked && !out.empty())) continue;
    Reach reach;
    const Judged* best = farthest(advice, tolerance, reach);
    if (!best || reach.factor <= 0) continue;
    out += fmt::format("{}{}{} to {} ({})", out.empty() ? "" : "; ", tolerance == asked ? "" : "use ",
                       percent(tolerance), reach_text(reach),
                       best->candidate.name(advice.truth.scene.joint.kind));
    if (tolerance > asked && (reach.to_the_end || tolerance >= 0.05)) break;
  }
  if (advice.truth.kind == TruthKind::body || advice.truth.kind == TruthKind::table)
    out +=
        fmt::format("{}or identify a cubic term of its energy, or a nonlinear law", out.empty() ? "" : "; ");
  return out;
}

std::string remark(const Advice& advice, std::size_t i) {
  const Judged& j = advice.judged[i];
  if (advice.choice == i) return "advised";
  if (!j.disqualified.empty()) return j.disqualified;
  if (j.by_theory) return "by second-order theory";
  if (!(j.cost.ns > 0)) return "not timed";
  if (j.error <= advice.question.tolerance) return "suffices, and costs as much or more";
  return fmt::format("within it to {}", reach_text(j.reach));
}

std::string summary_text(const Advice& advice) {
  const Question& q = advice.question;
  std::string out = fmt::format("Truth: {}", advice.truth.described);
  if (const auto known = known_to(advice))
    out += fmt::format(", known to {}{}", percent(*known),
                       *known > q.tolerance ? ", which is less than was asked" : "");
  out += ".\n";
  out += fmt::format("Asked: within {} {}, {}; {} candidates.\n", percent(q.tolerance), measured_in(advice),
                     envelope_text(advice), advice.judged.size());
  if (const Judged* chosen = advice.chosen()) {
    out += fmt::format("Advice: {}, {}, {} {}: {}.\n", chosen->candidate.name(advice.truth.scene.joint.kind),
                       cost_text(*chosen), word_for_error(advice), percent(chosen->error), reason(advice));
    out += waste_text(advice);
  } else {
    out += advice.has_truth() ? "Advice: none suffices"
                              : "Advice: none: laws that may be right are farther apart than that";
    const std::string instead = instead_of_none(advice);
    out += (instead.empty() ? "" : ": " + instead) + ".\n";
  }
  out += others_text(advice);
  if (advice.choice)
    out += fmt::format("  {}\n  {}\n", load_margin(advice), tolerance_margin(advice)) + ratio_margin(advice);
  return out;
}

}  // namespace halfway::advise
