// Which kind a file is, by what stands in it.
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::imports {
namespace {

constexpr const char* kKinds =
    "  Drake SDF, URDF   <drake:linear_bushing_rpy>                       drake_rpy\n"
    "  OpenSim .osim     <BushingForce>, documents of any version         simbody_xyz\n"
    "  Chrono YAML       joints with bushing_data                         chrono_body\n"
    "  Chrono JSON       objects with \"Bushing Data\"                      chrono_body\n"
    "  MBDyn             deformable joint, hinge, displacement joint      attached_a\n"
    "                    invariant deformable joint                       mbdyn_joint_inv\n"
    "                    invariant deformable hinge, displacement joint   invariant\n"
    "  Adams .bus        property file, curves become tables              --as NAME\n"
    "  Adams .adm        BUSHING with MARKER and UNITS                    --as NAME\n"
    "  Nastran           PBUSH, CBUSH, GRID, CORD2R                       --as NAME\n";

constexpr std::size_t kMostJoints = 1000;  // a scene file each

constexpr const char* kAllowed =
    "Drake SDF or URDF, OpenSim .osim, Chrono YAML or JSON, MBDyn, Adams .bus or .adm, Nastran (./halfway "
    "import --help)";

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Does a line begin with it, after blanks and in any case?
bool has_line(const std::vector<std::string_view>& lines, std::string_view begin) {
  return std::ranges::any_of(
      lines, [&](std::string_view line) { return upper(trimmed(line).substr(0, begin.size())) == begin; });
}

/// The first character of a text with comments of any kind left out.
char first_character(std::string_view text) {
  while (true) {
    text = text.substr(std::min(text.size(), text.find_first_not_of(" \t\r\n\xEF\xBB\xBF")));
    const bool is_block = text.starts_with("/*");
    if (!text.starts_with("//") && !is_block) return text.empty() ? '\0' : text.front();
    const std::size_t end = text.find(is_block ? "*/" : "\n");
    if (end == std::string_view::npos) return '\0';
    text = text.substr(end + (is_block ? 2 : 1));
  }
}

[[noreturn]] void refuse_file(std::string_view text, const std::string& what, std::string_view allowed) {
  std::string begin(trimmed(text.substr(0, 40)));
  std::ranges::replace_if(
      begin, [](unsigned char c) { return c < 0x20 || c > 0x7E; }, '?');
  refuse({1, "the file", begin}, what, allowed);
}

void refuse_known(std::string_view text) {
  constexpr const char* kSimscape =
      "is a Simulink model: a binary file of a closed program, which states no bushing that can be read";
  constexpr const char* kByHand = "a scene written by hand; Simscape's Bushing Joint is near simbody_xyz";
  const bool is_archive = text.starts_with("PK\x03\x04");
  if (is_archive || text.starts_with("Model {") || text.starts_with("# MathWorks OPC"))
    refuse_file(text, kSimscape, kByHand);
  if (text.empty()) refuse_file(text, "is empty", kAllowed);
  if (contains(text, std::string_view("\0", 1)))
    refuse_file(text, "is no text (it has zero bytes)", kAllowed);
  if (contains(text, "RigidBodySpringDamper") && contains(text, "import exudyn"))
    refuse_file(text, "is a program in Python for Exudyn, which would have to be run",
                "a scene written by hand: exudyn_intrinsic is its intrinsicFormulation");
}

}  // namespace

const char* kinds_read() { return kKinds; }

namespace {

std::vector<ImportedJoint> read_any(std::string_view text, const ImportOptions& options) {
  if (text.size() > kLargestFile)
    refuse({1, "the file", fmt::format("{} bytes", text.size())}, "is too long",
           fmt::format("up to {} MB", kLargestFile >> 20));
  refuse_known(text);
  const char first = first_character(text);
  const auto lines = lines_of(text);
  if (first == '<') return read_xml(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  if (first == '{') return read_chrono_json(text, options);
  if (has_line(lines, "[UNITS]") || has_line(lines, "[MDI_HEADER]")) return read_teim_orbit(text, options);
  if (has_line(lines, "BUSHING/") || has_line(lines, "ADAMS/")) return read_adams_solver(text, options);
  if (has_line(lines, "PBUSH")) return read_nastran(text, options);
  if (contains(text, "deformable ") || has_line(lines, "BEGIN:")) return read_mbdyn(text, options);
  if (contains(text, "bushing_data") || contains(text, "chrono-version")) return read_chrono_yaml(text);
  refuse_file(text, "is of no kind known here", kAllowed);
}

}  // namespace

std::vector<ImportedJoint> read_joints(std::string_view text, const ImportOptions& options) {
  auto out = read_any(text, options);
  if (out.size() > kMostJoints)
    refuse({1, "the file", fmt::format("{} bushings", out.size())}, "holds too many",
           fmt::format("up to {}", kMostJoints));
  return out;
}

}  // namespace halfway::imports
