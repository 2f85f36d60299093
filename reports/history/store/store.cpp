#include "reports/history/store/store.hpp"

#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/vfs.h>

#include <array>
#include <cstring>
#include <fstream>
#include <set>

namespace halfway::history {
namespace {

constexpr int kPatience = 20000;  ///< ms that a writer waits for the others

int big_endian(const char* bytes) {
  unsigned out = 0;
  for (int i = 0; i < 4; ++i) out = out << 8 | static_cast<unsigned char>(bytes[i]);
  return int(out);
}

/// WAL needs memory that processes share: what one machine has on its own disks. By the magic numbers of
/// statfs(2): ext, xfs, btrfs, tmpfs, overlay, f2fs, zfs.
bool is_local(const std::filesystem::path& file) {
  static const std::set<unsigned> known{0xEF53,     0x58465342, 0x9123683E, 0x01021994,
                                        0x794C7630, 0xF2F52010, 0x2FC12FC1};
  struct statfs info {};
  return ::statfs(file.c_str(), &info) == 0 && known.contains(unsigned(info.f_type));
}

}  // namespace

void Store::damaged(const std::string& why) const {
  throw reports::BadInput(fmt::format("{}: damaged: {}", file_.string(), why));
}

/// Before SQLite sees the file, which would write beside it.
void Store::check_header() const {
  const std::string name = file_.string();
  std::array<char, 100> header{};
  std::ifstream in(file_, std::ios::binary);
  if (std::filesystem::is_directory(file_) || !in)
    throw reports::BadInput(name + ": cannot be read as a file");
  in.read(header.data(), header.size());
  if (in.gcount() == 0) return;  // made, and not filled yet
  if (std::memcmp(header.data(), "SQLite format 3", 16) != 0)
    throw reports::BadInput(name + ": no history: not an SQLite file");
  if (in.gcount() != 100) damaged("it ends within its header");
  const int application = big_endian(&header[68]), version = big_endian(&header[60]);
  if (application != kApplication)
    throw reports::BadInput(
        fmt::format("{}: no history: an SQLite file of another program (application_id {:#x}, "
                    "ours is {:#x})",
                    name, application, kApplication));
  if (version > kVersion) newer(version);
}

void Store::newer(int version) const {
  throw reports::BadInput(
      fmt::format("{}: of a newer Halfway: its schema is version {}, this program knows up to {}",
                  file_.string(), version, kVersion));
}

Store::Store(const std::filesystem::path& file, Access access) : file_(file) {
  const bool is_there = std::filesystem::exists(file);
  if (!is_there && access == Access::read)
    throw reports::BadInput(file.string() + ": no such file; ./halfway history add begins one");
  if (is_there) check_header();
  if (!is_there && file.has_parent_path()) reports::try_folder(file.parent_path());
  db_ = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                                           kPatience);
  migrate();
  // A file that cannot become what it should be for a while stays what it is: both are safe.
  const std::string wanted = is_local(file) ? "wal" : "delete";
  if (access == Access::write && db_->execAndGet("pragma journal_mode").getString() != wanted)
    db_->tryExec("pragma journal_mode = " + wanted);
}

Store::~Store() = default;

void Store::migrate() {
  const auto version = [&] { return db_->execAndGet("pragma user_version").getInt(); };
  if (version() == kVersion) return;
  SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
  const int from = version();  // another process may have been here meanwhile
  if (from == kVersion) return;
  if (from > kVersion) newer(from);  // its header is not in the file yet: a write-ahead log has it
  if (from > 0) check_integrity();
  for (int v = from; v < kVersion; ++v) db_->exec(migration(v));
  db_->exec(fmt::format("pragma application_id = {}; pragma user_version = {}", kApplication, kVersion));
  load();
  transaction.commit();
}

void Store::check_integrity() {
  const std::string found = db_->execAndGet("pragma integrity_check(1)").getString();
  if (found != "ok") damaged(found);
}

void with_store(const std::filesystem::path& file, Access access, const std::function<void(Store&)>& work) {
  try {
    Store store(file, access);
    work(store);
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB)
      throw reports::BadInput(fmt::format("{}: damaged: {}", file.string(), error.what()));
    if (code == SQLITE_BUSY)
      throw reports::FailedRun(
          fmt::format("{}: written by others for more than {} s", file.string(), kPatience / 1000));
    throw reports::FailedRun(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const reports::FileError& error) {
    throw reports::BadInput(error.what());
  }
}

}  // namespace halfway::history
