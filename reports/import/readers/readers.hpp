// From a file's text to its bushings. Every reader throws reference::Refusal with the line of what is wrong.
#pragma once

#include "reports/import/record/imported.hpp"

#include <string_view>

namespace halfway::imports {

inline constexpr std::size_t kLargestFile = 16u << 20;  // bytes

/// By what stands in it, not by its name; at least one joint. What is known and not read is refused with the
/// reason.
std::vector<ImportedJoint> read_joints(std::string_view text, const ImportOptions& options);

/// The lines of `import --help`: what is read and what it becomes.
const char* kinds_read();

// One for each format.
std::vector<ImportedJoint> read_xml(std::string_view text);  ///< Drake, OpenSim
std::vector<ImportedJoint> read_chrono_yaml(std::string_view text);
std::vector<ImportedJoint> read_chrono_json(std::string_view text, const ImportOptions& options);
std::vector<ImportedJoint> read_mbdyn(std::string_view text, const ImportOptions& options);
std::vector<ImportedJoint> read_teim_orbit(std::string_view text,
                                           const ImportOptions& options);  ///< Adams .bus
std::vector<ImportedJoint> read_adams_solver(std::string_view text, const ImportOptions& options);  ///< .adm
std::vector<ImportedJoint> read_nastran(std::string_view text, const ImportOptions& options);

}  // namespace halfway::imports
