#include "reports/history/gate/sides.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/history/gate/process.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <sstream>

namespace halfway::gate {
namespace {

namespace fs = std::filesystem;

constexpr double kBuildLimit = 7200;  // s

bool is_program(const fs::path& path) {
  return fs::is_regular_file(path) && ::access(path.c_str(), X_OK) == 0;
}

std::vector<fs::path> programs_in(const fs::path& folder) {
  for (const char* name : {"bin/halfway_bench", "halfway_bench", "bin/halfway-suite"})
    if (is_program(folder / name)) return {folder / name};
  std::vector<fs::path> out;
  for (int i = 1; is_program(folder / std::to_string(i) / "halfway_bench"); ++i)
    out.push_back(folder / std::to_string(i) / "halfway_bench");
  return out;
}

/// What git prints; empty when it fails.
std::string git(const fs::path& source, std::vector<std::string> words) {
  const fs::path log = fs::temp_directory_path() / fmt::format("halfway_git_{}", ::getpid());
  words.insert(words.begin(), {"git", "-C", source.string()});
  const bool worked = run(words, log, 600).empty();
  std::string text = worked ? reports::read_file(log) : "";
  fs::remove(log);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::vector<fs::path> layouts_of(const fs::path& source, const fs::path& folder, const Places& places) {
  fs::create_directories(folder);
  reports::tell(fmt::format("building {} layouts below {}\n", places.layouts, folder.string()));
  const std::string failed = run({"sh", places.source / "reports/history/gate/layouts.sh", source, folder,
                                  std::to_string(places.layouts)},
                                 folder / "layouts.log", kBuildLimit);
  if (!failed.empty()) throw reports::FailedRun(fmt::format("building {} {}", source.string(), failed));
  auto programs = programs_in(folder);
  if (int(programs.size()) > places.layouts) programs.resize(std::size_t(places.layouts));
  return programs;
}

Side built(const std::string& name, const std::string& commit, const Places& places) {
  const fs::path folder = places.out / commit.substr(0, 12), source = folder / "source";
  fs::create_directories(folder);
  const reports::FolderLock lock(folder);
  if (!fs::exists(source / "CMakeLists.txt")) {
    const std::string failed = run({"git", "-C", places.source, "worktree", "add", "--force", "--force",
                                    "--detach", fs::absolute(source), commit},
                                   folder / "worktree.log", 600);
    if (!failed.empty()) throw reports::FailedRun(fmt::format("a work tree of {} {}", name, failed));
  }
  return {name, commit, layouts_of(source, folder / "layouts", places)};
}

}  // namespace

std::string commit_of(const std::string& name, const fs::path& source) {
  if (name.starts_with('-')) return "";
  return git(source, {"rev-parse", "--verify", "--quiet", (name.empty() ? "HEAD" : name) + "^{commit}"});
}

Side find_side(const std::string& text, const Places& places) {
  if (text.empty()) return {"this tree", "", layouts_of(places.source, places.out / "tree", places)};
  if (is_program(text)) return {text, "", {text}};
  if (fs::is_directory(text)) {
    auto programs = programs_in(text);
    if (!programs.empty()) return {text, "", programs};
  }
  const std::string commit = commit_of(text, places.source);
  if (commit.empty())
    throw reports::BadInput(fmt::format(
        "'{}' is no commit of {}, no benchmark program and no folder with bin/halfway_bench in it", text,
        places.source.string()));
  return built(text, commit, places);
}

std::optional<double> instructions(const Side& side, const std::string& figure, const fs::path& folder) {
  const fs::path beside = side.programs[0].parent_path();
  const fs::path build = beside.parent_path() / "build";
  fs::path program = beside / "halfway_instructions";
  if (!is_program(program) && fs::exists(build / "build.ninja")) {
    program = build / "bin/halfway_instructions";
    if (!run({"ninja", "-C", build, "halfway_instructions"}, folder / "instructions.log", kBuildLimit)
             .empty())
      return std::nullopt;
  }
  const fs::path log = folder / "instructions.log";
  if (!is_program(program) || !run({program, "count", figure}, log, 600).empty()) return std::nullopt;
  std::istringstream text(reports::read_file(log));
  std::string name;
  double count = 0;
  return text >> name >> count && name == figure && count > 0 ? std::optional(count) : std::nullopt;
}

}  // namespace halfway::gate
