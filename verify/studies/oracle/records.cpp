// A room is run in one process: a check that ends it, stops answering or says nothing is recorded as that,
// and costs no other check its record.
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/record.hpp"

#include <unistd.h>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace halfway::verify {
namespace {

std::vector<Finding> passing() {
  return {finding("a").measured(0.25).at_most(1, "a quarter").by(Oracle::closed_form)};
}

std::vector<Finding> failing() {
  return {finding("a").measured(2).at_most(1, "two is more").by(Oracle::closed_form)};
}

struct Expected {
  Check check;
  bool passes;
  std::string says;  ///< part of its record's text
};

std::vector<Expected> expected() {
  const auto is = [](const char* name, std::function<std::vector<Finding>()> run, bool passes,
                     const char* says) {
    return Expected{{name, "trial", std::move(run)}, passes, says};
  };
  return {is("first", passing, true, "pass: a 0.25"),
          is(
              "crash", [] { return raise(SIGKILL), passing(); }, false, "crashed with signal 9"),
          is("after/a \"crash\"", passing, true, "pass: a 0.25"),
          is("fails", failing, false, "fail: a 2"),
          is(
              "throws", []() -> std::vector<Finding> { throw std::runtime_error("no data"); }, false,
              "threw: no data"),
          is(
              "leaves", []() -> std::vector<Finding> { _exit(0); }, false, "ended the program, exit code 0"),
          is(
              "hangs",
              [] {
                std::this_thread::sleep_for(std::chrono::minutes(10));
                return passing();
              },
              false, "was silent for 1 s"),
          is(
              "empty", [] { return std::vector<Finding>{}; }, false, "measured nothing"),
          is("last", passing, true, "pass: a 0.25")};
}

bool agrees(const Record& record, const Expected& e) {
  return record.check == e.check.name && record.passed == e.passes &&
         record.text.find(e.says) != std::string::npos;
}

/// Records that are not what they should be, of those handed on and of those kept in a file.
std::vector<Finding> apart() {
  const auto all = expected();
  Checks checks;
  for (const Expected& e : all) checks.push_back(e.check);
  const auto file = std::filesystem::temp_directory_path() / ("halfway_records_" + std::to_string(getpid()));
  keep(checks, 1, file);
  double wrong = 0;
  for (const Expected& e : all) wrong += !agrees(kept(file, e.check.name), e);
  const auto refused = [&](const std::filesystem::path& from, const char* check, const char* says) {
    try {
      kept(from, check);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).find(says) != std::string::npos;
    }
    return false;
  };
  wrong += !refused(file, "of another room", "has no record of 'of another room'");
  std::filesystem::remove(file);
  wrong += !refused(file, "first", "cannot be read");
  try {
    keep(checks, 1, file / "in no folder");
    ++wrong;
  } catch (const std::runtime_error& error) {
    wrong += std::string(error.what()).find("cannot be written") == std::string::npos;
  }
  return {
      finding("records/apart")
          .about("records")
          .measured(tapped(wrong))
          .in("wrong records")
          .at_most(0, "nine checks whose ends are known, two that have no record, and a file in no folder")
          .by(Oracle::closed_form)};
}

/// Two findings of one name are found, wherever they stand, and said.
std::vector<Finding> twice() {
  const auto named = [](const char* name) { return Finding(finding(name).reported("nothing")); };
  const Finding once = reference::named_once({named("a/b"), named("a"), named("b")});
  const Finding two = reference::named_once({named("a/b"), named("a"), named("b"), named("a/b")});
  const int wrong = (once.verdict != Verdict::pass) + (two.verdict != Verdict::fail) + (two.value != 1) +
                    (two.parameter != "a/b");
  return {finding("records/twice")
              .about("records")
              .measured(tapped(double(wrong)), two.parameter)
              .in("wrong answers")
              .at_most(0, "a name given twice fails and is said; three names given once pass")
              .by(Oracle::closed_form)};
}

}  // namespace

void records(Checks& checks) {
  checks.push_back({"records/apart", {}, apart});
  checks.push_back({"records/twice", {}, twice});
}

}  // namespace halfway::verify
