// Files of both commands: read up to a size, written whole and never over another one unasked.
#pragma once

#include <filesystem>
#include <string>

namespace halfway::imports {

/// At most one byte more than `most`, which says that it is too long. Throws reports::BadInput.
std::string read_up_to(const std::filesystem::path& file, std::size_t most);

/// Throws reports::BadInput where something has that name, unless `force`; a folder always.
void refuse_existing(const std::filesystem::path& file, bool force);

/// By a temporary file beside it. Throws reports::FailedRun.
void write_new(const std::filesystem::path& file, const std::string& text);

}  // namespace halfway::imports
