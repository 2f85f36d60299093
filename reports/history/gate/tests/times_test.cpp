// Times of programs that are shell scripts: what is slower is found, noise is not, what fails is named.
#include "reports/cli/errors.hpp"
#include "reports/history/gate/judge.hpp"
#include "reports/history/gate/tests/fake.hpp"
#include "reports/views/files.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <sstream>

using namespace halfway;
using namespace halfway::gate;
using namespace halfway::gate::test;

namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void silent(int, int, const std::string&) {}

struct Trial {
  Scratch scratch{};
  fs::path base, head;
  TimeRules rules{};
  std::optional<double> base_count{}, head_count{};

  explicit Trial(const std::string& change, const std::string& first = "",
                 const std::string& base_change = "") {
    base = fake_program(scratch.folder(), "base", base_change);
    head = fake_program(scratch.folder(), "headd", change, first);  // another length: another seed
  }

  Outcome run() {
    const Side a{"base", "0123456789abcdef", {base}}, b{"head", "", {head}};
    Journal journal(scratch.folder() / "journal", {{"about", "this"}});
    const Measured m = measure_times(journal, a, b, {.filter = "."}, rules, 0, scratch.folder(), silent);
    return judge(m, a, b, rules, [&](const Side& side, const std::string&) {
      return side.name == "base" ? base_count : head_count;
    });
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(times)

BOOST_AUTO_TEST_CASE(noise_is_no_regression) {
  Trial trial("");
  const Outcome outcome = trial.run();
  BOOST_TEST(outcome.lines.empty());
  BOOST_TEST(outcome.compared == 3);
  BOOST_TEST(starts(trial.base) == 9);
  BOOST_TEST(starts(trial.head) == 9);
}

BOOST_AUTO_TEST_CASE(slower_is_found_and_measured_again) {
  Trial trial("time[\"b\"] *= 1.1");
  const Outcome outcome = trial.run();
  BOOST_REQUIRE(outcome.lines.size() == 1u);
  BOOST_TEST((outcome.lines[0].sense == Sense::regression));
  BOOST_TEST(outcome.lines[0].figure == "b");
  for (const char* part : {"time ", " ns (+", "since base (0123456789ab)", "p = 2e-05", "with fresh pairs +"})
    BOOST_TEST(has(outcome.lines[0].text, part), outcome.lines[0].text);
  BOOST_TEST(starts(trial.head) == 18);
}

// One of three layouts is 30 % slower on its own: its samples would hide a change of 10 % from ranks.
BOOST_AUTO_TEST_CASE(a_slow_layout_is_set_aside) {
  const std::vector<int> layouts{0, 1, 2, 0, 1, 2, 0, 1, 2};
  const std::vector<double> base{100, 101, 130, 101, 100, 131, 102, 101, 130};
  std::vector<double> head;
  for (const double ns : base) head.push_back(ns < 120 ? 1.1 * ns : ns / 1.18);  // all its layouts about 110
  const TimeRules rules{};
  BOOST_TEST(!is_slower(compared(base, head), rules, rules.least));
  const auto kept = of_usual_layouts(base, layouts);
  BOOST_TEST(kept == (std::vector<double>{100, 101, 101, 100, 102, 101}), boost::test_tools::per_element());
  BOOST_TEST(of_usual_layouts(head, layouts).size() == 9u);
  BOOST_TEST(is_slower(compared(kept, of_usual_layouts(head, layouts)), rules, rules.least));
  // What moves all layouts stays, as does a single one, and a time that is missing.
  BOOST_TEST(of_usual_layouts({100, 109, 108}, {0, 1, 2}).size() == 3u);
  BOOST_TEST(of_usual_layouts({100, 900}, {0, 0}).size() == 2u);
  const double missing = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(of_usual_layouts({100, missing, 101}, {0, 1, 2}).size() == 3u);
}

BOOST_AUTO_TEST_CASE(faster_is_an_improvement) {
  const Outcome outcome = Trial("time[\"b\"] *= 0.9").run();
  BOOST_REQUIRE(outcome.lines.size() == 1u);
  BOOST_TEST((outcome.lines[0].sense == Sense::improvement));
}

// Certain, and below what counts; above it, and within what layouts do to the figure.
BOOST_AUTO_TEST_CASE(small_is_none) {
  BOOST_TEST(Trial("time[\"b\"] *= 1.022").run().lines.empty());
  Trial trial("time[\"b\"] *= 1.06");
  trial.rules.allowed["b"] = 0.08;
  BOOST_TEST(trial.run().lines.empty());
  trial.rules.allowed["b"] = 0.01;  // never less than 3 %
  BOOST_TEST(trial.run().lines.size() == 1u);
}

// The median is 6 % higher, and three of nine are far below: no ranks say that.
BOOST_AUTO_TEST_CASE(unsure_is_none) {
  BOOST_TEST(Trial("time[\"b\"] *= seed % 3 == 0 ? 0.5 : 1.06").run().lines.empty());
}

// The first nine processes were disturbed, the fresh ones were not.
BOOST_AUTO_TEST_CASE(alarm_that_does_not_come_again) {
  const Outcome outcome = Trial("if (seed <= 9) time[\"b\"] *= 1.1").run();
  BOOST_TEST(outcome.lines.empty());
  BOOST_REQUIRE(outcome.notes.size() == 1u);
  BOOST_TEST(has(outcome.notes[0], "no alarm"));
}

// Fresh pairs need not be as sure as the first ones, but they must be slower, and both together certain.
BOOST_AUTO_TEST_CASE(what_comes_again_counts) {
  const TimeRules rules{};
  const std::vector<double> still{100, 101, 102, 100, 101, 102, 100, 101, 102};
  const auto times = [](std::vector<double> all, double factor) {
    for (double& ns : all) ns *= factor;
    return all;
  };
  const Samples first{.base = still, .head = times(still, 1.1)};
  const auto counts = [&](const Samples& again, double allowed = 0.03) {
    return comes_again(first, again, rules, allowed);
  };
  BOOST_TEST(counts({.base = still, .head = times(still, 1.1)}));
  const std::vector<double> six(still.begin(), still.begin() + 6);  // a layout set aside: ranks reach 0.0011
  const Samples few{.base = six, .head = times(six, 1.1)};
  BOOST_TEST(compared(few.base, few.head).slower > rules.chance);
  BOOST_TEST(counts(few));
  BOOST_TEST(!counts({.base = still, .head = still}));
  BOOST_TEST(!counts({.base = still, .head = times(still, 1.1)}, 0.12));
  // A little slower and sure of it: both rounds together are within what is allowed.
  BOOST_TEST(!counts({.base = still, .head = times(still, 1.025)}, 0.08));
  BOOST_TEST(!counts({}));
}

BOOST_AUTO_TEST_CASE(instructions_tell_layout_from_work) {
  Trial trial("time[\"b\"] *= 1.1");
  trial.base_count = 1000, trial.head_count = 1001;
  BOOST_TEST(has(trial.run().lines.at(0).text, "instructions +0.1 %: layout or machine"));
  trial.head_count = 1100;
  const std::string text = trial.run().lines.at(0).text;
  BOOST_TEST(has(text, "instructions +10.0 %,"));
  BOOST_TEST(!has(text, "layout"));
}

BOOST_AUTO_TEST_CASE(not_measured_is_a_regression) {
  for (const char* nan : {"time[\"b\"] = \"NaN\"", "time[\"b\"] = 0", "time[\"b\"] = \"null\"",
                          "time[\"b\"] = \"-Infinity\""}) {
    const Outcome outcome = Trial(nan).run();
    BOOST_TEST_CONTEXT(nan) {
      BOOST_REQUIRE(outcome.lines.size() == 1u);
      BOOST_TEST((outcome.lines[0].sense == Sense::regression));
      BOOST_TEST(has(outcome.lines[0].text, "not measured: a time of "));
    }
  }
  const Outcome gone = Trial("delete time[\"b\"]").run();
  BOOST_REQUIRE(gone.lines.size() == 1u);
  BOOST_TEST(has(gone.lines[0].text, "gone"));
  const Outcome fresh = Trial("", "", "delete time[\"b\"]").run();
  BOOST_REQUIRE(fresh.lines.size() == 1u);
  BOOST_TEST((fresh.lines[0].sense == Sense::change));
}

BOOST_AUTO_TEST_CASE(digits_of_what_was_timed) {
  const Outcome outcome = Trial("error[\"b\"] = \"1e-12\"").run();
  BOOST_REQUIRE(outcome.lines.size() == 1u);
  BOOST_TEST(outcome.lines[0].text == "error 1e-16 -> 1e-12, 3.7 digits lost");
}

BOOST_AUTO_TEST_CASE(programs_that_fail_are_named) {
  const auto complaint = [](const char* first, const char* change = "") {
    try {
      Trial(change, first).run();
      return std::string("passed");
    } catch (const reports::FailedRun& error) {
      return std::string(error.what());
    }
  };
  const std::string crash = complaint("kill -SEGV $$");
  BOOST_TEST(has(crash, "headd/halfway_bench ended by signal 11"), crash);
  BOOST_TEST(has(complaint("echo out of order >&2; exit 3"), "ended with exit code 3: out of order"));
  BOOST_TEST(has(complaint("exit 0"), "wrote no JSON"));
  BOOST_TEST(has(complaint("", "print \"}\""), "no JSON of Google Benchmark"));
  BOOST_TEST(has(complaint("", "delete time; "), "measured nothing"));
}

BOOST_AUTO_TEST_CASE(hung_program_is_ended) {
  const Scratch scratch;
  const fs::path program = fake_program(scratch.folder(), "base", "", "exec sleep 60");
  BOOST_CHECK_EXCEPTION(measure(program, {.filter = ".", .time_limit = 0.2}, scratch.folder()),
                        reports::FailedRun,
                        [](const auto& e) { return has(e.what(), "took longer than 0.2 s"); });
}

BOOST_AUTO_TEST_CASE(goes_on_where_it_stopped) {
  Trial trial("", "[ \"$seed\" -ne 4 ] || exit 1");  // the fourth start fails
  BOOST_CHECK_THROW(trial.run(), reports::FailedRun);
  const int first = starts(trial.base);
  BOOST_TEST(first >= 3);
  BOOST_TEST(trial.run().compared == 3);
  BOOST_TEST(starts(trial.base) == 9);  // nothing twice
  BOOST_TEST(starts(trial.head) == 10);
  trial.run();
  BOOST_TEST(starts(trial.base) == 9);
}

BOOST_AUTO_TEST_CASE(journal_cut_short_or_of_another_comparison) {
  const Scratch scratch;
  const fs::path file = scratch.folder() / "journal";
  const Reading reading{{"a", {1.5, std::nan("")}}, {"b", {.wrong = "no \"reason\""}}};
  {
    Journal journal(file, {{"about", 1}});
    journal.add({0, 0, 0, false}, reading), journal.add({0, 0, 0, true}, reading);
  }
  const std::string whole = reports::read_file(file);
  for (std::size_t cut = 1; cut < 60; ++cut) {
    reports::write_file(file, whole.substr(0, whole.size() - cut));
    Journal journal(file, {{"about", 1}});
    BOOST_TEST(journal.size() == 1u);
    const Reading& kept = *journal.find({0, 0, 0, false});
    BOOST_TEST(kept.at("a").ns == 1.5);
    BOOST_TEST(std::isnan(kept.at("a").error));
    BOOST_TEST(kept.at("b").wrong == "no \"reason\"");
  }
  BOOST_TEST(Journal(file, {{"about", 2}}).size() == 0u);
}

// Every layout of one side meets every one of the other, and either side goes first as often.
BOOST_AUTO_TEST_CASE(layouts_take_turns) {
  const Scratch scratch;
  Side a{"a", "", {}}, b{"b", "", {}};
  const std::string log = "echo $0 >>" + (scratch.folder() / "log").string();
  for (const char* name : {"1", "2", "3"}) {
    a.programs.push_back(fake_program(scratch.folder() / "a", name, "", log));
    b.programs.push_back(fake_program(scratch.folder() / "b", name, "", log));
  }
  Journal journal(scratch.folder() / "journal", {});
  measure_round(journal, a, b, {.filter = "."}, 0, 0, 9, scratch.folder(), silent);
  for (const Side* side : {&a, &b})
    for (const auto& program : side->programs) BOOST_TEST(starts(program) == 3);
  std::istringstream started(reports::read_file(scratch.folder() / "log"));
  std::set<std::set<std::string>> pairs;
  for (std::string one, other; started >> one >> other;) pairs.insert({one, other});
  BOOST_TEST(pairs.size() == 9u);
  std::istringstream lines(reports::read_file(scratch.folder() / "journal"));
  std::string line, order;
  std::getline(lines, line);
  while (std::getline(lines, line)) order += nlohmann::json::parse(line).at("head") ? 'B' : 'A';
  BOOST_TEST(order == "ABBAABBAABBAABBAAB");
}

// Rows as Google Benchmark writes them: the least repetition counts, aggregates do not, units do.
BOOST_AUTO_TEST_CASE(rows) {
  const Reading r = read_benchmarks(R"({"benchmarks": [
    {"name": "a", "run_name": "a", "run_type": "iteration", "cpu_time": 3, "time_unit": "us"},
    {"name": "a", "run_name": "a", "run_type": "iteration", "cpu_time": 2, "time_unit": "us"},
    {"name": "a_mean", "run_name": "a", "run_type": "aggregate", "cpu_time": 1, "time_unit": "us"},
    {"name": "b", "cpu_time": 512, "time_unit": "ns", "per_evaluation": 2e-9, "max_error": 1e-15},
    {"name": "c", "cpu_time": 1, "error_occurred": true, "error_message": "is wrong"},
    {"name": "d", "cpu_time": 5}, {"name": "d", "cpu_time": nan}]})",
                                    "text");
  BOOST_TEST(r.size() == 4u);
  BOOST_TEST(r.at("a").ns == 2000);
  BOOST_TEST(r.at("b").ns == 2.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(r.at("b").error == 1e-15);
  BOOST_TEST(r.at("c").wrong == "is wrong");
  BOOST_TEST(std::isnan(r.at("d").ns));  // one repetition that is no number spoils the others
  BOOST_TEST(filter_of({"a/b.c", "d"}) == "^(a/b\\.c|d)$");
}

BOOST_AUTO_TEST_SUITE_END()
