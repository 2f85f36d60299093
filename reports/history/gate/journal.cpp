#include "reports/history/gate/journal.hpp"

#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace halfway::gate {
namespace {

using nlohmann::json;

json json_of(const Turn& turn, const Reading& reading) {
  json figures = json::object();
  for (const auto& [name, f] : reading)
    figures[name] = f.wrong.empty() ? json::array({f.ns, f.error}) : json(f.wrong);
  return {{"run", turn.run},
          {"round", turn.round},
          {"pair", turn.pair},
          {"head", turn.head},
          {"figures", figures}};
}

double number(const json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::pair<Turn, Reading> entry(const json& line) {
  Reading reading;
  for (const auto& [name, f] : line.at("figures").items())
    reading[name] = f.is_string() ? Timed{.wrong = f.get<std::string>()}
                                  : Timed{.ns = number(f.at(0)), .error = number(f.at(1))};
  return {{line.at("run"), line.at("round"), line.at("pair"), line.at("head")}, reading};
}

}  // namespace

Journal::Journal(std::filesystem::path file, const json& about) : file_(std::move(file)) {
  std::string kept = about.dump() + '\n';
  if (std::filesystem::exists(file_)) {
    std::istringstream in(reports::read_file(file_));
    std::string line;
    if (std::getline(in, line) && line + '\n' == kept) {
      while (std::getline(in, line)) {
        const json parsed = json::parse(line, nullptr, false);
        if (parsed.is_discarded() || in.eof()) break;  // killed while it was written
        readings_.insert(entry(parsed));
        kept += line + '\n';
      }
    }
  }
  reports::write_file(file_, kept);
  out_.open(file_, std::ios::app);
}

const Reading* Journal::find(const Turn& turn) const {
  const auto found = readings_.find(turn);
  return found == readings_.end() ? nullptr : &found->second;
}

const Reading& Journal::add(const Turn& turn, const Reading& reading) {
  out_ << json_of(turn, reading).dump() << std::endl;
  if (!out_) throw reports::FileError(file_.string() + ": cannot write");
  return readings_[turn] = reading;
}

}  // namespace halfway::gate
