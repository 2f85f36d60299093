// Scene files that exist as long as a check needs them.
#pragma once

#include <filesystem>
#include <string>

namespace halfway::verify {

/// A file scene.toml in a folder of its own for each check and process; gone with it.
class TemporaryScene {
 public:
  TemporaryScene(const std::string& what, const std::string& text);
  TemporaryScene(const TemporaryScene&) = delete;
  ~TemporaryScene();
  std::filesystem::path path() const { return folder_ / "scene.toml"; }

 private:
  std::filesystem::path folder_;
};

/// The message of the refusal, without the folder; empty when the file is accepted.
std::string refusal(const std::filesystem::path& file);

}  // namespace halfway::verify
