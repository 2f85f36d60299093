#include "reports/cli/commands.hpp"
#include "reports/views/files.hpp"

namespace halfway::reports {

void try_output(const std::string& folder) {
  try {
    try_folder(folder);
  } catch (const FileError& error) {
    throw BadInput(std::string("--out: ") + error.what());
  }
}

}  // namespace halfway::reports
