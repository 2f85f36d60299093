// BASE and HEAD: programs, folders, and the commits of a small repository.
#include "reports/history/gate/sides.hpp"
#include "reports/cli/errors.hpp"
#include "reports/history/gate/process.hpp"
#include "reports/history/gate/tests/fake.hpp"
#include "reports/views/files.hpp"

#include <boost/test/unit_test.hpp>

using namespace halfway;
using namespace halfway::gate;
using namespace halfway::gate::test;

namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void git(const fs::path& source, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", source.string(), "-c", "user.name=t", "-c", "user.email=t@t"});
  BOOST_TEST_REQUIRE(run(words, source.parent_path() / "git.log", 60) == "");
}

/// A repository whose halfway_bench has three functions that end with exit code 3.
void make_repository(const fs::path& source) {
  reports::write_file(source / "CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.25)\nproject(small LANGUAGES CXX)\n"
                      "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)\n"
                      "add_executable(halfway_bench main.cpp)\n");
  reports::write_file(source / "CMakePresets.json",
                      R"({"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja",
                          "binaryDir": "${sourceDir}/build", "cacheVariables": {"CMAKE_BUILD_TYPE": "Release"}}]})");
  reports::write_file(source / "main.cpp",
                      "int one(int x) { return x; }\nint two(int x) { return x + 1; }\n"
                      "int main() { return one(1) + two(1); }\n");
  reports::write_file(source / "reports/history/gate/layouts.sh", reports::read_file(HALFWAY_LAYOUTS));
  git(source, {"init", "-q"});
  git(source, {"add", "."});
  git(source, {"commit", "-q", "-m", "one"});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(sides)

BOOST_AUTO_TEST_CASE(sides_by_what_they_are) {
  const Scratch scratch;
  const Places places{scratch.folder(), scratch.folder() / "out", 3};  // no repository
  const fs::path program = fake_program(scratch.folder() / "layouts", "1");
  BOOST_TEST((find_side(program, places).programs == std::vector{program}));
  fake_program(scratch.folder() / "layouts", "2");
  BOOST_TEST(find_side(scratch.folder() / "layouts", places).programs.size() == 2u);
  for (const char* unknown : {"no-such-commit", "-h", "/nowhere/at/all"}) {
    BOOST_CHECK_EXCEPTION(find_side(unknown, places), reports::BadInput, [&](const auto& e) {
      return has(e.what(), std::string("'") + unknown + "' is no commit");
    });
  }
}

// A commit is built once, apart from the tree, its layouts differ; what does not compile is one line.
BOOST_AUTO_TEST_CASE(commits_are_built) {
  const Scratch scratch;
  const fs::path source = scratch.folder() / "repository";
  make_repository(source);
  const Places places{source, scratch.folder() / "out", 2};
  const Side side = find_side("HEAD", places);
  BOOST_TEST(side.commit.size() == 40u);
  BOOST_TEST(side.commit == commit_of("", source));
  BOOST_REQUIRE(side.programs.size() == 2u);
  BOOST_TEST(reports::read_file(side.programs[0]) != reports::read_file(side.programs[1]));
  for (const fs::path& program : side.programs)
    BOOST_TEST(has(run({program.string()}, scratch.folder() / "log", 10), "exit code 3"));
  const auto made = fs::last_write_time(side.programs[0]);
  BOOST_TEST((find_side("HEAD", places).programs == side.programs));
  BOOST_TEST((fs::last_write_time(side.programs[0]) == made));

  reports::write_file(source / "main.cpp", "int main() { return none; }\n");
  git(source, {"commit", "-q", "-a", "-m", "two"});
  BOOST_CHECK_EXCEPTION(find_side("HEAD", places), reports::FailedRun, [](const auto& e) {
    return has(e.what(), "building ") && has(e.what(), "build.log");
  });
  BOOST_TEST(find_side("HEAD~1", places).commit == side.commit);
  // The tree as it is: built again when it changes.
  reports::write_file(source / "main.cpp", "int main() { return 4; }\n");
  BOOST_TEST(
      has(run({find_side("", places).programs.at(1).string()}, scratch.folder() / "log", 10), "code 4"));
  reports::write_file(source / "main.cpp", "int main() { return 5; }\n");
  BOOST_TEST(
      has(run({find_side("", places).programs.at(1).string()}, scratch.folder() / "log", 10), "code 5"));
}

BOOST_AUTO_TEST_SUITE_END()
