#include "verify/record.hpp"

#include "verify/forked.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace halfway::verify {
namespace {

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

/// A request is one line of JSON, a scene is a file.
std::string replay_text(const std::string& replay) {
  if (replay.starts_with('{')) return fmt::format("replay: echo '{}' | ./halfway eval\n", replay);
  return fmt::format("replay: ./halfway run replay.toml, with the file\n{}\n", replay);
}

std::string text_of(const Finding& f) {
  std::string text = line(f) + "\n";
  if (f.verdict == Verdict::fail && !f.replay.empty()) text += replay_text(f.replay);
  if (std::isfinite(f.value)) {
    text += fmt::format("<CTestMeasurement type=\"numeric/double\" name=\"{}\">{:.17g}</CTestMeasurement>\n",
                        f.name, f.value);
  }
  return text;
}

/// The line of a kept record begins with this.
std::string head_of(const std::string& check) { return "{\"check\":" + nlohmann::json(check).dump() + ","; }

std::string line_of(const Record& r) {
  const nlohmann::json json = {{"check", r.check}, {"passed", r.passed}, {"text", r.text}};
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Record record_of_line(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  return {json.at("check"), json.at("passed"), json.at("text")};
}

void write_records(const Checks& checks, std::size_t begin, int output) {
  for (std::size_t i = begin; i < checks.size(); ++i)
    if (!write_all(output, line_of(record_of(checks[i])))) return;
}

/// Lines of a child until it ends, or is silent for too long.
class Lines {
 public:
  Lines(int input, int limit) : input_(input), limit_(limit) {}

  bool next(std::string& line) {
    for (std::size_t end; (end = text_.find('\n')) == std::string::npos;)
      if (!more()) return false;
    line = text_.substr(0, text_.find('\n'));
    text_.erase(0, line.size() + 1);
    return true;
  }
  bool silent() const { return silent_; }

 private:
  bool more() {
    pollfd wait{input_, POLLIN, 0};
    int ready;
    while ((ready = poll(&wait, 1, 1000 * limit_)) < 0 && errno == EINTR) continue;
    silent_ = ready == 0;
    if (ready <= 0) return false;
    char part[65536];
    const ssize_t n = read(input_, part, sizeof part);
    if (n > 0) text_.append(part, std::size_t(n));
    return n > 0 || (n < 0 && errno == EINTR);
  }

  int input_, limit_;
  bool silent_ = false;
  std::string text_{};
};

}  // namespace

std::string line(const Finding& f) {
  const std::string why = missing(f);
  return fmt::format("{}: {} {:.17g} {} ({}; {}){} {}{}", to_string(f.verdict), f.name, f.value, f.unit,
                     limits(f), to_string(f.oracle), why.empty() ? "" : " " + why + ";",
                     f.parameter.empty() ? "" : "worst at " + f.parameter,
                     f.reason.empty() ? "" : "; " + f.reason);
}

Record record_of(const Check& check) {
  Record record{.check = check.name};
  try {
    const auto findings = check.run();
    record.passed = !findings.empty();
    if (findings.empty()) record.text = "fail: " + check.name + " measured nothing\n";
    for (const Finding& f : findings) {
      record.text += text_of(f);
      record.passed = record.passed && f.verdict != Verdict::fail;
    }
  } catch (const std::exception& e) {
    record = {check.name, false, "fail: " + check.name + " threw: " + e.what() + "\n"};
  } catch (...) {
    record = {check.name, false, "fail: " + check.name + " threw what is no std::exception\n"};
  }
  return record;
}

void run_apart_each(const Checks& checks, int limit, const std::function<void(const Record&)>& take) {
  for (std::size_t next = 0; next < checks.size();) {
    Forked child([&](int output) { write_records(checks, next, output); });
    Lines lines(child.input(), limit);
    for (std::string text; lines.next(text); ++next) take(record_of_line(text));
    if (lines.silent()) child.kill();
    const int status = child.status();
    if (next == checks.size()) return;
    const std::string how = lines.silent() ? fmt::format("was silent for {} s", limit)
                            : WIFSIGNALED(status)
                                ? fmt::format("crashed with signal {}", WTERMSIG(status))
                                : fmt::format("ended the program, exit code {}", WEXITSTATUS(status));
    take({checks[next].name, false, "fail: " + checks[next].name + " " + how + "\n"});
    ++next;
  }
}

void keep(const Checks& checks, int limit, const std::filesystem::path& file) {
  const auto part = std::filesystem::path(file).concat(".part");
  std::filesystem::remove(file);  // what an earlier run found answers for nothing
  std::ofstream out(part);
  if (!out) throw std::runtime_error(part.string() + " cannot be written");
  run_apart_each(checks, limit, [&](const Record& record) { out << line_of(record); });
  out.close();
  if (!out) throw std::runtime_error(part.string() + " cannot be written");
  std::filesystem::rename(part, file);
}

Record kept(const std::filesystem::path& file, const std::string& check) {
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error(file.string() + " cannot be read: the room's checks did not run to their end");
  const std::string head = head_of(check);
  for (std::string text; std::getline(in, text);)
    if (text.starts_with(head)) return record_of_line(text);
  throw std::runtime_error(file.string() + " has no record of '" + check + "'");
}

}  // namespace halfway::verify
