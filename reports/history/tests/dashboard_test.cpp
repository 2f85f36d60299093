// The blocks, as a browser would read them.
#include "reports/history/dashboard/dashboard.hpp"

#include "reports/history/tests/support.hpp"

#include <fmt/format.h>
#include <zlib.h>
#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace halfway::history;
using namespace halfway::history::test;
using nlohmann::json;

namespace {

/// Independent of the writer: digits one by one, zlib's own inflate.
std::string unpacked(const std::string& base64) {
  std::string bytes;
  unsigned word = 0, bits = 0;
  for (const char c : base64) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (c == '=') break;
    word = word << 6 | unsigned(digits.find(c)), bits += 6;
    if (bits >= 8) bits -= 8, bytes += char(word >> bits & 0xFF);
  }
  std::string out(1 << 20, '\0');
  z_stream stream{};
  BOOST_REQUIRE(::inflateInit2(&stream, 15) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data()), stream.avail_in = unsigned(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data()), stream.avail_out = unsigned(out.size());
  BOOST_REQUIRE(::inflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  ::inflateEnd(&stream);
  return out;
}

json block(const std::string& page, const std::string& id) {
  const std::string start = fmt::format("<script type=\"text/plain\" id=\"{}\">", id);
  const auto at = page.find(start);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, "no block " << id);
  const auto from = at + start.size();
  return json::parse(unpacked(page.substr(from, page.find("</script>", from) - from)));
}

History small() {
  const TemporaryFolder folder;
  Record first = record(1), second = record(2), other = record(3), last = record(4);
  for (Record* r : {&first, &second, &other, &last}) {
    r->exact["f/angular/modelling_error"] = {{.name = "f/angular/modelling_error", .formulation = "f"},
                                             {.value = 0.5}};
    r->timed["f/angular/residual"] = {{.name = "f/angular/residual", .kind = Kind::time, .formulation = "f"},
                                      {.median = 123456}};
    r->exact["ops"] = {{.name = "ops", .kind = Kind::count}, {.value = 12}};
    r->exact[kHostile] = {{.name = kHostile, .formulation = kHostile}, {.value = 1}};
  }
  first.run.release = "1.0", last.run.title = kHostile;
  second.exact.at("e1").reading = {
      .value = 0.1, .comparison = Comparison::at_most, .high = 0.01, .verdict = Verdict::fail};
  last.timed.erase("t1"), last.exact.erase("e0");
  other.series.isa = "sse2";
  keep(folder / "h", {first, second, other, last});
  return load(folder / "h");
}

std::string page_of(const History& history, const std::string& page = "<p>\n<!-- halfway data -->\n</p>\n") {
  const TemporaryFolder folder;
  write_bytes(folder / "page.html", page);
  ::setenv("HALFWAY_DASHBOARD", (folder / "page.html").c_str(), 1);
  return dashboard_html(history, "./halfway dashboard");
}

