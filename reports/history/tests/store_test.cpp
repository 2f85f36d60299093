// What goes in comes out; what holds is worked out from what changed.
#include "reports/history/store/store.hpp"
#include "reports/history/tests/support.hpp"

#include <boost/test/unit_test.hpp>

using namespace halfway::history;
using namespace halfway::history::test;

namespace {

std::size_t change_rows(const History& history) {
  std::size_t out = 0;
  for (const auto& changes : history.changes) out += changes.size();
  return out;
}

double value(const History& history, int run, const std::string& name) {
  const Record record = record_at(history, run);
  return record.exact.contains(name) ? record.exact.at(name).reading.value : kNone;
}

Record with(Record record, const std::string& name, double value) {
  record.exact.at(name).reading.value = value;
  return record;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(store)

BOOST_AUTO_TEST_CASE(a_run_comes_back) {
  const TemporaryFolder folder;
  Record one = record(1);
  one.run.release = "1.0", one.run.dirty = true;
  one.exact["e1"].reading = {.value = kNone,
                             .comparison = Comparison::equal,
                             .expected = -0.1,
                             .low = kNone,
                             .high = 1e300,
                             .verdict = Verdict::fail};
  one.exact[kHostile] = {{kHostile, kHostile, Kind::count, Better::up, kHostile}, {.value = 0.1}};
  keep(folder / "h", {one});
  const History history = load(folder / "h");
  const Record back = record_at(history, 0);
  BOOST_TEST(back.run.commit == one.run.commit);
  BOOST_TEST(back.run.title == one.run.title);
  BOOST_TEST(back.run.release == "1.0");
  BOOST_TEST(back.run.dirty);
  BOOST_TEST(back.run.load == 0.25);
  BOOST_TEST((back.series == one.series));
  BOOST_TEST(back.exact.size() == one.exact.size());
  for (const auto& [name, exact] : one.exact) {
    BOOST_TEST(same(back.exact.at(name).reading, exact.reading));
    BOOST_TEST((back.exact.at(name).figure == exact.figure));
  }
  for (const auto& [name, timed] : one.timed) {
    BOOST_TEST((back.timed.at(name).time == timed.time));
    BOOST_TEST((back.timed.at(name).repetitions == timed.repetitions));
  }
}

BOOST_AUTO_TEST_CASE(only_what_changed_has_a_row) {
  const TemporaryFolder folder;
  keep(folder / "h", {record(1), record(2), with(record(3), "e2", 7), record(4)});
  const History history = load(folder / "h");
  BOOST_TEST(change_rows(history) == 5 + 0 + 1 + 1);
  BOOST_TEST(value(history, 1, "e2") == 1e-15 * 3);
  BOOST_TEST(value(history, 2, "e2") == 7);
  BOOST_TEST(value(history, 3, "e2") == 1e-15 * 3);
}

BOOST_AUTO_TEST_CASE(a_figure_that_is_gone_is_gone_and_a_partial_report_says_nothing_of_it) {
  const TemporaryFolder folder;
  Record without = record(2), partial = record(4);
  without.exact.erase("e0");
  partial.exact.erase("e1"), partial.is_partial = true;
  keep(folder / "h", {record(1), without, record(3), partial});
  const History history = load(folder / "h");
  BOOST_TEST(!record_at(history, 1).exact.contains("e0"));
  BOOST_TEST(value(history, 2, "e0") == 1e-15);
  BOOST_TEST(value(history, 3, "e1") == 1e-15 * 2);
}

BOOST_AUTO_TEST_CASE(series_do_not_mix) {
  const TemporaryFolder folder;
  Record other = with(record(2), "e0", 9);
  other.series.compiler = "clang++ 14";
  keep(folder / "h", {record(1), other, record(3)});
  const History history = load(folder / "h");
  BOOST_TEST(history.series.size() == 2);
  BOOST_TEST(change_rows(history) == 5 + 5);
  BOOST_TEST(value(history, 2, "e0") == 1e-15);
}

/// In whatever order runs are added, the history is the same one.
BOOST_AUTO_TEST_CASE(order_of_adding_does_not_matter) {
  const TemporaryFolder folder;
  const std::vector<Record> records = {record(1), with(record(2), "e1", 5), with(record(3), "e1", 6),
                                       record(4)};
  keep(folder / "sorted", records);
  for (const std::vector<int>& order : {std::vector{3, 2, 1, 0}, {2, 0, 3, 1}, {1, 3, 0, 2}}) {
    std::filesystem::remove(folder / "mixed");
    for (const int i : order) keep(folder / "mixed", {records[i]});
    BOOST_TEST(exported(folder / "mixed") == exported(folder / "sorted"));
  }
}

BOOST_AUTO_TEST_CASE(twice_is_told_and_other_figures_are_refused) {
  const TemporaryFolder folder;
  keep(folder / "h", {record(1)});
  const std::string before = bytes_of(folder / "h");
  with_store(folder / "h", Access::write, [&](Store& store) {
    const auto outcome = store.add(record(1));
    BOOST_TEST(outcome.was_there);
    BOOST_TEST(outcome.id == 1);
  });
  const std::string text = complaint([&] { keep(folder / "h", {with(record(1), "e0", 5)}); });
  BOOST_TEST(text.find("run 1 is of the same commit") != std::string::npos, text);
  BOOST_TEST(bytes_of(folder / "h") == before);
}

BOOST_AUTO_TEST_CASE(a_figure_described_anew_leaves_every_checksum_right) {
  const TemporaryFolder folder;
  Record anew = record(2);
  anew.exact.at("e3").figure.unit = "rad";
  keep(folder / "h", {record(1), anew});
  BOOST_TEST(record_at(load(folder / "h"), 0).exact.at("e3").figure.unit == "rad");
}

BOOST_AUTO_TEST_CASE(pruned_runs_leave_the_others_as_they_were) {
  const TemporaryFolder folder;
  Record released = with(record(2), "e4", 2);
  released.run.release = "1.0";
  keep(folder / "h",
       {record(1), released, with(record(3), "e4", 3), with(record(4), "e4", 3), record(5), record(6)});
  const History before = load(folder / "h");
  with_store(folder / "h", Access::write, [](Store& store) { store.prune(3, 1); });
  const History after = load(folder / "h");
  BOOST_REQUIRE(after.runs.size() == 4);
  for (const auto& [now, then] : {std::pair{0, 1}, {1, 3}, {2, 4}, {3, 5}}) {
    BOOST_TEST(after.runs[now].id == before.runs[then].id);
    for (const auto& [name, exact] : record_at(before, then).exact)
      BOOST_TEST(same(record_at(after, now).exact.at(name).reading, exact.reading));
    BOOST_TEST((record_at(after, now).timed.at("t0").time == record_at(before, then).timed.at("t0").time));
  }
  BOOST_TEST(record_at(after, 2).timed.at("t0").repetitions.empty());
  BOOST_TEST(!record_at(after, 3).timed.at("t0").repetitions.empty());
}

BOOST_AUTO_TEST_CASE(repetitions_are_of_the_last_runs) {
  const TemporaryFolder folder;
  std::vector<Record> records;
  for (int i = 0; i < kRepetitionsKept + 3; ++i) records.push_back(record(i));
  keep(folder / "h", records);
  BOOST_TEST(load(folder / "h").repetitions.size() == std::size_t(3 * kRepetitionsKept));
}

/// A run of 5 000 figures and 464 times, of which a few figures change each time.
BOOST_AUTO_TEST_CASE(a_run_takes_no_more_than_20_kB) {
  const TemporaryFolder folder;
  constexpr int kExact = 5000, kTimes = 464, kBefore = kRepetitionsKept + 2, kRuns = 40;
  const auto runs = [&](int from, int to) {
    with_store(folder / "h", Access::write, [&](Store& store) {
      for (int i = from; i < to; ++i) {
        Record one = record(i, kExact, kTimes);
        for (int f = 0; f < 20; ++f)
          one.exact.at("e" + std::to_string((37 * i + f) % kExact)).reading.value = i;
        store.add(one);
      }
    });
    return double(std::filesystem::file_size(folder / "h"));
  };
  const double before = runs(0, kBefore);
  const double kilobytes = (runs(kBefore, kBefore + kRuns) - before) / kRuns / 1000;
  BOOST_TEST_MESSAGE("kB a run: " << kilobytes);
  BOOST_TEST(kilobytes <= 20);
  BOOST_TEST(kilobytes > 5);  // smaller, and something was not written
}

BOOST_AUTO_TEST_SUITE_END()
