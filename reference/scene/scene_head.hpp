// What scenes of joints and of chains say alike.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/text/fields.hpp"

#include <functional>
#include <optional>
#include <string>

namespace halfway::reference {

/// The keys of these functions at the top of a file.
inline const Names kHeadKeys = {"title",        "description", "source", "outputs",
                                "formulations", "xis",         "path",   "reference"};

/// Name, title, description and source. Throws Refusal, as all of these.
void read_title(const Field& file, const std::filesystem::path& path, SceneHead& out);

/// factor_end, demanded, and points.
void read_path(const Field& path, SceneHead& out);

/// `outputs`, by default all that are `allowed`.
void read_outputs(const Field& file, const std::vector<std::string>& allowed, SceneHead& out);

/// Why a formulation cannot be asked for by name, and what can.
struct Unfit {
  std::string what, allowed;
};

/// `formulations` and `xis`; `unfit` judges each formulation of the catalog that is named. The names `beside`
/// may stand among them.
void read_formulations(const Field& file, const Names& beside,
                       const std::function<std::optional<Unfit>(const Entry&)>& unfit, SceneHead& out);

/// `reference`, in a scene that is read but for it; see read_reference_set.
void read_references(const Field& file, std::string_view truth, SceneHead& out);

/// The tables [[load]], of which there is one at least.
Field::Items loads_of(const Field& file);

/// A load of the names `types`: which it is, counted from 0, and its value.
struct NamedLoad {
  int type;
  Vec3<double> value;
};
NamedLoad read_load(const Field& load, const Names& types);

/// The keys of read_scene_load.
inline const Names kLoadKeys = {"type", "value", "point", "arm", "held"};

/// A load on a node that moves as a loaded one of that kind, at rest in the orientation R. Throws Refusal.
SceneLoad read_scene_load(const Field& load, Kind kind, const Mat3<double>& R);

/// The whole of a file that has a joint. Throws Refusal.
Scene joint_scene(const Field& file, const std::filesystem::path& path);

/// Opens the file for `read`, which returns where it put the scene. Throws SceneError for each Refusal.
void read_scene_file(const std::filesystem::path& path, const std::function<SceneHead&(const Field&)>& read);

/// Opens the file for `use`. Throws SceneError for each Refusal.
void with_scene_file(const std::filesystem::path& path, const std::function<void(Document&)>& use);

/// The same of a text that no file holds; `name` stands for it in messages.
void with_scene_text(const std::string& text, const std::string& name,
                     const std::function<void(Document&)>& use);

/// The files *.toml of a folder, ordered by name. Throws SceneError where there is none.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& folder);

}  // namespace halfway::reference
