// halfway export: the joint of a scene in another program's words.
#include "reference/scene/any_scene.hpp"
#include "reference/scene/joint/names.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/import/commands.hpp"
#include "reports/import/export/export.hpp"
#include "reports/import/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace halfway::imports {
namespace {

using reports::BadInput;

struct Asked {
  std::string scene{}, to{}, as{}, out{};
  bool law_only = false, force = false;
};

const Target& target_of(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Target& target : targets()) {
    if (name == target.name) return target;
    names.emplace_back(target.name);
  }
  throw BadInput("--to: " + reference::unknown_name("target", name, names));
}

/// A TOML file, or a name of `halfway list`.
reference::AnyScene scene_named(const std::string& name) {
  if (std::filesystem::is_regular_file(name)) return reference::read_any_scene(name);
  std::vector<std::string> names;
  for (auto& scene : reference::canonical_scenes()) {
    if (scene.name == name) return scene;
    names.push_back(scene.name);
  }
  const std::vector<std::string_view> allowed(names.begin(), names.end());
  throw BadInput(reference::unknown_name("scene", name, allowed) + ", or a file NAME.toml");
}

/// The one that --as says, or the only one of the scene.
std::string formulation_meant(const Asked& asked, const reference::Scene& scene) {
  const auto& own = scene.formulations;
  if (asked.as.empty()) return own.size() == 1 ? own.front() : "";
  if (!reference::find_formulation(asked.as))
    throw BadInput("--as: " +
                   reference::unknown_name("formulation", asked.as, reference::formulation_names()));
  if (!own.empty() && std::ranges::find(own, asked.as) == own.end())
    throw BadInput(fmt::format("--as {}: scene {} does not ask for it; allowed: one of its formulations",
                               asked.as, scene.name));
  return asked.as;
}

void export_scene(const Asked& asked) {
  const Target& target = target_of(asked.to);
  const reference::AnyScene any = scene_named(asked.scene);
  const auto* scene = std::get_if<reference::Scene>(&any);
  if (!scene)
    throw BadInput(fmt::format(
        "{}: is no scene of one joint, which is all that targets can say; allowed: a scene with [joint]",
        asked.scene));
  if (asked.law_only && asked.to != "bus")
    throw BadInput(fmt::format("--law-only: {} says the whole joint; allowed: --to bus", asked.to));
  const ExportRequest request{*scene, formulation_meant(asked, *scene), asked.law_only};
  const std::filesystem::path file = asked.out.empty() ? scene->name + target.extension : asked.out;
  Exported exported;
  try {
    exported = target.write(request);
  } catch (const CannotSay& error) {
    throw BadInput(fmt::format("--to {}: {}", asked.to, error.what()));
  }
  demand_same(request, exported);
  refuse_existing(file, asked.force);
  write_new(file, exported.text);
  for (const std::string& what : exported.left_out)
    reports::tell(reports::printable("not in it: " + what) + "\n");
  reports::tell("not in it: loads, path and reference values of the scene\n");
  reports::print("wrote " + reports::printable(file.string()) + "\n");
}

}  // namespace

void add_export(CLI::App& app) {
  const auto asked = std::make_shared<Asked>();
  CLI::App* command = app.add_subcommand(
      "export",
      "Write a scene's joint as another program's file\n\n"
      "  bus    Adams property file: law alone, no frames, no formulation\n"
      "  osim   OpenSim model with a BushingForce: simbody_xyz, diagonal stiffness\n"
      "  mbdyn  a joint statement: attached_a, mbdyn_joint_inv, or invariant of angular and linear joints\n\n"
      "What a target cannot say is refused by name. What was written is imported again and compared before "
      "it is kept.");
  command->add_option("scene", asked->scene, "Name of a canonical scene, or a TOML file")->required();
  command->add_option("--to", asked->to, "bus, osim or mbdyn")->required();
  command->add_option("--as", asked->as,
                      "The formulation that is meant, where the scene names none or several");
  command->add_flag("--law-only", asked->law_only, "To bus: leave out frames and formulation, and say so");
  command->add_option("--out", asked->out, "The file; default: SCENE with the target's extension, here");
  command->add_flag("--force", asked->force, "Replace a file that is there");
  command->callback([asked] { export_scene(*asked); });
}

}  // namespace halfway::imports
