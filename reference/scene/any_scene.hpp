// Scenes of any sort: of a joint, of a chain, of a mechanism.
#pragma once

#include "reference/scene/chain_scene.hpp"
#include "reference/scene/mechanism_scene.hpp"

#include <functional>
#include <variant>
#include <vector>

namespace halfway::reference {

/// A scene of any sort.
using AnyScene = std::variant<Scene, ChainScene, MechanismScene>;

/// Reads and checks one scene, of a chain where it has a table [chain], of a mechanism where it says more
/// than one joint does. Throws SceneError.
AnyScene read_any_scene(const std::filesystem::path& file);

/// The same of a text that no file holds; `name` stands for it in messages.
AnyScene read_scene_text(const std::string& text, const std::string& name);

/// The scenes of chains in the folder `chains` of scenes_folder(), where there is one, ordered by name.
/// Throws SceneError.
std::vector<ChainScene> chain_scenes();

/// Those of mechanisms in its folder `mechanisms`, likewise.
std::vector<MechanismScene> mechanism_scenes();

/// Those in time in its folder `motion`, likewise.
std::vector<MechanismScene> motion_scenes();

/// Reads a scene and shows what was asked of its file. Throws SceneError.
void with_questions(const std::filesystem::path& file,
                    const std::function<void(const Document&, const std::vector<Question>&)>& use);

}  // namespace halfway::reference
