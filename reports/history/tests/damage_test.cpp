// Files that are no history, of a later one, or damaged: refused by name, and not written to.
#include "reports/cli/errors.hpp"
#include "reports/history/store/store.hpp"
#include "reports/history/tests/support.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <boost/test/unit_test.hpp>

using namespace halfway;
using namespace halfway::history;
using namespace halfway::history::test;

namespace {

/// Reading and adding both complain of the file, and leave it and its folder as they were.
void check_refused(const TemporaryFolder& folder, const std::string& why) {
  const std::string before = bytes_of(folder / "h");
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator(folder / ""),
                         std::filesystem::directory_iterator());
  };
  const auto count = files();
  for (const auto& work :
       {std::function<void()>([&] { load(folder / "h"); }), {[&] { keep(folder / "h", {record(9)}); }}, {[&] {
          with_store(folder / "h", Access::write, [](Store& store) { store.prune(1, 1); });
        }}}) {
    BOOST_CHECK_THROW(work(), reports::BadInput);
    const std::string text = complaint(work);
    BOOST_TEST(text.find((folder / "h").string()) == 0, text);
    BOOST_TEST(text.find(why) != std::string::npos, text);
    BOOST_TEST(bytes_of(folder / "h") == before);
    BOOST_TEST(files() == count);
  }
}

