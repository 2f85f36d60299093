#include "reference/truth/data.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace halfway::reference {

std::filesystem::path data_folder() {
  const char* folder = std::getenv("HALFWAY_DATA");
  return folder && *folder ? folder : HALFWAY_DATA_DIR;
}

nlohmann::json read_data(const std::string& relative_path) {
  const auto file = data_folder() / relative_path;
  const auto refuse = [&](const std::string& what) {
    throw DataError(fmt::format("{}: {}; the folder is set by HALFWAY_DATA", file.string(), what));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) refuse("is a folder");
  errno = 0;
  std::ifstream in(file);
  if (!in) refuse(fmt::format("cannot be read ({})", std::strerror(errno)));
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    refuse(fmt::format("is not JSON ({})", error.what()));
  }
  return {};
}

}  // namespace halfway::reference
