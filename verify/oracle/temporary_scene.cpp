#include "verify/oracle/temporary_scene.hpp"

#include "reference/scene/any_scene.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace halfway::verify {

TemporaryScene::TemporaryScene(const std::string& what, const std::string& text)
    : folder_(std::filesystem::temp_directory_path() / fmt::format("halfway_{}_{}", what, getpid())) {
  std::filesystem::create_directories(folder_);
  std::ofstream(path(), std::ios::binary) << text;
}

TemporaryScene::~TemporaryScene() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string refusal(const std::filesystem::path& file) {
  try {
    reference::read_any_scene(file);
  } catch (const reference::SceneError& error) {
    const std::string message = error.what(), folder = file.parent_path().string() + "/";
    return tapped(message.starts_with(folder) ? message.substr(folder.size()) : message);
  }
  return tapped(std::string());
}

}  // namespace halfway::verify
