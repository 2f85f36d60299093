#include "reports/check/judge/verdict.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace halfway::check {
namespace {

const char* word(Status status) {
  constexpr const char* kWords[] = {"ok", "FAIL", "expected failure", "UNEXPECTED PASS", "left out"};
  return kWords[int(status)];
}

std::string digits(double distance) {
  return distance > 0 ? fmt::format("to {:.1f} digits", -std::log10(distance)) : "in every digit";
}

/// The first few of the others, in words.
std::string others(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 4;
  if (names.empty()) return "";
  const std::size_t shown = std::min(kShown, names.size());
  const std::vector<std::string> first(names.begin(), names.begin() + long(shown));
  return fmt::format("; the same answers: {}{}", fmt::join(first, ", "),
                     names.size() > shown ? fmt::format(" and {} more", names.size() - shown) : "");
}

std::string who(const Verdict& v) {
  const reference::Identity& id = v.identity;
  if (id.name.empty()) return "unknown: no question was answered";
  if (v.is_known) return fmt::format("{} ({}){}", id.name, digits(id.distance), others(id.as_well));
  const std::string nearest = fmt::format("nearest: {}, {:.2g} away", id.name, id.distance);
  if (v.family.distance < 0.02)
    return fmt::format("unknown, of the family: {} ({}); {}", v.family.words(), digits(v.family.distance),
                       nearest);
  return fmt::format("unknown; {}", nearest);
}

std::string line_of(const Result& r) {
  const std::string size =
      r.status == Status::left_out
          ? r.where
          : fmt::format("{:.2g} (limit {:.2g}){}{}", r.value, r.limit, r.where.empty() ? "" : ", ", r.where);
  return fmt::format("  {:<16} {:<26} {}: {}\n", word(r.status), r.id, r.title, size);
}

int count(const Verdict& v, Status status) {
  return int(std::ranges::count(v.results, status, &Result::status));
}

bool matches(const std::string& pattern, const std::string& id) {
  if (pattern.ends_with("/*")) return id.starts_with(pattern.substr(0, pattern.size() - 1));
  return id == pattern;
}

/// A cell of a table: no pipe may end it.
std::string cell(std::string text) {
  for (std::size_t i = 0; (i = text.find('|', i)) != std::string::npos; i += 2) text.replace(i, 1, "\\|");
  return reports::printable(text);
}

}  // namespace

bool Verdict::fails() const {
  return identity.name.empty() || !lost.empty() || std::ranges::any_of(results, [](const Result& r) {
           return r.status == Status::fail || r.status == Status::unexpected_pass;
         });
}

void expect(Verdict& verdict, const std::string& file) {
  std::istringstream lines(reports::read_file(file));
  int number = 0;
  for (std::string text; std::getline(lines, text);) {
    ++number;
    text = text.substr(0, text.find('#'));
    text.erase(text.find_last_not_of(" \t\r") + 1);
    if (text.empty()) continue;
    bool found = false;
    for (Result& r : verdict.results) {
      if (!matches(text, r.id)) continue;
      found = true;
      if (r.status == Status::fail)
        r.status = Status::expected_fail;
      else if (r.status == Status::pass && text == r.id)
        r.status = Status::unexpected_pass;
    }
    if (!found)
      throw reports::BadInput(
          fmt::format("{}, line {}: '{}' is no id of a check; allowed: level3/body_order, level3/*, ...",
                      file, number, reports::printable(text)));
  }
}

std::string as_text(const Verdict& v) {
  std::string out = fmt::format("{}{}{}: {} questions, {} answered, {} skipped\n",
                                reports::printable(v.hello.name), v.hello.version.empty() ? "" : ", ",
                                reports::printable(v.hello.version), v.asked, v.answered, v.skipped);
  out += fmt::format("your joint is {}\n", who(v));
  for (const std::string& words : v.identity.convention.words())
    out += fmt::format("  convention: {}\n", words);
  for (const Result& r : v.results) out += line_of(r);
  for (const std::string& lost : v.lost)
    out += fmt::format("  LOST             {}\n", reports::printable(lost));
  for (const std::string& remark : v.remarks)
    out += fmt::format("  remark: {}\n", reports::printable(remark));
  out += fmt::format("{} passed, {} failed, {} expected to fail, {} left out\n", count(v, Status::pass),
                     count(v, Status::fail) + count(v, Status::unexpected_pass) + int(v.lost.size()),
                     count(v, Status::expected_fail), count(v, Status::left_out));
  return out;
}

std::string as_markdown(const Verdict& v) {
  std::string out =
      fmt::format("### {} {}\n\n**{}**", cell(v.hello.name), cell(v.hello.version), cell(who(v)));
  for (const std::string& words : v.identity.convention.words()) out += "; " + words;
  out += "\n\n| | what is held | defect | limit | where |\n|---|---|---|---|---|\n";
  for (const Result& r : v.results) {
    out += fmt::format("| {} | {} `{}` | {} | {} | {} |\n", word(r.status), r.title, r.id,
                       r.status == Status::left_out ? "" : fmt::format("{:.2g}", r.value),
                       r.status == Status::left_out ? "" : fmt::format("{:.2g}", r.limit), cell(r.where));
  }
  for (const std::string& lost : v.lost) out += fmt::format("| LOST | {} | | | |\n", cell(lost));
  return out;
}

std::string as_junit(const Verdict& v) {
  const int failures = count(v, Status::fail) + count(v, Status::unexpected_pass) + int(v.lost.size());
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"{}\" tests=\"{}\" "
      "failures=\"{}\" errors=\"0\" skipped=\"{}\">\n",
      reports::escaped(v.hello.name), v.results.size() + v.lost.size(), failures, count(v, Status::left_out));
  for (const Result& r : v.results) {
    out += fmt::format("<testcase classname=\"halfway.check\" name=\"{}\">", reports::escaped(r.id));
    if (r.status == Status::fail || r.status == Status::unexpected_pass)
      out +=
          fmt::format("<failure message=\"{}\">{}</failure>", word(r.status), reports::escaped(line_of(r)));
    if (r.status == Status::left_out)
      out += fmt::format("<skipped message=\"{}\"/>", reports::escaped(r.where));
    out += "</testcase>\n";
  }
  for (const std::string& lost : v.lost)
    out += fmt::format(
        "<testcase classname=\"halfway.check\" name=\"{}\"><failure "
        "message=\"lost\">{}</failure></testcase>\n",
        reports::escaped(lost.substr(0, lost.find(':'))), reports::escaped(lost));
  return out + "</testsuite>\n</testsuites>\n";
}

std::string as_badge(const Verdict& v) {
  const std::string message = v.is_known ? v.identity.name.substr(0, v.identity.name.find(',')) : "unknown";
  return nlohmann::ordered_json{
             {"schemaVersion", 1},
             {"label", "halfway"},
             {"message", fmt::format("{}, {} of {}", message, count(v, Status::pass), v.results.size())},
             {"color", v.fails() ? "orange" : "green"}}
             .dump(1) +
         "\n";
}

std::string as_ctest(const Verdict& v) {
  std::string out =
      fmt::format("<CTestMeasurement type=\"text/string\" name=\"joint\">{}</CTestMeasurement>\n",
                  reports::escaped(who(v)));
  const auto number = [&](const char* name, double x) {
    if (std::isfinite(x))
      out += fmt::format("<CTestMeasurement type=\"numeric/double\" name=\"{}\">{}</CTestMeasurement>\n",
                         name, x);
  };
  number("distance", v.identity.distance);
  number("passed", count(v, Status::pass));
  number("failed", count(v, Status::fail));
  return out;
}

}  // namespace halfway::check
