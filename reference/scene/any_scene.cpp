#include "reference/scene/any_scene.hpp"

#include "reference/scene/read_mechanism.hpp"
#include "reference/scene/scene_head.hpp"

namespace halfway::reference {
namespace {

AnyScene any_of(const Field& file, const std::filesystem::path& path) {
  if (file.find("chain")) return chain_scene(file, path);
  if (is_mechanism(file)) return mechanism_scene(file, path);
  return joint_scene(file, path);
}

/// Of a folder of scenes_folder(), where there is one.
template <class AScene>
std::vector<AScene> scenes_of(const char* name, AScene (*read)(const Field&, const std::filesystem::path&)) {
  std::vector<AScene> out;
  const auto folder = scenes_folder() / name;
  if (!std::filesystem::is_directory(folder)) return out;
  for (const auto& path : scene_files(folder)) {
    read_scene_file(path,
                    [&](const Field& file) -> SceneHead& { return out.emplace_back(read(file, path)); });
  }
  return out;
}

}  // namespace

AnyScene read_any_scene(const std::filesystem::path& path) {
  AnyScene out;
  read_scene_file(path, [&](const Field& file) -> SceneHead& {
    out = any_of(file, path);
    return std::visit([](auto& scene) -> SceneHead& { return scene; }, out);
  });
  return out;
}

AnyScene read_scene_text(const std::string& text, const std::string& name) {
  AnyScene out;
  with_scene_text(text, name, [&](Document& document) { out = any_of(Field(document), name); });
  return out;
}

void with_questions(const std::filesystem::path& path,
                    const std::function<void(const Document&, const std::vector<Question>&)>& use) {
  with_scene_file(path, [&](Document& document) {
    std::vector<Question> questions;
    document.questions = &questions;
    any_of(Field(document), path);
    use(document, questions);
  });
}

std::vector<ChainScene> chain_scenes() { return scenes_of<ChainScene>("chains", chain_scene); }

std::vector<MechanismScene> mechanism_scenes() {
  return scenes_of<MechanismScene>("mechanisms", mechanism_scene);
}

std::vector<MechanismScene> motion_scenes() { return scenes_of<MechanismScene>("motion", mechanism_scene); }

}  // namespace halfway::reference
