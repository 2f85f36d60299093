#include "reference/scene/scene.hpp"

#include "reference/scene/names.hpp"
#include "reference/scene/read_joint.hpp"
#include "reference/scene/scene_references.hpp"
#include "reference/scene/toml_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace halfway::reference {
namespace {

constexpr int kMostPoints = 100000;
constexpr const char* kLoadTypes[] = {"fixed_moment", "follower_moment", "fixed_force"};

SceneLoad read_load(const Field& load, Kind kind) {
  load.has_only({"type", "value", "point"});
  const Names types(std::begin(kLoadTypes), std::end(kLoadTypes));
  const Field type = load.at("type", "fixed_moment, follower_moment, fixed_force");
  const std::string name = type.one_of(types);
  SceneLoad out;
  out.type = LoadType(std::find(types.begin(), types.end(), name) - types.begin());
  if (kind == Kind::linear && out.type != LoadType::fixed_force) {
    type.refuse("loads a joint that resists no rotation (joint.kind = \"linear\")", "fixed_force");
  }
  const std::string shape = "3 numbers, N or N m";
  const Field value = load.at("value", shape);
  out.value = value.vector(3, shape);
  if (out.value.isZero(0)) value.refuse("loads nothing", "a load that is not zero");
  if (const auto point = load.find("point")) {
    if (out.type != LoadType::fixed_force)
      point->refuse("is a point of a moment", "point beside fixed_force only");
    out.point = point->vector(3, "3 numbers, m, axes of node b");
  }
  return out;
}

std::vector<std::string> outputs_of(Kind kind) {
  const std::vector<std::string> rotations = {"theta_x", "theta_y", "theta_z"};
  const std::vector<std::string> displacements = {"u_x", "u_y", "u_z"};
  if (kind == Kind::angular) return rotations;
  if (kind == Kind::linear) return displacements;
  std::vector<std::string> all = rotations;
  all.insert(all.end(), displacements.begin(), displacements.end());
  return all;
}

/// Is there a moment about the axis alone wherever the joint turns about it alone?
bool is_principal(const LawSpec& law, int axis) {
  const auto* linear = std::get_if<LinearSpec>(&law);
  if (!linear) return true;  // a polynomial for each axis
  for (int i = 0; i < 3; ++i) {
    if (i != axis && linear->matrix(i, axis) != 0) return false;
  }
  return true;
}

void read_path(const Field& path, Scene& scene) {
  path.has_only({"factor_end", "points", "critical_axis"});
  scene.factor_end = path.at("factor_end", "a number > 0").positive();
  if (const auto points = path.find("points")) scene.points = points->integer(1, kMostPoints);
  if (const auto axis = path.find("critical_axis")) {
    if (scene.joint.kind != Kind::angular)
      axis->refuse("is asked of a joint that is not angular", "angular joints");
    scene.critical_axis = axis->integer(1, 3);
    if (!is_principal(scene.joint.law, scene.critical_axis - 1))
      axis->refuse("is no principal axis of the law: a turn about it needs moments about the others",
                   "a joint axis whose row of the law has its diagonal entry alone");
  }
}

void read_wanted(const Field& file, Scene& scene) {
  scene.outputs = outputs_of(scene.joint.kind);
  if (const auto outputs = file.find("outputs")) {
    scene.outputs = outputs->distinct(Names(scene.outputs.begin(), scene.outputs.end()));
    if (scene.outputs.empty()) outputs->refuse("is empty", "at least one output");
  }
  if (const auto xis = file.find("xis")) {
    scene.xis = xis->distinct_numbers();
    if (!scene.xis.empty()) scene.joint.xi = scene.xis.front();
  }
  const auto names = file.find("formulations");
  if (!names) return;
  Names allowed = formulation_names();
  allowed.push_back(kLinearized);
  scene.formulations = names->distinct(allowed);
  if (scene.formulations.empty())
    names->refuse("is empty", "at least one name, or no such key for all formulations");
  for (const std::string& name : scene.formulations) {
    const Entry* entry = find_formulation(name);
    if (entry && entry->needs_xi && scene.xis.empty())
      names->refuse(fmt::format("names {}, which needs a xi", name), "xis = [...] beside it");
    if (entry && entry->needs_length && !scene.has_length)
      names->refuse(fmt::format("names {}, which needs the length of its rod", name),
                    "joint.length beside it");
    if (const char* why = entry ? law_refused(*entry, scene.joint) : nullptr)
      names->refuse(fmt::format("names {}, which {}", name, why),
                    entry->block_diagonal_law_only ? "a block-diagonal law, or other formulations"
                                                   : "a positive definite law, or other formulations");
  }
}

Names keys_of_joint() {
  Names keys = kJointKeys;
  keys.insert(keys.end(), kRodKeys.begin(), kRodKeys.end());
  return keys;
}

/// The file's name without extension; all of it where that is a folder's name: "...toml" is no "..".
std::string name_of(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  return stem.find_first_not_of('.') == std::string::npos ? file.filename().string() : stem;
}

Scene scene_of(Document& document, const std::filesystem::path& path) {
  const Field file(document);
  file.has_only({"title", "description", "source", "outputs", "formulations", "xis", "joint", "load", "path",
                 "reference"});
  Scene scene;
  scene.name = name_of(path);
  scene.title = file.at("title", "one line of text").text();
  scene.description = file.text_or("description");
  scene.source = file.text_or("source");
  const Field joint = file.at("joint", "a table [joint]");
  joint.has_only(keys_of_joint());
  for (const char* node : {"a", "b"}) {
    if (const auto end = joint.find(node)) end->has_only({"o", "h"});
  }
  scene.joint = read_joint(joint);
  scene.has_length = read_rod(joint, scene.joint);
  const Field loads = file.at("load", "at least one table [[load]]");
  for (const Field load : loads.items("tables [[load]]"))
    scene.loads.push_back(read_load(load, scene.joint.kind));
  if (scene.loads.empty()) loads.refuse("is empty", "at least one table [[load]]");
  read_path(file.at("path", "a table [path]"), scene);
  read_wanted(file, scene);
  if (const auto sets = file.find("reference")) {
    for (const Field set : sets->items("tables [[reference]]")) {
      const auto references = read_reference_set(set, scene);
      scene.references.insert(scene.references.end(), references.begin(), references.end());
    }
  }
  return scene;
}

}  // namespace

