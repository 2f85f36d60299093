#include "reports/tests/scene_promises.hpp"

#include "reference/scene/any_scene.hpp"

namespace halfway::reports::test {

std::string broken_scene_promise(std::string_view text) {
  try {
    reference::read_scene_text(std::string(text), "scene.toml");
  } catch (const reference::SceneError& error) {
    const std::string message = error.what();
    const bool is_whole =
        message.starts_with("scene.toml:") && message.find("; allowed: ") != std::string::npos;
    return is_whole ? "" : "refused without place or what is allowed: " + message;
  } catch (const std::exception& error) {
    return std::string("threw: ") + error.what();
  }
  return "";
}

}  // namespace halfway::reports::test
