#include "reports/history/gate/named.hpp"

#include "reports/cli/errors.hpp"
#include "reports/history/exchange/lines.hpp"
#include "reports/history/gate/process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace halfway::gate {
namespace {

namespace fs = std::filesystem;
using history::History;

struct Named {
  fs::path file;
  std::string run;  ///< number or commit; empty: none was named
};

/// A file that is there may have an @ in its name.
Named named_by(const std::string& text) {
  const auto at = text.rfind('@');
  if (at == std::string::npos || fs::exists(text)) return {text, ""};
  return {text.substr(0, at), text.substr(at + 1)};
}

bool is_database(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string begin(15, '\0');
  in.read(begin.data(), std::streamsize(begin.size()));
  return begin == "SQLite format 3";
}

/// Goes with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = fs::temp_directory_path() / "halfway-compare-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw reports::FailedRun("cannot make a folder like " + name);
    folder = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  fs::path folder;
};

/// By the program of the history, which verifies what it reads: this one is built without SQLite.
History exported(const Named& named) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "halfway-history";
  if (!fs::exists(program))
    throw reports::BadInput(
        fmt::format("{}: {} is not there to read it; ./halfway history list builds it, ./halfway history "
                    "export writes the text that is read without it",
                    named.file.string(), program.string()));
  const Scratch scratch;
  const fs::path lines = scratch.folder / "lines";
  std::vector<std::string> words = {program, "history", "export", "--file", named.file, "--out", lines};
  if (!named.run.empty()) words.insert(words.end(), {"--run", named.run});
  const std::string failed = gate::run(words, scratch.folder / "log", 600);
  if (!failed.empty()) throw reports::BadInput(fmt::format("{}: {}", named.file.string(), failed));
  return history::read_history(lines);
}

/// What AFTER says of the run that it is compared with, if nobody named one.
struct Like {
  const Record& after;
  bool newest;  ///< of the last commit alone
};

/// The last run that was made like that, on the same machine if there is one; else the last run.
int alike(const History& h, const Like& wanted) {
  const Record& like = wanted.after;
  int of_series = -1, last = int(h.runs.size()) - 1;
  for (int i = last; i >= 0; --i) {
    if (wanted.newest && h.runs[i].commit != h.runs[last].commit) continue;
    const Record head = record_of({.run = h.runs[i], .series = h.series[h.runs[i].series]}, "");
    if (head.series != like.series) continue;
    if (head.machine == like.machine) return i;
    if (of_series < 0) of_series = i;
  }
  return of_series >= 0 ? of_series : last;
}

Record read_run(const Named& named, const Like* like) {
  const bool is_exported = is_database(named.file);
  const History h = is_exported ? exported(named) : history::read_history(named.file);
  const std::string file = named.file.string();
  // One run alone was exported: its number stayed behind.
  const int run = named.run.empty() && like != nullptr ? alike(h, *like)
                  : is_exported                        ? int(h.runs.size()) - 1
                                                       : history::find_run(h, named.run);
  if (h.runs.empty()) throw reports::BadInput(file + ": it has no run");
  if (run < 0)
    throw reports::BadInput(fmt::format(
        "{}: no run '{}': neither a number nor the beginning of a commit in it", file, named.run));
  const history::Record record = history::record_at(h, run);
  return record_of(record, fmt::format("{}@{}", file, record.run.commit));
}

Record read_side(const std::string& text, const Like* like) {
  const Named named = named_by(text);
  if (is_database(named.file) || history::is_lines(named.file)) return read_run(named, like);
  return read_report(text);
}

}  // namespace

std::pair<Record, Record> read_both(const std::string& before, const std::string& after, bool newest) {
  Record second = read_side(after, nullptr);
  const Like like{second, newest};
  Record first = read_side(before, &like);
  return {std::move(first), std::move(second)};
}

}  // namespace halfway::gate
