// The canonical cases: every reference value of every scene, in double; and at 50 digits with the
// node order exchanged (C8) and in a turned global frame.
#include "reference/solve/path.hpp"
#include "reference/solve/solve.hpp"
#include "verify/oracle/replay.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace halfway::verify {
namespace {

using reference::Entry;
using reference::Path;
using reference::Real50;
using reference::Scene;
using reference::SceneReference;
using reference::Setting;

/// The formulation, with its xi where it has one.
std::string path_name(const SceneReference& r) {
  const bool has_xi = reference::find_formulation(r.formulation)->needs_xi;
  return has_xi ? fmt::format("{}_xi_{:g}", r.formulation, r.xi) : r.formulation;
}

/// The expected value and the limit, from the reference's text.
Draft expectation(const Scene& scene, const SceneReference& r, const std::string& variant) {
  const std::string at = r.factor > 0 ? fmt::format("@{:g}", r.factor) : "";
  const double expected = r.none ? 0 : double(Real50(r.value.c_str()));
  const double limit = r.absolute ? r.tolerance : r.tolerance * std::abs(expected);
  return finding(fmt::format("{}/{}/{}{}{}", scene.name, path_name(r), r.output, at, variant))
      .of(r.formulation)
      .about(scene.name)
      .in(r.output.starts_with("u_")      ? "m"
          : r.output == "critical_moment" ? "N m"
                                          : "rad")
      .equal(expected, limit, r.reason + "; " + r.source)
      .by(r.oracle, limit);
}

/// A whole path serves all references of one formulation: load factors in rising order.
template <class T>
std::vector<Finding> along_path(const Scene& scene, const std::vector<SceneReference>& references,
                                const Entry& entry, const Setting& setting, const std::string& variant) {
  std::vector<Finding> findings;
  std::map<double, std::vector<const SceneReference*>> by_factor;
  for (const SceneReference& r : references) by_factor[r.factor].push_back(&r);
  Path<T> path(scene, entry, references.front().xi, setting);
  for (const auto& [factor, wanted] : by_factor) {
    path.advance(factor);
    for (const SceneReference* r : wanted) {
      const bool converged = path.state().status == Status::converged;
      Measurement found(converged ? double(path.output(r->output)) : std::nan(""),
                        fmt::format("{} Newton iterations", path.state().iterations));
      found.set_replay(scene_text(scene, entry, r->xi, setting));
      findings.push_back(expectation(scene, *r, variant).measured(found));
    }
  }
  return findings;
}

std::vector<Finding> critical(const Scene& scene, const std::vector<SceneReference>& references,
                              const Entry& entry) {
  std::vector<Finding> findings;
  const auto found = reference::critical_state(scene, {&entry, references.front().xi});
  for (const SceneReference& r : references) {
    Draft f = expectation(scene, r, "");
    f.measured(!found ? 0 : double(r.output == "critical_moment" ? found->moment : found->angle));
    if (r.none) f.equal(0, 0, "0 stands for none below pi; " + r.source);
    findings.push_back(f);
  }
  return findings;
}

/// Which formulation the exchanged node order turns this one into; empty where it has no name.
std::string mirror(const Entry& entry) {
  if (entry.name == "attached_a") return "attached_b";
  if (entry.name == "attached_b") return "attached_a";
  return entry.facts.node_order.linear_angular.holds() ? std::string(entry.name) : "";
}

void add_scene(Checks& checks, const Scene& scene) {
  std::map<std::string, std::vector<SceneReference>> paths, criticals;
  for (const SceneReference& r : scene.references) {
    (reference::is_critical(r.output) ? criticals : paths)[path_name(r)].push_back(r);
  }
  // Named one by one: clang 14 cannot capture structured bindings.
  for (const auto& item : criticals) {
    const std::string& key = item.first;
    const std::vector<SceneReference>& references = item.second;
    const Entry& entry = *reference::find_formulation(references.front().formulation);
    checks.push_back({scene.name + "/" + key + "/critical", "cases",
                      [=, &entry] { return critical(scene, references, entry); }});
  }
  for (const auto& item : paths) {
    const std::string& key = item.first;
    const std::vector<SceneReference>& references = item.second;
    const Entry& entry = *reference::find_formulation(references.front().formulation);
    const std::string name = scene.name + "/" + key;
    checks.push_back({name + "/double", "cases",
                      [=, &entry] { return along_path<double>(scene, references, entry, {}, ""); }});
    Setting turned;
    turned.frame_turn = {0.7, -1.1, 0.4};
    turned.frame_shift = {3, -2, 5};
    checks.push_back({name + "/turned_frame", "cases", [=, &entry] {
                        return along_path<Real50>(scene, references, entry, turned, "/turned_frame");
                      }});
    const Entry* exchanged = reference::find_formulation(mirror(entry));
    if (exchanged == nullptr) continue;
    Setting setting;
    setting.nodes_exchanged = true;
    checks.push_back({name + "/nodes_exchanged", "cases", [=] {
                        return along_path<Real50>(scene, references, *exchanged, setting, "/nodes_exchanged");
                      }});
  }
}

/// Scenes that are no cases: what users see of joints, in closed form; in double alone.
std::vector<Finding> seen() {
  std::vector<Finding> out;
  for (const Scene& scene : reference::scenes_in(reference::scenes_folder() / "seen")) {
    std::map<std::string, std::vector<SceneReference>> paths;
    for (const SceneReference& r : scene.references) paths[r.formulation].push_back(r);
    for (const auto& [formulation, references] : paths) {
      const Entry& entry = *reference::find_formulation(formulation);
      for (const Finding& f : along_path<double>(scene, references, entry, {}, "")) out.push_back(f);
    }
  }
  return out;
}

}  // namespace

void cases(Checks& checks) {
  checks.push_back({"scenes/seen", "cases", seen});
  for (const Scene& scene : scenes()) add_scene(checks, scene);
}

}  // namespace halfway::verify
