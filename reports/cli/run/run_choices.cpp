#include "reports/cli/run/run_choices.hpp"

#include "reference/scene/joint/names.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halfway::reports {
namespace {

const reference::Entry& entry_of(const std::string& name) {
  if (const auto* entry = reference::find_formulation(name)) return *entry;
  throw BadInput(reference::unknown_name("formulation", name, reference::formulation_names()));
}

bool looks_like_file(const std::string& text) {
  return text.ends_with(".toml") || text.find('/') != std::string::npos;
}

template <class AScene>
std::optional<reference::AnyScene> named(const std::vector<AScene>& scenes, const std::string& name,
                                         std::vector<std::string>& names) {
  for (const auto& scene : scenes) {
    if (scene.name == name) return scene;
    names.push_back(scene.name);
  }
  return std::nullopt;
}

bool takes_xi(const reference::Entry* entry) { return entry && entry->needs_xi; }

/// Those named, or those that the scene asks for, each once.
std::vector<const reference::Entry*> entries_of(const reference::SceneHead& scene, const Fit& fit,
                                                const std::vector<std::string>& names) {
  std::vector<const reference::Entry*> entries;  // nullptr: the linear analysis
  for (const std::string& name : names) {
    entries.push_back(name == reference::kLinearized ? nullptr : &entry_of(name));
    if (const std::string why = fit.objection(entries.back()); !why.empty())
      throw BadInput(fmt::format("{} cannot run scene {}: it {}", name, scene.name, why));
  }
  if (!names.empty()) return entries;
  for (const auto& choice : fit.asked) {
    if (std::ranges::find(entries, choice.entry) == entries.end()) entries.push_back(choice.entry);
  }
  return entries;
}

}  // namespace

reference::AnyScene find_scene(const std::string& name_or_file) {
  if (looks_like_file(name_or_file)) {
    if (!std::filesystem::is_regular_file(name_or_file))
      throw BadInput(name_or_file + ": no such scene file; allowed: a TOML file, or a name of halfway list");
    return reference::read_any_scene(name_or_file);
  }
  std::vector<std::string> names;
  if (auto joint = named(reference::canonical_scenes(), name_or_file, names)) return *std::move(joint);
  if (auto chain = named(reference::chain_scenes(), name_or_file, names)) return *std::move(chain);
  if (auto mechanism = named(reference::mechanism_scenes(), name_or_file, names))
    return *std::move(mechanism);
  if (auto motion = named(reference::motion_scenes(), name_or_file, names)) return *std::move(motion);
  const std::vector<std::string_view> allowed(names.begin(), names.end());
  throw BadInput(reference::unknown_name("scene", name_or_file, allowed) + ", or a file NAME.toml");
}

Fit fit_of(const reference::Scene& scene) {
  return {reference::choices(scene), [&scene](const reference::Entry* entry) -> std::string {
            if (!entry) return "";
            if (const char* why = reference::law_refused(*entry, scene.joint)) return why;
            const bool lacks_length = entry->needs_length && !scene.has_length;
            return lacks_length ? "needs the length of its rod: joint.length in the scene" : "";
          }};
}

std::vector<reference::Choice> run_choices(const reference::SceneHead& scene, const Fit& fit,
                                           const std::vector<std::string>& names,
                                           const std::vector<double>& xis) {
  for (double xi : xis) {
    if (!std::isfinite(xi)) throw BadInput(fmt::format("--xi {}: must be a finite number", xi));
  }
  const auto entries = entries_of(scene, fit, names);
  if (!xis.empty() && std::ranges::none_of(entries, takes_xi))
    throw BadInput("--xi: none of the formulations to run has a free xi");
  std::vector<reference::Choice> out;
  for (const auto* entry : entries) {
    if (!takes_xi(entry)) {
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

std::vector<NotRun> left_out(const reference::SceneHead& scene, const Fit& fit,
                             const std::vector<reference::Choice>& choices) {
  std::vector<NotRun> out;
  if (!scene.formulations.empty()) return out;
  for (const auto& entry : reference::formulations()) {
    if (std::ranges::find(choices, &entry, &reference::Choice::entry) != choices.end()) continue;
    const std::string why = fit.objection(&entry);
    out.push_back({std::string(entry.name),
                   why.empty() ? "needs a value: --xi 0.5, or xis = [0.5] in the scene" : why});
  }
  return out;
}

}  // namespace halfway::reports
