#include "reports/history/gate/line.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace halfway::gate {
namespace {

constexpr Sense kOrder[] = {Sense::regression, Sense::improvement, Sense::change};

const char* word(Sense sense) {
  return sense == Sense::regression ? "REGRESSION" : sense == Sense::improvement ? "improvement" : "changed";
}

/// Every replacement of one character.
std::string replaced(const std::string& text, const std::vector<std::pair<char, const char*>>& by) {
  std::string out;
  for (const char c : text) {
    const auto found = std::ranges::find(by, c, &std::pair<char, const char*>::first);
    if (found == by.end())
      out += c;
    else
      out += found->second;
  }
  return out;
}

std::string cell(const std::string& text) {
  return replaced(reports::printable(text),
                  {{'|', "\\|"}, {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'`', "'"}});
}

std::string summary(const Outcome& o) {
  return fmt::format("{} figures compared: {} worse, {} better, {} changed", o.compared,
                     o.count(Sense::regression), o.count(Sense::improvement), o.count(Sense::change));
}

template <class Use>
void each_regression(const Outcome& outcome, Use use) {
  for (const Line& line : outcome.lines)
    if (line.sense == Sense::regression) use(line);
}

}  // namespace

int Outcome::count(Sense sense) const { return int(std::ranges::count(lines, sense, &Line::sense)); }

std::string as_text(const Outcome& outcome, bool all) {
  std::string out = reports::printable(outcome.title) + '\n';
  for (const Sense sense : kOrder) {
    if (sense == Sense::change && !all) continue;
    for (const Line& line : outcome.lines)
      if (line.sense == sense)
        out += reports::printable(fmt::format("{} {}: {}", word(sense), line.figure, line.text)) + '\n';
  }
  for (const std::string& note : outcome.notes) out += "note: " + reports::printable(note) + '\n';
  return out + summary(outcome) + '\n';
}

std::string as_markdown(const Outcome& outcome) {
  const bool bad = outcome.count(Sense::regression) > 0;
  std::string out = fmt::format("### {} Halfway: {}\n\n{}.\n", bad ? "\u274c" : "\u2705", cell(outcome.title),
                                summary(outcome));
  for (const Sense sense : {Sense::regression, Sense::improvement}) {
    if (outcome.count(sense) == 0) continue;
    out += fmt::format("\n| {} | |\n|---|---|\n", word(sense));
    for (const Line& line : outcome.lines)
      if (line.sense == sense) out += fmt::format("| {} | {} |\n", cell(line.figure), cell(line.text));
  }
  for (const std::string& note : outcome.notes) out += "\n" + cell(note) + ".\n";
  return out;
}

Service service_of(const std::string& name) {
  if (name == "auto") {
    const auto set = [](const char* variable) { return std::getenv(variable) != nullptr; };
    return set("GITHUB_ACTIONS") ? Service::github
           : set("GITLAB_CI")    ? Service::gitlab
           : set("TF_BUILD")     ? Service::azure
                                 : Service::none;
  }
  if (name == "github") return Service::github;
  if (name == "gitlab") return Service::gitlab;
  if (name == "azure") return Service::azure;
  if (name == "none") return Service::none;
  throw reports::BadInput(
      fmt::format("--annotations: unknown service '{}'; allowed: auto, github, gitlab, azure, none", name));
}

std::string annotations(const Outcome& outcome, Service service) {
  std::string out;
  each_regression(outcome, [&](const Line& line) {
    // What each service takes for the end of a property or of the line.
    if (service == Service::github)
      out += fmt::format(
          "::error title={}::{}\n",
          replaced(line.figure, {{'%', "%25"}, {'\r', "%0D"}, {'\n', "%0A"}, {':', "%3A"}, {',', "%2C"}}),
          replaced(line.figure + ": " + line.text, {{'%', "%25"}, {'\r', "%0D"}, {'\n', "%0A"}}));
    if (service == Service::azure)
      out += fmt::format(
          "##vso[task.logissue type=error]{}\n",
          replaced(line.figure + ": " + line.text, {{'%', "%AZP25"}, {'\r', "%0D"}, {'\n', "%0A"}}));
  });
  return out;
}

std::string code_quality(const Outcome& outcome) {
  auto all = nlohmann::ordered_json::array();
  each_regression(outcome, [&](const Line& line) {
    // The name alone: the same regression in two pipelines is one finding.
    const std::size_t print = std::hash<std::string>()(line.figure);
    all.push_back({{"description", line.figure + ": " + line.text},
                   {"check_name", "halfway gate"},
                   {"fingerprint", fmt::format("{:016x}", print)},
                   {"severity", "major"},
                   {"location", {{"path", line.figure}, {"lines", {{"begin", 1}}}}}});
  });
  return all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace halfway::gate
