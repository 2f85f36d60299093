#include "reports/check/judge/program.hpp"

#include "reports/check/child/child.hpp"
#include "reports/check/child/words.hpp"
#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace halfway::check {
namespace {

using nlohmann::json;

constexpr const char* kHello = R"({"id":"hello","hello":{"protocol":"halfway-check","version":1}})";

Hello hello_of(const json& line) {
  Hello out;
  out.name = line.value("name", out.name);
  out.version = line.value("version", "");
  if (const auto kinds = line.find("kinds"); kinds != line.end() && kinds->is_array()) {
    const auto has = [&](const char* kind) { return std::ranges::find(*kinds, json(kind)) != kinds->end(); };
    out.angular = has("angular");
    out.linear_angular = has("linear_angular");
  }
  const std::string law = line.value("law", "full");
  out.springs = law == "isotropic"  ? Hello::Springs::isotropic
                : law == "diagonal" ? Hello::Springs::diagonal
                                    : Hello::Springs::full;
  out.digits = std::clamp(line.value("digits", out.digits), 4., 15.5);  // fewer would let everything pass
  out.ends = line.value("ends", true);
  out.frames = out.ends && line.value("frames", true);
  out.path = line.value("path", false);
  if (const auto answers = line.find("answers"); answers != line.end() && answers->is_array())
    out.tangent = std::ranges::find(*answers, json("tangent")) != answers->end();
  return out;
}

/// Why there are no loads: it skipped the question, or it answered something else.
Said without_loads(bool skipped, std::string why) {
  Said out;
  out.skipped = skipped;
  out.why = std::move(why);
  return out;
}

/// As many finite numbers, or nothing.
bool read_numbers(const json& list, double* out, std::size_t count) {
  if (!list.is_array() || list.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!list[i].is_number()) return false;
    out[i] = list[i].get<double>();
  }
  return true;
}

/// The loads of an answer, or what is wrong with them.
Said read_said(const json& line) {
  if (line.contains("skipped"))
    return without_loads(true, line["skipped"].is_string() ? line["skipped"].get<std::string>() : "");
  const auto loads = line.find("loads");
  if (loads == line.end()) {
    const auto error = line.find("error");
    return without_loads(true, error == line.end() ? "neither loads nor skipped" : error->dump());
  }
  Said out;
  TwelveLoads q;
  if (!read_numbers(*loads, q.data(), 12)) return without_loads(false, "loads: not 12 numbers");
  out.loads = q;
  const auto tangent = line.find("tangent");
  if (tangent == line.end() || !tangent->is_array() || tangent->size() != 12) return out;
  Eigen::Matrix<double, 12, 12> T;
  for (std::size_t i = 0; i < 12; ++i) {
    Eigen::Matrix<double, 12, 1> row;
    if (!read_numbers((*tangent)[i], row.data(), 12)) return out;
    T.row(long(i)) = row.transpose();
  }
  out.tangent = T;
  return out;
}

class Running : public Program {
 public:
  Running(const std::string& command, double seconds, std::string fields)
      : command_(command), fields_(std::move(fields)), seconds_(seconds), child_(words_of(command)) {}

  Hello hello() override {
    const Outcome outcome = child_.ask({kHello}, seconds_)[0];
    if (outcome.sort == Outcome::Sort::answered) hello_ = hello_of(outcome.line);
    if (outcome.sort == Outcome::Sort::missing) lost_hello_ = outcome.words;
    return hello_;
  }

  std::vector<Said> ask(const std::vector<std::string>& ids, const std::vector<Ask>& asks,
                        bool tangent) override {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < ids.size(); ++i)
      lines.push_back(request_line(ids[i], asks[i], !hello_.linear_angular, fields_, tangent));
    std::vector<Said> out;
    for (const Outcome& outcome : child_.ask(lines, seconds_)) {
      if (outcome.sort == Outcome::Sort::missing)
        out.push_back(without_loads(false, outcome.words));
      else
        out.push_back(read_said(outcome.line));
    }
    return out;
  }

  std::vector<std::string> remarks() const override {
    std::vector<std::string> out = child_.remarks();
    if (!lost_hello_.empty()) out.push_back("hello had no answer: " + lost_hello_);
    if (child_.chatter().count > 0)
      out.push_back(fmt::format("{} lines that answer nothing, first: {}", child_.chatter().count,
                                child_.chatter().first.front()));
    return out;
  }

  std::string repeat(const std::string& request) const override {
    return fmt::format("printf '%s\\n' '{}' | {}", request, command_);
  }

 private:
  std::string command_, fields_, lost_hello_;
  std::chrono::duration<double> seconds_;
  Child child_;
  Hello hello_;
};

/// Answers that were made elsewhere: by id.
class Written : public Program {
 public:
  explicit Written(const std::string& file) : file_(file) {
    std::istringstream lines(reports::read_file(file));
    int number = 0;
    for (std::string text; std::getline(lines, text);) {
      ++number;
      if (text.find_first_not_of(" \t\r") != std::string::npos) keep(text, number);
    }
  }

  Hello hello() override { return hello_; }

  std::vector<Said> ask(const std::vector<std::string>& ids, const std::vector<Ask>&, bool) override {
    std::vector<Said> out;
    for (const std::string& id : ids) {
      const auto found = answers_.find(id);
      out.push_back(found == answers_.end() ? without_loads(true, "not in the file") : found->second);
    }
    return out;
  }

  bool is_live() const override { return false; }
  std::string repeat(const std::string& request) const override { return request; }

 private:
  void keep(const std::string& text, int number) {
    const json line = json::parse(text, nullptr, false);
    const auto refuse = [&](const std::string& what) {
      throw reports::BadInput(fmt::format("{}, line {}: {}", file_, number, what));
    };
    if (!line.is_object()) refuse("is no JSON object; an answer is one, with id and loads");
    if (!line.contains("id") || !line["id"].is_string())
      refuse("id: missing, or no text; allowed: an id of --questions");
    const std::string id = line["id"];
    if (id == "hello")
      hello_ = hello_of(line);
    else if (!answers_.emplace(id, read_said(line)).second)
      refuse(fmt::format("id: '{}' was answered before", id));
  }

  std::string file_;
  Hello hello_;
  std::map<std::string, Said> answers_;
};

}  // namespace

std::string request_line(const std::string& id, const Ask& ask, bool angular, const std::string& fields,
                         bool tangent) {
  auto line = reference::request(ask);
  if (angular) {
    line["kind"] = "angular";
    auto rows = json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({ask.K_m(i, 0), ask.K_m(i, 1), ask.K_m(i, 2)});
    line["law"]["K"] = rows;
  }
  nlohmann::ordered_json out{{"id", id}};
  out.update(line);
  out["want"] = tangent ? json{"loads", "tangent"} : json{"loads"};
  if (!fields.empty()) out.update(nlohmann::ordered_json::parse(fields));
  return out.dump();
}

std::unique_ptr<Program> running_program(const std::string& command, double seconds,
                                         const std::string& fields) {
  if (!fields.empty() && !json::parse(fields, nullptr, false).is_object())
    throw reports::BadInput(
        fmt::format("--fields: '{}' is no JSON object; allowed: {{\"name\": value, ...}}", fields));
  return std::make_unique<Running>(command, seconds, fields);
}

std::unique_ptr<Program> answered_program(const std::string& file) { return std::make_unique<Written>(file); }

}  // namespace halfway::check
