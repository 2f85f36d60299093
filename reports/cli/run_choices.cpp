#include "reports/cli/run_choices.hpp"

#include "reference/scene/names.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reports {
namespace {

const reference::Entry& entry_of(const std::string& name) {
  if (const auto* entry = reference::find_formulation(name)) return *entry;
  throw BadInput(reference::unknown_name("formulation", name, reference::formulation_names()));
}

void check_scene(const reference::Entry& entry, const reference::Scene& scene) {
  if (!reference::accepts_law(entry, scene.joint)) {
    const char* it = entry.block_diagonal_law_only ? "couples translation and rotation"
                                                   : "has no positive definite angular stiffness";
    throw BadInput(fmt::format("{} refuses the law of scene {}: it {}", entry.name, scene.name, it));
  }
  if (entry.needs_length && !scene.has_length)
    throw BadInput(fmt::format("{} needs the length of its rod: scene {} names none (joint.length)",
                               entry.name, scene.name));
}

bool looks_like_file(const std::string& text) {
  return text.ends_with(".toml") || text.find('/') != std::string::npos;
}

}  // namespace

reference::Scene find_scene(const std::string& name_or_file) {
  if (looks_like_file(name_or_file)) {
    if (!std::filesystem::is_regular_file(name_or_file))
      throw BadInput(name_or_file + ": no such scene file; allowed: a TOML file, or a name of halfway list");
    return reference::read_scene(name_or_file);
  }
  const auto scenes = reference::canonical_scenes();
  std::vector<std::string_view> names;
  for (const auto& scene : scenes) {
    if (scene.name == name_or_file) return scene;
    names.push_back(scene.name);
  }
  throw BadInput(reference::unknown_name("scene", name_or_file, names) + ", or a file NAME.toml");
}

std::vector<reference::Choice> run_choices(const reference::Scene& scene,
                                           const std::vector<std::string>& names,
                                           const std::vector<double>& xis) {
  for (double xi : xis) {
    if (!std::isfinite(xi)) throw BadInput(fmt::format("--xi {}: must be a finite number", xi));
  }
  std::vector<const reference::Entry*> entries;  // nullptr: the linear analysis
  for (const std::string& name : names) {
    entries.push_back(name == reference::kLinearized ? nullptr : &entry_of(name));
    if (entries.back()) check_scene(*entries.back(), scene);
  }
  if (names.empty()) {
    for (const auto& choice : reference::choices(scene)) {
      if (std::ranges::find(entries, choice.entry) == entries.end()) entries.push_back(choice.entry);
    }
  }
  const auto has_free_xi = [](const reference::Entry* entry) { return entry && entry->needs_xi; };
  if (!xis.empty() && std::ranges::none_of(entries, has_free_xi))
    throw BadInput("--xi: none of the formulations to run has a free xi");

  std::vector<reference::Choice> out;
  for (const auto* entry : entries) {
    if (!has_free_xi(entry)) {
      out.push_back({entry, entry ? entry->probe_xi : 0.5});
      continue;
    }
    const auto& values = xis.empty() ? scene.xis : xis;
    if (values.empty()) {
      throw BadInput(fmt::format("{} needs --xi: scene {} names no value", entry->name, scene.name));
    }
    for (double xi : values) out.push_back({entry, xi});
  }
  return out;
}

std::vector<LeftOut> left_out(const reference::Scene& scene, const std::vector<reference::Choice>& choices) {
  std::vector<LeftOut> out;
  if (!scene.formulations.empty()) return out;
  for (const auto& entry : reference::formulations()) {
    if (std::ranges::find(choices, &entry, &reference::Choice::entry) != choices.end()) continue;
    const char* refused = reference::law_refused(entry, scene.joint);
    const char* needed = entry.needs_length ? "needs the length of its rod: joint.length in the scene"
                                            : "needs a value: --xi 0.5, or xis = [0.5] in the scene";
    out.push_back({std::string(entry.name), refused ? refused : needed});
  }
  return out;
}

}  // namespace halfway::reports
