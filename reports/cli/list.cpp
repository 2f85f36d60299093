// halfway list: what can be run.
#include "reference/face/registry.hpp"
#include "reference/scene/any_scene.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/schema.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace halfway::reports {
namespace {

/// Counted in the list itself: the laws are linked by who compares with them.
#define HALFWAY_PROGRAM(type, header) +1
constexpr int kProgramJoints = 0
#include "halfway/programs/programs.def"
    ;
#undef HALFWAY_PROGRAM

void list_formulations() {
  std::size_t width = 0;
  for (const auto& entry : reference::formulations()) width = std::max(width, entry.name.size());
  print("Formulations (each for the kinds angular, linear, linear_angular):\n");
  for (const auto& entry : reference::formulations()) {
    print(fmt::format("  {:<{}}  {}{}{}\n", entry.name, width, entry.stands_for,
                      entry.needs_xi       ? "; needs xi"
                      : entry.needs_length ? "; needs length"
                                           : "",
                      entry.block_diagonal_law_only ? "; no coupling of translation and rotation" : ""));
  }
}

/// For who includes the library: name -> type -> header.
void list_types() {
  for (const auto& entry : reference::formulations())
    print(fmt::format("{:<17} halfway::{:<17} <{}>\n", entry.name, entry.type, entry.header));
}

template <class AScene>
void list_scenes(const char* what, const std::filesystem::path& folder, const std::vector<AScene>& scenes) {
  std::size_t width = 0;
  for (const auto& scene : scenes) width = std::max(width, scene.name.size());
  print(fmt::format("\n{} (in {}):\n", what, printable(folder.string())));
  for (const auto& scene : scenes)
    print(fmt::format("  {:<{}}  {}\n", scene.name, width, printable(scene.title)));
}

void list_programs() {
  print(fmt::format(
      "\n{} joints of other programs besides; `./halfway check` compares yours with all of them\n",
      kProgramJoints));
}

/// Keys that no scene shows are no part of what is published: said, and the exit code tells.
void print_schema() {
  std::vector<std::string> unseen;
  print(scene_schema(unseen).dump(1) + "\n");
  for (const std::string& key : unseen)
    tell(fmt::format("no scene has {}: the schema takes anything there\n", key));
}

}  // namespace

void add_list(CLI::App& app) {
  CLI::App* command = app.add_subcommand("list", "List the formulations and the scenes");
  const auto types = std::make_shared<bool>(false);
  command->add_flag("--types", *types,
                    "Of each formulation its name, its C++ type and the header to include");
  const auto schema = std::make_shared<bool>(false);
  command->add_flag("--schema", *schema, "The JSON Schema of scene files, for editors and other programs");
  command->callback([types, schema] {
    if (*types) return list_types();
    if (*schema) return print_schema();
    list_formulations();
    list_scenes("Scenes", reference::scenes_folder(), reference::canonical_scenes());
    if (const auto mechanisms = reference::mechanism_scenes(); !mechanisms.empty())
      list_scenes("Mechanisms", reference::scenes_folder() / "mechanisms", mechanisms);
    if (const auto motions = reference::motion_scenes(); !motions.empty())
      list_scenes("Scenes in time", reference::scenes_folder() / "motion", motions);
    if (const auto chains = reference::chain_scenes(); !chains.empty())
      list_scenes("Scenes of chains", reference::scenes_folder() / "chains", chains);
    list_programs();
  });
}

}  // namespace halfway::reports
