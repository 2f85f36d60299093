// Folders of results: tried before the work, written by one process at a time.
#include "reports/views/files.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <boost/test/unit_test.hpp>

#include <functional>

using namespace halfway::reports;

namespace {

struct Fixture {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("halfway_folders_" + std::to_string(getpid()));
  Fixture() { std::filesystem::create_directories(folder); }
  ~Fixture() { std::filesystem::remove_all(folder); }
};

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

/// A process that locks the folder, says so, and stays until it is killed.
pid_t holder(const std::filesystem::path& folder) {
  int ends[2];
  BOOST_REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const FolderLock lock(folder);
    if (::write(ends[1], "!", 1) == 1) ::pause();
    ::_exit(1);
  }
  char said = 0;
  BOOST_REQUIRE(::read(ends[0], &said, 1) == 1);
  ::close(ends[0]), ::close(ends[1]);
  return child;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(folders)

BOOST_FIXTURE_TEST_CASE(tried_before_the_work, Fixture) {
  BOOST_TEST(refusal([&] { try_folder(folder / "new" / "newer"); }) == "");
  BOOST_TEST(std::filesystem::is_empty(folder / "new" / "newer"));
  write_file(folder / "file", "text");
  BOOST_TEST(refusal([&] { try_folder(folder / "file"); }).find("cannot be a folder") != std::string::npos);
  BOOST_TEST(refusal([&] { try_folder(folder / "file" / "below"); }) != "");
  BOOST_TEST(refusal([&] { try_folder("/proc/halfway"); }) != "");
}

BOOST_FIXTURE_TEST_CASE(one_writer_at_a_time, Fixture) {
  const pid_t other = holder(folder);
  const std::string said = refusal([&] { FolderLock lock(folder); });
  BOOST_TEST(said.find("process " + std::to_string(other)) != std::string::npos, said);
  ::kill(other, SIGKILL);
  ::waitpid(other, nullptr, 0);
  // A lock whose owner was killed locks nobody out; one that ended leaves nothing.
  BOOST_TEST(refusal([&] { FolderLock lock(folder); }) == "");
  BOOST_TEST(std::filesystem::is_empty(folder));
}

BOOST_AUTO_TEST_SUITE_END()
