#include "reports/advise/core/advice.hpp"

#include "reference/solve/free_directions.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::advise {
namespace {

void refuse_unanswerable(const Question& question) {
  if (!(question.tolerance > 0 && question.tolerance < 1))
    throw reports::BadInput(
        fmt::format("--tolerance {:g}: allowed: above 0 and below 1, relative", question.tolerance));
  if (question.degrees && !(*question.degrees > 0 && *question.degrees < 180))
    throw reports::BadInput(fmt::format("--degrees {:g}: allowed: above 0 and below 180", *question.degrees));
  if (!(question.periods >= 0 && std::isfinite(question.periods)))
    throw reports::BadInput(fmt::format("--periods {:g}: allowed: 0 or more", question.periods));
  if (const auto why = reference::works_on_free_direction(question.scene))
    throw reports::BadInput(fmt::format("{}: no equilibrium: {}", question.scene.name, *why));
}

/// What a cautious user takes: the chosen formulation of the scene's kind in double, every digit, with ends.
std::optional<std::size_t> plain_of(const Advice& advice) {
  const Candidate& chosen = advice.chosen()->candidate;
  for (std::size_t i = 0; i < advice.judged.size(); ++i) {
    const Candidate& c = advice.judged[i].candidate;
    const bool same = chosen.entry ? c.entry == chosen.entry : c.entry && c.entry->name == "invariant";
    if (same && c.kind == advice.truth.scene.joint.kind && c.precision == "double" && c.variant.empty() &&
        c.ends && advice.judged[i].cost.ns > 0 && (c.xi == chosen.xi || !chosen.entry))
      return i;
  }
  return std::nullopt;
}

/// The scene up to about where the rotation asked for lies, by the linear analysis: which data serve it.
reference::Scene up_to_degrees(const Question& question) {
  reference::Scene out = question.scene;
  if (!question.degrees) return out;
  const Answers linear = follow(out, {nullptr, 0.5, false, out.joint.kind}, {1});
  const double turned = rotation_at(linear, 0).value_or(0);
  if (turned > 0) out.factor_end = *question.degrees * std::numbers::pi / 180 / turned;
  return out;
}

}  // namespace

std::map<std::string, Cost> costs_of(const reference::Scene& scene) {
  const auto candidates = candidates_of(scene);
  if (!std::holds_alternative<reference::LinearSpec>(scene.joint.law)) return face_costs(scene, candidates);
  auto all = candidates;
  if (const auto* intrinsic = reference::find_formulation("intrinsic"))
    all.push_back({intrinsic, 0.4, true, scene.joint.kind});
  return kernel_costs(all);
}

void answer(Advice& out, const std::map<std::string, Cost>& costs) {
  out.judged = judge(out.question, out.truth, out.answers, out.envelope, out.measure(), costs);
  out.choice = choose(out.judged, out.question.tolerance);
  out.plain = out.choice ? plain_of(out) : std::nullopt;
}

Advice asked(const Question& question) {
  refuse_unanswerable(question);
  Advice out{question, truth_of(up_to_degrees(question), question.truth)};
  out.envelope = envelope_of(question, out.truth);
  out.answers = leading(out.truth, out.envelope.factors);
  if (out.answers.value.size() < out.envelope.rows)
    throw reports::BadInput(fmt::format(
        "scene {}: {} ends before load factor {:.4g}: {}", question.scene.name,
        out.has_truth() ? "the truth itself" : "invariant, by which an envelope without truth goes,",
        out.answers.factor[out.answers.value.size()], out.answers.ended));
  return out;
}

Advice advise(const Question& question, const std::map<std::string, Cost>& costs) {
  Advice out = asked(question);
  answer(out, costs);
  return out;
}

}  // namespace halfway::advise
