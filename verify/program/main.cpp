// Runs the checks under Boost.Test, one test case per check, and prints what each measured.
//   halfway_verify                  all checks
//   halfway_verify --check NAME     one check (what ctest calls)
//   halfway_verify --room NAME      the checks of one room, in one process: a study's numbers are computed
//   once halfway_verify --list           "room name" of each check halfway_verify --sabotage
//   NAME[:FORMULATION] --check NAME
//                                   one check of a wrong twin, which it should catch (exit code 1)
#define BOOST_TEST_NO_MAIN
#define BOOST_TEST_DYN_LINK
#include <boost/test/unit_test.hpp>

#include "verify/check.hpp"
#include "verify/oracle/saboteurs/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>

namespace {

using halfway::verify::Check;
using halfway::verify::Comparison;
using halfway::verify::Finding;
using halfway::verify::Verdict;

std::string limits(const Finding& f) {
  switch (f.comparison) {
    case Comparison::at_most:
      return fmt::format("limit {:.3g}", f.high);
    case Comparison::at_least:
      return fmt::format("at least {:.3g}", f.low);
    case Comparison::within:
      return fmt::format("band {:.3g} ... {:.3g}", f.low, f.high);
    case Comparison::equal:
      return fmt::format("expected {:.17g} +- {:.3g}", f.expected, f.high);
    default:
      return "reported";
  }
}

std::string line(const Finding& f) {
  const std::string why = missing(f);
  return fmt::format("{}: {} {:.17g} {} ({}; {}){} {}{}", to_string(f.verdict), f.name, f.value, f.unit,
                     limits(f), to_string(f.oracle), why.empty() ? "" : " " + why + ";",
                     f.parameter.empty() ? "" : "worst at " + f.parameter,
                     f.reason.empty() ? "" : "; " + f.reason);
}

/// A request is one line of JSON, a scene is a file.
void print_replay(const std::string& replay) {
  if (replay.starts_with('{'))
    fmt::print("replay: echo '{}' | ./halfway eval\n", replay);
  else
    fmt::print("replay: ./halfway run replay.toml, with the file\n{}\n", replay);
}

void run(const Check& check) {
  const auto findings = check.run();
  BOOST_TEST(!findings.empty(), check.name << " measured nothing");
  for (const Finding& f : findings) {
    std::puts(line(f).c_str());
    if (f.verdict == Verdict::fail && !f.replay.empty()) print_replay(f.replay);
    if (std::isfinite(f.value)) {
      fmt::print("<CTestMeasurement type=\"numeric/double\" name=\"{}\">{:.17g}</CTestMeasurement>\n", f.name,
                 f.value);
    }
    BOOST_TEST((f.verdict != Verdict::fail), line(f));
  }
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

/// Which checks are run: all, or those whose member (name or label) has this value.
struct Choice {
  std::string Check::*member = nullptr;
  std::string value{};
} chosen;  // set by --check and --room

bool init() {
  boost::unit_test::framework::master_test_suite().p_name.value = "verify";
  bool found = false;
  for (const Check& check : halfway::verify::all_checks()) {
    if (chosen.member != nullptr && check.*chosen.member != chosen.value) continue;
    add(check);
    found = true;
  }
  if (!found)
    std::fprintf(stderr, "halfway_verify: no check or room is called '%s'; see --list\n",
                 chosen.value.c_str());
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

int run_main(int argc, char** argv) {
  halfway::reference::complete_catalog();
  if (argc == 5 && std::strcmp(argv[1], "--sabotage") == 0 && std::strcmp(argv[3], "--check") == 0)
    return run_sabotaged(argv[2], argv[4]);
  if (argc > 1 && std::strcmp(argv[1], "--list") == 0) {
    for (const Check& check : halfway::verify::all_checks()) fmt::print("{} {}\n", check.label, check.name);
    return 0;
  }
  const bool room = argc > 2 && std::strcmp(argv[1], "--room") == 0;
  if (room || (argc > 2 && std::strcmp(argv[1], "--check") == 0)) {
    chosen = {room ? &Check::label : &Check::name, argv[2]};
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