int number(const json& index, const std::string& name) {
  const json& names = index.at("figures").at("name");
  return int(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(dashboard)

BOOST_AUTO_TEST_CASE(the_index) {
  const json index = block(page_of(small()), "index");
  BOOST_TEST(index.at("schema") == "halfway-dashboard");
  BOOST_TEST(index.at("version") == 1);
  BOOST_TEST(index.at("release") == (json{{"run", 0}, {"name", "1.0"}}));
  BOOST_TEST(index.at("series").size() == 2);
  BOOST_TEST(index.at("machines").size() == 1);
  BOOST_TEST(index.at("runs").at("series") == json({0, 0, 1, 0}));
  BOOST_TEST(index.at("runs").at("date")[0] == 1767355200);  // 2026-01-02 12:00 UTC
  for (const auto& [key, column] : index.at("runs").items()) BOOST_TEST(column.size() == 4);
  for (const auto& [key, column] : index.at("figures").items())
    BOOST_TEST(column.size() == index.at("figures").at("name").size());
  const json& latest = index.at("latest")[0];
  BOOST_TEST(latest.at("run") == 3);
  BOOST_TEST(latest.at("value")[number(index, "t1")] ==
             200.1);  // of the run before: this one did not measure it
  BOOST_TEST(latest.at("value")[number(index, "e0")].is_null());
  BOOST_TEST(latest.at("limit")[number(index, "e1")] == 1e-12);
  BOOST_TEST(latest.at("verdict")[number(index, "e1")] == "pass");
  const json pair = {{"formulation", "f"},
                     {"kind", "angular"},
                     {"time", number(index, "f/angular/residual")},
                     {"error", number(index, "f/angular/modelling_error")}};
  BOOST_TEST(index.at("pairs") == json::array({pair}));
}

BOOST_AUTO_TEST_CASE(a_time_has_an_entry_a_run) {
  const std::string page = page_of(small());
  const json s = block(page, fmt::format("f{}", number(block(page, "index"), "t1"))).at("s");
  BOOST_REQUIRE(s.size() == 2);
  BOOST_TEST(s[0].at("r").is_null());
  BOOST_TEST(s[0].at("v") == json({200, 200.1, nullptr}));  // 200.037 and 200.074 to four digits
  BOOST_TEST(s[0].at("l") == json({198, 198.1, nullptr}));
  BOOST_TEST(s[1].at("v").size() == 1);
}

/// Of a long history least and largest repetitions are those of the last 200 runs.
BOOST_AUTO_TEST_CASE(the_spread_of_the_last_runs) {
  History h;
  h.series.emplace_back();
  h.figures = {{.name = "t", .kind = Kind::time}};
  h.times.resize(1), h.changes.resize(1);
  for (int run = 0; run < 203; ++run) {
    h.runs.emplace_back();
    h.times[0].push_back({run, {.median = 1000 * (run + 1), .low = 1000, .high = 2000, .n = 5}});
  }
  const json s = json::parse(figure_json(h, 0)).at("s")[0];
  BOOST_TEST(s.at("v").size() == 203);
  BOOST_TEST(s.at("l").size() == 200);
  BOOST_TEST(s.at("l")[0] == 4);
  BOOST_TEST(s.at("h").back() == 406);
}

BOOST_AUTO_TEST_CASE(other_figures_have_their_changes) {
  const std::string page = page_of(small());
  const json index = block(page, "index");
  const json s = block(page, fmt::format("f{}", number(index, "e1"))).at("s")[0];
  BOOST_TEST(s.at("r") == json({0, 1, 3}));
  BOOST_TEST(s.at("v") == json({2e-15, 0.1, 2e-15}));
  BOOST_TEST(s.at("limit") == json({1e-12, 0.01, 1e-12}));
  BOOST_TEST(s.at("verdict") == json({"pass", "fail", "pass"}));
  const json gone = block(page, fmt::format("f{}", number(index, "e0"))).at("s")[0];
  BOOST_TEST(gone.at("v").back().is_null());
  BOOST_TEST(!block(page, fmt::format("f{}", number(index, "ops"))).at("s")[0].contains("limit"));
}

/// A time 20 % slower, an error of four digits more, a count of one more, a figure that is gone; a series
/// beside it stays as it is.
BOOST_AUTO_TEST_CASE(changes_are_marked_where_they_are) {
  const TemporaryFolder folder;
  std::vector<Record> records;
  for (int i = 0; i < 60; ++i) {
    Record one = record(i, 3, 2);
    if (i % 2) one.series.isa = "sse2";
    const bool is_late = i >= 30 && i % 2 == 0;
    for (auto& [name, timed] : one.timed) {
      timed.time.median = 100000 + 100 * (i * 7 % 11);  // within 1 %
      if (is_late && name == "t1") timed.time.median = timed.time.median * 12 / 10;
    }
    if (is_late) one.exact.at("e1").reading.value *= 12345.678;
    one.exact["ops"] = {{.name = "ops", .kind = Kind::count, .better = Better::down},
                        {.value = is_late ? 123457.0 : 123456.0}};
    if (is_late) one.exact.erase("e2");
    records.push_back(one);
  }
  keep(folder / "h", records);
  const History history = load(folder / "h");
  const std::vector<Change> changes = find_changes(history);
  BOOST_REQUIRE(changes.size() == 4);
  for (const Change& c : changes) {
    BOOST_TEST(c.run == 30);
    BOOST_TEST(c.series == history.runs[30].series);
    BOOST_TEST(c.is_regression);
    const std::string& name = history.figures[c.figure].name;
    if (name == "t1") BOOST_TEST(std::abs(c.ratio - 1.2) < 0.01);
    if (name == "e1") BOOST_TEST(c.digits < -1);
    if (name == "ops") BOOST_TEST(c.ratio == 123457.0 / 123456.0);
    if (name == "e2") BOOST_TEST(c.text.find("not measured") != std::string::npos, c.text);
  }
  const json all = json::parse(index_json(history, changes, "", "")).at("changes");
  for (const json& c : all) {
    const std::string& name = history.figures[c.at("figure")].name;
    if (name == "t1")
      BOOST_TEST(fmt::format("{}", c.at("before").get<double>()).size() <= 5u);  // four digits
    if (name == "e1") BOOST_TEST(c.at("after").get<double>() == 2e-15 * 12345.678);
    if (name == "ops") BOOST_TEST(c.at("after") == 123457);
  }
  const json& shown = all[0];
  for (const char* key :
       {"figure", "series", "run", "before", "after", "verdict", "ratio", "digits", "p", "text"})
    BOOST_TEST(shown.contains(key), key);
  BOOST_TEST(shown.at("verdict") == "regression");
}

BOOST_AUTO_TEST_CASE(names_stay_inside_their_blocks) {
  const std::string page = page_of(small());
  const json index = block(page, "index");
  BOOST_TEST(number(index, kHostile) < int(index.at("figures").at("name").size()));
  BOOST_TEST(index.at("runs").at("title").back() == kHostile);
  std::size_t scripts = 0, ends = 0;
  for (std::size_t at = 0; (at = page.find("<script", at)) != std::string::npos; ++at) ++scripts;
  for (std::size_t at = 0; (at = page.find("</script", at)) != std::string::npos; ++at) ++ends;
  BOOST_TEST(scripts == 1 + index.at("figures").at("name").size());
  BOOST_TEST(ends == scripts);
  BOOST_TEST(page.starts_with("<p>\n<script"));
  BOOST_TEST(page.ends_with("</script>\n</p>\n"));
}

BOOST_AUTO_TEST_CASE(another_page_is_refused) {
  for (const char* page : {"<p></p>", "<!-- halfway data --><!-- halfway data -->"}) {
    const std::string text = complaint([&] { page_of(small(), page); });
    BOOST_TEST(text.find("must hold <!-- halfway data --> once") != std::string::npos, text);
  }
  ::setenv("HALFWAY_DASHBOARD", "/no/such/page.html", 1);
  const std::string text = complaint([] { dashboard_html(small(), ""); });
  BOOST_TEST(text.find("/no/such/page.html: the dashboard's page was not built") == 0, text);
}

BOOST_AUTO_TEST_CASE(an_empty_history_is_told) {
  BOOST_TEST(complaint([] { page_of(History{}); }).find("has no run yet") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(base64_of_every_length) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    BOOST_TEST(unpacked(packed(text)) == text);
    text += char('a' + i * 7 % 26);
  }
}

BOOST_AUTO_TEST_SUITE_END()