std::vector<Record> five() {
  return {record(1, 40, 30), record(2, 40, 30), record(3, 40, 30), record(4, 40, 30), record(5, 40, 30)};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(damage)

BOOST_AUTO_TEST_CASE(a_text_file) {
  const TemporaryFolder folder;
  write_bytes(folder / "h", std::string(5000, 'x'));
  check_refused(folder, "not an SQLite file");
}

BOOST_AUTO_TEST_CASE(a_database_of_another_program) {
  const TemporaryFolder folder;
  SQLite::Database((folder / "h").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("create table run (id integer)");
  check_refused(folder, "of another program");
}

BOOST_AUTO_TEST_CASE(a_later_version) {
  const TemporaryFolder folder;
  keep(folder / "h", {record(1)});
  SQLite::Database((folder / "h").string(), SQLite::OPEN_READWRITE)
      .exec(fmt::format("pragma user_version = {}", kVersion + 1));
  check_refused(folder, "of a newer Halfway");
}

/// Where the version stands in the write-ahead log of a program that still runs, the file's header is older.
BOOST_AUTO_TEST_CASE(a_later_version_that_is_being_written) {
  const TemporaryFolder folder;
  keep(folder / "h", {record(1)});
  SQLite::Database other((folder / "h").string(), SQLite::OPEN_READWRITE);
  other.exec("pragma wal_autocheckpoint = 0");
  BOOST_TEST(other.execAndGet("pragma journal_mode = wal").getString() == "wal");
  other.exec(fmt::format("pragma user_version = {}", kVersion + 1));
  BOOST_TEST(complaint([&] { load(folder / "h"); }).find("of a newer Halfway") != std::string::npos);
  BOOST_TEST(other.execAndGet("pragma user_version").getInt() == kVersion + 1);
}

BOOST_AUTO_TEST_CASE(a_file_cut_short) {
  const TemporaryFolder folder;
  keep(folder / "h", five());
  const std::string whole = bytes_of(folder / "h");
  for (const std::size_t size : {std::size_t(60), std::size_t(4096), whole.size() / 2, whole.size() - 4096}) {
    write_bytes(folder / "h", whole.substr(0, size));
    check_refused(folder, "damaged");
  }
}

BOOST_AUTO_TEST_CASE(no_file_is_not_an_empty_history) {
  const TemporaryFolder folder;
  BOOST_CHECK_THROW(load(folder / "h"), reports::BadInput);
  BOOST_TEST(!std::filesystem::exists(folder / "h"));
}

/// One bit of a title: SQLite's own check finds nothing wrong, the checksum names the run.
BOOST_AUTO_TEST_CASE(one_flipped_bit_is_named) {
  const TemporaryFolder folder;
  keep(folder / "h", five());
  std::string bytes = bytes_of(folder / "h");
  const auto at = bytes.find("title of 3");
  BOOST_REQUIRE(at != std::string::npos);
  bytes[at] ^= 4;
  write_bytes(folder / "h", bytes);
  {
    SQLite::Database database((folder / "h").string(), SQLite::OPEN_READWRITE);
    BOOST_TEST(database.execAndGet("pragma integrity_check").getString() == "ok");
  }
  check_refused(folder, "run 3 (commit abc000000003");
}

/// A bit anywhere: the file is refused, or nothing that it says has changed. Nothing is added to a refused
/// one.
BOOST_AUTO_TEST_CASE(no_flipped_bit_goes_unseen) {
  const TemporaryFolder folder;
  keep(folder / "h", five());
  const std::string whole = bytes_of(folder / "h"), told = exported(folder / "h");
  int refused = 0, named = 0, harmless = 0;
  for (std::size_t i = 0; i < whole.size(); i += 41) {
    std::string bytes = whole;
    bytes[i] ^= char(1 << i % 8);
    write_bytes(folder / "h", bytes);
    std::string now;
    const std::string text = complaint([&] { now = exported(folder / "h"); });
    if (text.empty()) {
      BOOST_TEST(now == told, "a bit of byte " << i << " changed what the history says");
      ++harmless;
      continue;
    }
    BOOST_TEST(text.find((folder / "h").string()) == 0, text);
    BOOST_TEST(bytes_of(folder / "h") == bytes, "byte " << i << ": written to");
    named += text.find("by its checksum") != std::string::npos;
    ++refused;
    std::filesystem::remove(folder / "h-wal"), std::filesystem::remove(folder / "h-shm");
  }
  BOOST_TEST_MESSAGE(refused << " refused, " << named << " of them by checksum; " << harmless << " harmless");
  BOOST_TEST(named > 50);  // else the bits were not where the rows are
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(migrations)

/// From each version: a file as that version's statements make it, with rows as it had them.
BOOST_AUTO_TEST_CASE(from_each_version) {
  for (int version = 1; version < kVersion; ++version) {
    const TemporaryFolder folder;
    Record plain = record(1);
    plain.run.title = "";  // the first version has none
    keep(folder / "now", {plain});
    {
      SQLite::Database old((folder / "h").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      for (int v = 0; v < version; ++v) old.exec(migration(v));
      old.exec(fmt::format("pragma application_id = {}; pragma user_version = {}", kApplication, version));
      old.exec("attach '" + (folder / "now").string() + "' as later");
      for (const char* table : {"machine", "series", "figure", "time", "change", "repetition"})
        old.exec(fmt::format("insert into {0} select * from later.{0}", table));
      old.exec(
          "insert into run select id, series, \"commit\", date, dirty, load, libraries, checksum, "
          "repetition_checksum "
          "from later.run");
    }
    BOOST_TEST(exported(folder / "h") == exported(folder / "now"));
    keep(folder / "h", {record(2)});
    BOOST_TEST(load(folder / "h").runs.size() == 2);
    BOOST_TEST(SQLite::Database((folder / "h").string()).execAndGet("pragma user_version").getInt() ==
               kVersion);
  }
}

BOOST_AUTO_TEST_CASE(a_damaged_one_stays_as_it_is) {
  const TemporaryFolder folder;
  {
    SQLite::Database old((folder / "h").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    old.exec(migration(0));
    old.exec(fmt::format("pragma application_id = {}; pragma user_version = 1", kApplication));
    old.exec(
        "insert into machine values (1, 'a', 1, '', ''); insert into series values (1, 1, '', '', '', '')");
    old.exec("insert into run values (1, 1, 'abc', '2026-01-01T00:00:00Z', 0, null, '{}', 12345, null)");
  }
  check_refused(folder, "run 1 (commit abc");
}

BOOST_AUTO_TEST_SUITE_END()
