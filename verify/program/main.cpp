// Runs the checks under Boost.Test, one test case per check, and prints what each measured.
//   halfway_verify                  all checks
//   halfway_verify --check NAME     one check
//   halfway_verify --room NAME      the checks of a room, where a study's numbers are computed once, in
//   processes apart halfway_verify --room NAME --keep FILE   the same, records into a file; whatever they
//   say, exit code 0 halfway_verify --kept FILE --check NAME  one check's record (ctest: a room is run once,
//   its checks read from it) halfway_verify --list           "room name" of each check halfway_verify
//   --sabotage NAME[:FORMULATION] --check NAME
//                                   one check of a wrong twin, which it should catch (exit code 1)
#define BOOST_TEST_NO_MAIN
#define BOOST_TEST_DYN_LINK
#include <boost/test/unit_test.hpp>

#include "verify/check.hpp"
#include "verify/oracle/saboteurs/trial.hpp"
#include "verify/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>

namespace {

using halfway::verify::Check;
using halfway::verify::Checks;
using halfway::verify::Record;
using halfway::verify::record_of;

void run(const Check& check) {
  const Record record = record_of(check);
  std::fputs(record.text.c_str(), stdout);
  BOOST_TEST(record.passed, record.text);
}

/// Boost.Test reads '/' in a name as a path of suites: each part but the last becomes a suite.
void add(const Check& check) {
  using namespace boost::unit_test;
  static std::map<std::string, test_suite*> suites;
  test_suite* suite = &framework::master_test_suite();
  std::string path, rest = check.name;
  for (std::size_t slash; (slash = rest.find('/')) != std::string::npos; rest = rest.substr(slash + 1)) {
    path += rest.substr(0, slash) + "/";
    test_suite*& child = suites[path];
    if (child == nullptr) {
      child = BOOST_TEST_SUITE(rest.substr(0, slash));
      suite->add(child);
    }
    suite = child;
  }
  suite->add(make_test_case([check] { run(check); }, rest, __FILE__, __LINE__));
}

std::string only;  // set by --check

bool init() {
  boost::unit_test::framework::master_test_suite().p_name.value = "verify";
  bool found = only.empty();
  for (const Check& check : halfway::verify::all_checks()) {
    if (!only.empty() && check.name != only) continue;
    add(check);
    found = true;
  }
  if (!found) std::fprintf(stderr, "halfway_verify: no check is called '%s'; see --list\n", only.c_str());
  return found;
}

/// Exit code 1: caught, as it should be; 0: the check passes all the same; 2: it crashed, or hung.
int run_sabotaged(const std::string& what, const std::string& name) {
  using namespace halfway::verify;
  const std::size_t colon = std::min(what.find(':'), what.size());
  const Saboteur* saboteur = find_saboteur(what.substr(0, colon));
  if (saboteur == nullptr) {
    std::fprintf(stderr, "halfway_verify: no saboteur is called '%s'; there are:\n", what.c_str());
    for (const Saboteur& s : saboteurs()) fmt::print(stderr, "  {:18} {}\n", s.name, s.does);
    return 2;
  }
  const std::string formulation = what.substr(std::min(colon + 1, what.size()));
  if (!formulation.empty() && halfway::reference::find_formulation(formulation) == nullptr)
    throw std::runtime_error("no formulation is called '" + formulation + "'");
  const ScopedSabotage guard(*saboteur, formulation);
  const Checks checks = all_checks();
  const auto check = std::ranges::find(checks, name, &Check::name);
  if (check == checks.end()) throw std::runtime_error("no check is called '" + name + "'; see --list");
  constexpr int kSeconds = 120;
  const Trial trial = run_apart(*check, kSeconds);
  fmt::print("{} {} {}{}\n", check->name, to_string(trial.outcome), what,
             trial.by.empty() ? "" : ": " + trial.by);
  return trial.caught() ? 1 : trial.outcome == Outcome::passed ? 0 : 2;
}

/// A guard against what hangs: the longest check takes half a minute, a watched one on a busy machine ten
/// times that.
constexpr int kSilence = 300;

/// All of a room, or none: that is refused.
Checks checks_of(const std::string& room) {
  Checks checks = halfway::verify::all_checks();
  std::erase_if(checks, [&](const Check& check) { return check.label != room; });
  if (checks.empty()) throw std::runtime_error("no room is called '" + room + "'; see --list");
  return checks;
}

int show_room(const std::string& room) {
  std::size_t all = 0, failed = 0;
  halfway::verify::run_apart_each(checks_of(room), kSilence, [&](const Record& record) {
    ++all;
    failed += !record.passed;
    std::fputs(record.text.c_str(), stdout);
  });
  fmt::print("{}: {} of {} checks failed\n", room, failed, all);
  return failed > 0;
}

int show_kept(const char* file, const char* check) {
  const Record record = halfway::verify::kept(file, check);
  std::fputs(record.text.c_str(), stdout);
  return record.passed ? 0 : 1;
}

int run_main(int argc, char** argv) {
  const auto is = [&](int i, const char* word) { return argc > i && std::strcmp(argv[i], word) == 0; };
  if (argc == 5 && is(1, "--kept") && is(3, "--check")) return show_kept(argv[2], argv[4]);
  halfway::reference::complete_catalog();
  if (argc == 3 && is(1, "--room")) return show_room(argv[2]);
  if (argc == 5 && is(1, "--room") && is(3, "--keep")) {
    halfway::verify::keep(checks_of(argv[2]), kSilence, argv[4]);
    return 0;
  }
  if (argc == 5 && is(1, "--sabotage") && is(3, "--check")) return run_sabotaged(argv[2], argv[4]);
  if (is(1, "--list")) {
    for (const Check& check : halfway::verify::all_checks()) fmt::print("{} {}\n", check.label, check.name);
    return 0;
  }
  if (argc > 2 && is(1, "--check")) {
    only = argv[2];
    argv[2] = argv[0];
    argc -= 2;
    argv += 2;
  }
  return boost::unit_test::unit_test_main(&init, argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_main(argc, argv);
  } catch (const std::exception& e) {  // a scene or data file that cannot be read
    std::fprintf(stderr, "halfway_verify: %s\n", e.what());
    return 2;
  }
}
