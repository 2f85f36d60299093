// Adams Solver's BUSHING with its markers and units. Marker J, in whose axes the law is, is our node a, I
// node b.
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/frames.hpp"
#include "reports/import/record/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>

namespace halfway::imports {
namespace {

/// TYPE/ID, KEY = V, V, ...
struct AdamsStatement {
  int line = 1;
  std::string type{}, id{};
  std::map<std::string, std::vector<Source>> values{};

  const std::vector<Source>* find(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
  }
};

/// "K = 1" begins a key, "2" goes on with it.
void add_part(AdamsStatement& out, std::string_view part, int line, std::string& key) {
  const std::size_t equals = part.find('=');
  if (equals != std::string_view::npos) {
    key = upper(trimmed(part.substr(0, equals)));
    if (out.find(key))
      refuse({line, key, std::string(trimmed(part.substr(equals + 1)))}, "stands twice in its statement",
             "each key once");
    part = part.substr(equals + 1);
    out.values[key];
  }
  part = trimmed(part);
  if (!key.empty() && !part.empty()) out.values[key].push_back({line, key, std::string(part)});
}

void add_parts(AdamsStatement& out, std::string_view line, int number, std::string& key) {
  while (!line.empty()) {
    const std::size_t comma = line.find(',');
    add_part(out, line.substr(0, comma), number, key);
    line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  }
}

/// Statements of the types that are read; one goes on in lines that begin with a comma.
std::vector<AdamsStatement> statements_of_adams(std::string_view text) {
  std::vector<AdamsStatement> out;
  std::string key;
  bool is_read = false;
  int number = 0;
  for (std::string_view line : lines_of(text)) {
    ++number;
    line = trimmed(line.substr(0, line.find('!')));
    if (line.empty()) continue;
    if (line.front() == ',') {
      if (is_read) add_parts(out.back(), line.substr(1), number, key);
      continue;
    }
    const std::size_t slash = line.find('/');
    const std::string type = upper(trimmed(line.substr(0, slash)));
    is_read = slash != std::string_view::npos && (type == "BUSHING" || type == "MARKER" || type == "UNITS");
    if (!is_read) continue;
    std::string_view rest = line.substr(slash + 1);
    AdamsStatement statement{number, type};
    key.clear();
    if (type != "UNITS") {
      statement.id = trimmed(rest.substr(0, rest.find(',')));
      rest = rest.find(',') == std::string_view::npos ? std::string_view{} : rest.substr(rest.find(',') + 1);
    }
    out.push_back(std::move(statement));
    add_parts(out.back(), rest, number, key);
  }
  return out;
}

/// The three numbers of a key; zeros where it is missing. Angles may end with D, for degrees.
Vec3<double> three_of(const AdamsStatement& statement, const char* key, std::vector<Source>& from,
                      bool angles = false) {
  const auto* values = statement.find(key);
  if (!values) return Vec3<double>::Zero();
  if (values->size() != 3)
    refuse({values->empty() ? statement.line : values->front().line, key,
            values->empty() ? "" : values->front().text},
           fmt::format("has {} numbers", values->size()), "3 numbers");
  Vec3<double> out;
  std::string all;
  for (int i = 0; i < 3; ++i) {
    Source at = (*values)[std::size_t(i)];
    all += (i == 0 ? "" : ", ") + at.text;
    const bool is_degrees = angles && (at.text.ends_with('D') || at.text.ends_with('d'));
    if (is_degrees) at.text.pop_back();
    out[i] = number_of(at) * (is_degrees ? kDegree : 1);
  }
  from.push_back({values->front().line, key, all});
  return out;
}

Units units_from(const std::vector<AdamsStatement>& statements, const ImportOptions& options,
                 ImportedJoint& joint) {
  for (const auto& statement : statements) {
    if (statement.type != "UNITS") continue;
    const auto* system = statement.find("SYSTEM");
    if (system && !system->empty()) {
      if (upper(system->front().text) == "MKS") return {};
      refuse(system->front(), "is not known", "MKS, or FORCE = ..., LENGTH = ...");
    }
    const auto* length = statement.find("LENGTH");
    const auto* force = statement.find("FORCE");
    if (!length || length->size() != 1 || !force || force->size() != 1)
      refuse({statement.line, "UNITS", ""}, "lacks FORCE or LENGTH", "FORCE = ..., LENGTH = ...");
    return {length_unit(length->front()), force_unit(force->front()), 1};
  }
  std::string note;
  const Units out = units_said(options, note);
  joint.notes.push_back(note);
  return out;
}

using Markers = std::map<std::string, const AdamsStatement*, std::less<>>;

/// The marker that I or J names, on its part.
Frame marker_of(const Markers& markers, const AdamsStatement& bushing, const char* key,
                std::vector<Source>& from) {
  const auto* id = bushing.find(key);
  if (!id || id->size() != 1)
    refuse({bushing.line, key, ""}, fmt::format("is missing in BUSHING/{}", bushing.id),
           "the id of a MARKER");
  const auto found = markers.find(id->front().text);
  if (found == markers.end()) refuse(id->front(), "is no MARKER of the file", "the id of a MARKER");
  const AdamsStatement& marker = *found->second;
  for (const char* other : {"ZP", "XP", "USEXP", "NODE_ID", "FLOATING"}) {
    const auto* values = marker.find(other);
    if (values)
      refuse(
          {values->empty() ? marker.line : values->front().line, other, fmt::format("MARKER/{}", marker.id)},
          "is a way to place a marker that is not read", "QP and REULER");
  }
  const Vec3<double> o = three_of(marker, "QP", from);
  return {o, turns({2, 0, 2}, three_of(marker, "REULER", from, true))};
}

void read_law(const AdamsStatement& bushing, const Units& units, ImportedJoint& joint) {
  joint.K = Eigen::MatrixXd::Zero(6, 6);
  int row = 0;
  for (const char* key : {"K", "KT"}) {
    const Vec3<double> k = three_of(bushing, key, joint.law_from);
    if (k.minCoeff() < 0) check_stiffness(joint.law_from.back(), {k[0], k[1], k[2]});
    for (int i = 0; i < 3; ++i, ++row) joint.K(row, row) = k[i] * units.stiffness(row);
  }
  std::vector<Source> from;
  for (const char* key : {"C", "CT"}) {
    const Vec3<double> c = three_of(bushing, key, from);
    if (!c.isZero(0)) lose(joint, from.back(), {1}, kNoDamping);
  }
  // FORCE and TORQUE act on I at rest; ours are what is applied to b to hold it there.
  Eigen::VectorXd preload(6);
  preload << -units.force * three_of(bushing, "FORCE", joint.preload_from),
      -units.stress(3) * three_of(bushing, "TORQUE", joint.preload_from);
  if (!preload.isZero(0)) joint.preload = preload;
}

}  // namespace

std::vector<ImportedJoint> read_adams_solver(std::string_view text, const ImportOptions& options) {
  const auto statements = statements_of_adams(text);
  Markers markers;
  for (const auto& statement : statements) {
    if (statement.type == "MARKER") markers.emplace(statement.id, &statement);
  }
  std::vector<ImportedJoint> out;
  for (const auto& statement : statements) {
    if (statement.type != "BUSHING") continue;
    ImportedJoint joint;
    joint.program = "Adams Solver";
    joint.name = statement.id;
    joint.line = statement.line;
    const Units units = units_from(statements, options, joint);
    joint.a = marker_of(markers, statement, "J", joint.a_from);
    joint.b = marker_of(markers, statement, "I", joint.b_from);
    joint.a.o *= units.length, joint.b.o *= units.length;
    read_law(statement, units, joint);
    out.push_back(joint);
  }
  if (out.empty()) refuse({1, "the file", ""}, "has no bushing", "a statement BUSHING/ID, ...");
  return out;
}

}  // namespace halfway::imports