const char* to_string(LoadType type) { return kLoadTypes[std::size_t(type)]; }

bool is_critical(const std::string& output) {
  return output == "critical_moment" || output == "critical_angle";
}

Scene read_scene(const std::filesystem::path& path) {
  Document document;
  try {
    read_toml(path, document);
    Scene scene = scene_of(document, path);
    scene.notes = std::move(document.notes);
    return scene;
  } catch (const Refusal& refusal) {
    throw SceneError(fmt::format("{}:{}: {}", path.string(), refusal.line, refusal.what()));
  }
}

std::filesystem::path scenes_folder() {
  const char* folder = std::getenv("HALFWAY_SCENES");
  return folder && *folder ? folder : HALFWAY_SCENES_DIR;
}

std::vector<Scene> canonical_scenes() { return scenes_in(scenes_folder()); }

std::vector<Scene> scenes_in(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (auto it = std::filesystem::directory_iterator(folder, error); !error && it != end(it);
       it.increment(error)) {
    if (it->path().extension() == ".toml") files.push_back(it->path());
  }
  if (error || files.empty()) {
    throw SceneError(
        fmt::format("{}: holds no scene ({}); allowed: a folder with *.toml, named by HALFWAY_SCENES",
                    folder.string(), error ? error.message() : "no file *.toml"));
  }
  std::sort(files.begin(), files.end());
  std::vector<Scene> scenes;
  for (const auto& file : files) scenes.push_back(read_scene(file));
  return scenes;
}

}  // namespace halfway::reference
