#include "reports/views/cheapest.hpp"

#include "verify/studies/scenes/model_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace halfway::reports {
namespace {

using bench::Timing;
using reference::Choice;
using reference::Curve;
using reference::Entry;
using reference::Scene;
using verify::Truth;

constexpr double kTolerances[] = {1e-2, 1e-4, 1e-8};

/// A formulation on a scene, in one way of evaluating it that was timed.
struct Candidate {
  const Timing* timing;
  Choice choice;
  double error;
};

struct Candidates {
  std::vector<Candidate> all;
  std::set<std::string> ended;  ///< paths that do not reach the end of the scene
};

/// Loads and analytic tangent of one joint of that kind: what a solver pays for.
bool is_cost(const Timing& t, const std::string& kind) {
  return !t.wrong && t.ns > 0 && t.what == "residual_tangent" && t.kind == kind && t.joints == 0 &&
         t.method.empty() && (t.implementation == "reference" || t.implementation == "kernel");
}

/// The kept curve of the readable transcription, or the path of a kernel.
Curve path_of(const Timing& t, const Choice& choice, const Entry& evaluated, const Scene& scene,
              const std::vector<Curve>& curves) {
  if (t.implementation == "reference") {
    const auto kept = std::ranges::find_if(curves, [&](const Curve& c) {
      return c.scene == scene.name && c.formulation == t.formulation && c.xi == choice.xi;
    });
    if (kept != curves.end()) return *kept;
  }
  return solve_scene(scene, {&evaluated, choice.xi});
}

std::string label(const Timing& t) {
  return t.formulation + (t.variant.empty() ? "" : ' ' + t.variant) +
         (t.precision == "float" ? " in float" : "");
}

Candidates candidates(const Scene& scene, const Truth& truth, const Results& results) {
  Candidates out;
  for (const Choice& choice : choices(scene)) {
    if (choice.entry == nullptr) continue;  // the linear analysis is no joint
    for (const Timing& t : results.timings) {
      if (t.formulation != choice.entry->name || !is_cost(t, to_string(scene.joint.kind))) continue;
      const auto evaluated =
          verify::evaluated_by(t.implementation, t.variant, t.precision, *choice.entry, scene);
      if (!evaluated) continue;
      const auto error = verify::model_error(path_of(t, choice, *evaluated, scene, results.curves), truth);
      if (error)
        out.all.push_back({&t, choice, *error});
      else
        out.ended.insert(label(t));
    }
  }
  return out;
}

/// The truth's own form, by its kernel in double where that was timed.
const Candidate* most_exact(const std::vector<Candidate>& all, const Truth& truth) {
  const auto rank = [&](const Candidate& c) {
    const bool own = c.choice.entry == truth.choice.entry && c.choice.xi == truth.choice.xi;
    const bool plain = c.timing->precision == "double" && c.timing->variant.empty();
    return !own || !plain ? 0 : c.timing->implementation == "kernel" ? 2 : 1;
  };
  const auto best = std::ranges::max_element(all, {}, rank);
  return best == all.end() || rank(*best) == 0 ? nullptr : &*best;
}

/// Flops of the same formulation and implementation where every kind of load is needed, less these.
double flops_saved(const Timing& chosen, const std::vector<Timing>& timings) {
  const auto whole = std::ranges::find_if(timings, [&](const Timing& t) {
    return is_cost(t, "linear_angular") && t.formulation == chosen.formulation && t.variant.empty() &&
           t.implementation == chosen.implementation && t.precision == "double";
  });
  if (whole == timings.end() || whole->flops <= 0 || chosen.flops <= 0 || chosen.kind == whole->kind)
    return 0;
  return whole->flops - chosen.flops;
}

std::string scene_note(const Truth& truth, const Candidates& found) {
  std::string note = truth.described;
  if (!truth.curve.converged) note += "; its path does not reach the end, so nothing is compared";
  if (truth.curve.converged && !found.ended.empty())
    note += fmt::format("; do not reach the end: {}", fmt::join(found.ended, ", "));
  return note;
}

/// Times closer than this are the same: what is more exact, and the scene's own form, is then chosen.
constexpr double kSameTime = 1.1;

/// The cheapest that meets the tolerance; null where none does.
const Candidate* cheapest_of(const std::vector<Candidate>& all, const Candidate* exact, double tolerance) {
  const Candidate* chosen = nullptr;
  for (const Candidate& c : all)
    if (c.error <= tolerance && (chosen == nullptr || c.timing->ns < chosen->timing->ns)) chosen = &c;
  const bool same = chosen != nullptr && exact != nullptr && exact->error <= tolerance &&
                    exact->timing->ns <= kSameTime * chosen->timing->ns;
  return same ? exact : chosen;
}

nlohmann::json row(const Scene& scene, double tolerance, const Truth& truth, const Candidates& found,
                   const std::vector<Timing>& timings) {
  const Candidate* exact = most_exact(found.all, truth);
  const Candidate* chosen = cheapest_of(found.all, exact, tolerance);
  nlohmann::json json = {
      {"scene", scene.name}, {"tolerance", tolerance}, {"kind", to_string(scene.joint.kind)}};
  std::string note = scene_note(truth, found);
  if (chosen == nullptr) {
    json["formulation"] = "";
    json["note"] = fmt::format("none of {} timed models meets {:g}; {}", found.all.size(), tolerance, note);
    return json;
  }
  const Timing& t = *chosen->timing;
  if (chosen->choice.entry->needs_xi) note += fmt::format("; chosen with xi = {}", chosen->choice.xi);
  if (t.precision == "float")
    note += "; float: node a is the identity here, elsewhere rounded poses add 6e-8 rad";
  json.update({{"formulation", t.formulation},
               {"implementation", t.implementation},
               {"precision", t.precision},
               {"variant", t.variant},
               {"method", "analytic"},
               {"error", chosen->error},
               {"margin", tolerance / chosen->error},
               {"ns", t.ns},
               {"relative_cost", exact ? nlohmann::json(t.ns / exact->timing->ns) : nlohmann::json()},
               {"flops", t.flops},
               {"flops_saved", flops_saved(t, timings)},
               {"note", note}});
  return json;
}

}  // namespace

nlohmann::json cheapest(const Results& results) {
  nlohmann::json rows = nlohmann::json::array();
  if (results.timings.empty()) return rows;
  for (const Scene& scene : reference::canonical_scenes()) {
    const bool wanted =
        std::ranges::any_of(results.scenes, [&](const SceneInfo& info) { return info.name == scene.name; });
    if (!wanted) continue;
    const Truth truth = verify::truth_of(scene);
    const Candidates found = candidates(scene, truth, results);
    for (const double tolerance : kTolerances)
      rows.push_back(row(scene, tolerance, truth, found, results.timings));
  }
  return rows;
}

}  // namespace halfway::reports
