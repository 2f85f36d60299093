// What others read: no number that is none, names as text, and back again without a difference.
#include "reports/history/exchange/exchange.hpp"
#include "reports/history/exchange/lines.hpp"

#include "reports/cli/errors.hpp"
#include "reports/history/store/store.hpp"
#include "reports/history/tests/support.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

using namespace halfway;
using namespace halfway::history;
using namespace halfway::history::test;
using nlohmann::json;

namespace {

/// A zero, a number that is none, a failure, a hostile name.
Record odd(int i) {
  Record out = record(i, 6, 2);
  out.exact.at("e0").reading.value = 0;
  out.exact.at("e1").reading.value = kNone;
  out.exact.at("e2").reading.verdict = Verdict::fail;
  out.exact[kHostile] = out.exact.at("e3");
  out.exact.at(kHostile).figure.name = kHostile;
  out.timed[kHostile] = out.timed.at("t1");
  out.timed.at(kHostile).figure.name = kHostile;
  out.exact.erase(kHostile);
  return out;
}

Selection selected(
    const Record& one,
    const std::function<bool(const std::string&)>& is_wanted = [](auto&) { return true; }) {
  const TemporaryFolder folder;
  keep(folder / "h", {one});
  return select(load(folder / "h"), 0, is_wanted);
}

void import(const std::filesystem::path& file, const std::string& lines) {
  std::vector<Record> records;
  read_lines(lines, "lines", [&](const Record& one) { records.push_back(one); });
  keep(file, records);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(exchange)

BOOST_AUTO_TEST_CASE(lines_come_back_as_they_were) {
  const TemporaryFolder folder;
  Record without = record(2, 6, 2), other = odd(4);
  without.exact.erase("e1");
  other.series.isa = "sse2", other.run.load = kNone, other.run.release = "1.0", other.run.dirty = true;
  keep(folder / "a", {odd(3), without, other, record(5, 7, 2), record(1, 6, 2)});
  const std::string lines = exported(folder / "a");
  import(folder / "b", lines);
  BOOST_TEST(exported(folder / "b") == lines);
  import(folder / "b", lines);  // twice: nothing is new
  BOOST_TEST(exported(folder / "b") == lines);
  // One run alone, into a history that lacks it.
  import(folder / "c", json_lines(load(folder / "a"), 2));
  const Record one = record_at(load(folder / "c"), 0), there = record_at(load(folder / "a"), 2);
  BOOST_TEST(one.exact.size() == there.exact.size());
  for (const auto& [name, exact] : there.exact) BOOST_TEST(same(one.exact.at(name).reading, exact.reading));
}

BOOST_AUTO_TEST_CASE(wrong_lines_are_named) {
  const TemporaryFolder folder;
  keep(folder / "a", {record(1), record(2)});
  const std::string lines = exported(folder / "a");
  const auto check = [&](const std::string& from, const std::string& to, const std::string& where) {
    std::string wrong = lines;
    wrong.replace(wrong.find(from), from.size(), to);
    const std::string text = complaint([&] { import(folder / "b", wrong); });
    BOOST_TEST(text.find(where) == 0, text);
    BOOST_TEST(!std::filesystem::exists(folder / "b"));
  };
  check("\"version\":1", "\"version\":2", "lines:1: schema, version");
  check("title of 2\"", "title of 2", "lines:3: ");
  check("\"at_most\"", "\"atmost\"", "lines:2: comparison 'atmost'; allowed: ");
  check("[[0,", "[[99,", "lines:2: ");
  BOOST_TEST(complaint([&] { import(folder / "b", ""); }) == "lines: empty");
}

BOOST_AUTO_TEST_CASE(google_has_a_row_a_repetition) {
  const json root = json::parse(google_json(selected(odd(1))));
  BOOST_TEST(root.at("benchmarks").size() == 9);
  BOOST_TEST(root.at("context").at("json_schema_version") == 1);
  const json& row = root.at("benchmarks")[0];
  BOOST_TEST(row.at("time_unit") == "ns");
  BOOST_TEST(row.at("repetitions") == 3);
  for (const json& each : root.at("benchmarks"))
    if (each.at("name") == "t0" && each.at("repetition_index") == 0)
      BOOST_TEST(each.at("real_time").get<double>() == 100.037);
}

BOOST_AUTO_TEST_CASE(digits_are_bigger_where_better_and_never_null) {
  const std::string text = github_json(selected(odd(1)));
  BOOST_TEST(text.find("null") == std::string::npos);
  double before = 17;
  int seen = 0;
  for (const json& row : json::parse(text)) {
    BOOST_TEST(row.at("name") != "e1");
    BOOST_TEST(row.at("value").get<double>() <= before);  // e0 is zero, the others grow by their number
    before = row.at("value");
    ++seen;
  }
  BOOST_TEST(seen == 5);
}

BOOST_AUTO_TEST_CASE(an_empty_document_is_refused) {
  const Selection none = selected(odd(1), [](auto& name) { return name == "e1"; });
  BOOST_CHECK_THROW(github_json(none), reports::BadInput);
  BOOST_CHECK_THROW(bmf_json(none), reports::BadInput);
  BOOST_CHECK_THROW(google_json(none), reports::BadInput);
  BOOST_CHECK_THROW(ctest_measurements(none, true), reports::BadInput);
}

BOOST_AUTO_TEST_CASE(ctest_takes_ten_finite_numbers) {
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  const Selection few = selected(odd(1)), many = selected(record(1, 20, 20));
  BOOST_TEST(lines(ctest_measurements(few, true)) == 3 + 5);
  BOOST_TEST(ctest_measurements(few, true).find("nan") == std::string::npos);
  BOOST_TEST(ctest_measurements(few, true).find("<script") == std::string::npos);
  BOOST_TEST(lines(ctest_measurements(many, false)) <= 10);
  const std::string text = complaint([&] { ctest_measurements(many, true); });
  BOOST_TEST(text.find("40 numbers") != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(names_are_text_everywhere) {
  const Selection all = selected(odd(1));
  BOOST_TEST(junit_xml(all).find("<script") == std::string::npos);
  BOOST_TEST(open_metrics(all).find("figure=\"<script>\\\"'&,\\\\]]>--\\n{}'") != std::string::npos);
  const TemporaryFolder folder;
  keep(folder / "h", {odd(1)});
  const std::string text = csv(load(folder / "h"), -1, [](auto&) { return true; });
  BOOST_TEST(text.find("\"<script>\"\"'&,\\]]>--\n{}'") != std::string::npos, text);
}

BOOST_AUTO_TEST_CASE(a_failure_says_what_is_allowed) {
  const std::string text = junit_xml(selected(odd(1)));
  BOOST_TEST(text.find(">3.0000000000000002e-15 eps; at most 1e-12</failure>") != std::string::npos, text);
  BOOST_TEST(text.find("failures=\"1\"") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
