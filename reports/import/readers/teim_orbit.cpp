// Adams property files, TeimOrbit: blocks, KEY = VALUE, rows of curves. They hold no law of rotation.
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace halfway::imports {
namespace {

constexpr const char* kCurves[] = {"FX_CURVE", "FY_CURVE", "FZ_CURVE", "TX_CURVE", "TY_CURVE", "TZ_CURVE"};
constexpr std::size_t kMostRows = 100000;

struct Block {
  int line = 1;
  std::map<std::string, Source> values{};
  std::vector<Source> rows{};
};
using Blocks = std::map<std::string, Block>;

/// Up to a comment, which begins with $ outside of quotes.
std::string_view uncommented(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\'') quoted = !quoted;
    if (line[i] == '$' && !quoted) return line.substr(0, i);
  }
  return line;
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') text = text.substr(1, text.size() - 2);
  return std::string(trimmed(text));
}

Blocks blocks_of(std::string_view text) {
  Blocks out;
  Block* block = nullptr;
  std::string name;
  int number = 0;
  for (const std::string_view raw : lines_of(text)) {
    ++number;
    const std::string_view line = trimmed(uncommented(raw));
    if (line.empty() || line.front() == '{' || line.front() == '(') continue;
    if (line.front() == '[') {
      const std::size_t end = line.find(']');
      if (end == std::string_view::npos) refuse({number, "a block", std::string(line)}, "has no ]", "[NAME]");
      name = upper(trimmed(line.substr(1, end - 1)));
      if (out.contains(name))
        refuse({number, "a block", name}, fmt::format("stands twice, also in line {}", out[name].line),
               "each block once");
      block = &out[name];
      block->line = number;
      continue;
    }
    if (block == nullptr)
      refuse({number, "a line", std::string(line)}, "stands in no block", "[MDI_HEADER] first");
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      if (block->rows.size() == kMostRows)
        refuse({number, name, std::string(line)}, "has too many rows", fmt::format("up to {}", kMostRows));
      block->rows.push_back({number, name, std::string(line)});
      continue;
    }
    const std::string key = upper(trimmed(line.substr(0, equals)));
    const Source value{number, key, unquoted(line.substr(equals + 1))};
    if (!block->values.emplace(key, value).second)
      refuse(value, "stands twice in its block", "each key once");
  }
  return out;
}

const Source& value_in(const Blocks& blocks, const std::string& block, const std::string& key) {
  const auto found = blocks.find(block);
  if (found == blocks.end())
    refuse({1, "[" + block + "]", ""}, "is missing", fmt::format("a block with {}", key));
  const auto value = found->second.values.find(key);
  if (value == found->second.values.end())
    refuse({found->second.line, key, ""}, fmt::format("is missing in [{}]", block), "the key");
  return value->second;
}

void check_header(const Blocks& blocks) {
  const auto header = blocks.find("MDI_HEADER");
  if (header == blocks.end()) return;
  const auto type = header->second.values.find("FILE_TYPE");
  if (type != header->second.values.end() && upper(type->second.text) != "BUS")
    refuse(type->second, "is no bushing's property file", "'bus'");
}

Units units_of(const Blocks& blocks) {
  return {length_unit(value_in(blocks, "UNITS", "LENGTH")), force_unit(value_in(blocks, "UNITS", "FORCE")),
          angle_unit(value_in(blocks, "UNITS", "ANGLE"))};
}

/// The two numbers of a row, in SI.
struct Row {
  double x, y;
};

std::vector<Row> rows_of(const Block& block, const char* name, const Units& units, int strain) {
  std::vector<Row> out;
  double before = 0;
  for (const Source& at : block.rows) {
    const auto v = numbers_of(at, 2);
    if (!out.empty() && !(v[0] > before))
      refuse(at, "does not go up", "abscissae in ascending order, each once");
    before = v[0];
    out.push_back({v[0] * units.strain(strain), v[1] * units.stress(strain)});
  }
  if (out.size() < 2)
    refuse({block.line, name, fmt::format("{} rows", out.size())}, "is no curve", "two rows or more");
  return out;
}

/// Its stiffness where all rows are exactly proportional, from the file's own numbers.
bool is_proportional(const Block& block, const Units& units, int strain, double& stiffness) {
  double x0 = 0, y0 = 0;
  for (const Source& at : block.rows) {
    const auto v = numbers_of(at, 2);
    if (std::abs(v[0]) > std::abs(x0)) x0 = v[0], y0 = v[1];
  }
  const double k = y0 / x0;
  for (const Source& at : block.rows) {
    const auto v = numbers_of(at, 2);
    if (k * v[0] != v[1]) return false;
  }
  stiffness = k * units.stiffness(strain);
  return true;
}

AxisLaw axis_of(const Block& block, const char* name, const Units& units, int strain) {
  const auto rows = rows_of(block, name, units, strain);
  AxisLaw out;
  if (is_proportional(block, units, strain, out.stiffness) && out.stiffness >= 0) return out;
  for (const Row& row : rows) out.x.push_back(row.x), out.y.push_back(row.y);
  return out;
}

void note_short_curve(const char* name, const Block& block, ImportedJoint& joint) {
  const std::size_t rows = joint.axes.back().x.size();
  if (rows > 0 && rows < kFewestAkima)
    joint.notes.push_back(
        fmt::format("[{}] (line {}): {} rows are too few for Akima's interpolation: straight lines", name,
                    block.line, rows));
}

void read_curves(const Blocks& blocks, const Units& units, ImportedJoint& joint) {
  for (int i = 0; i < 6; ++i) {
    const auto found = blocks.find(kCurves[i]);
    if (found == blocks.end())
      refuse({1, fmt::format("[{}]", kCurves[i]), ""}, "is missing",
             "six blocks of curves, FX_CURVE to TZ_CURVE");
    joint.axes.push_back(axis_of(found->second, kCurves[i], units, i));
    note_short_curve(kCurves[i], found->second, joint);
    joint.law_from.push_back(
        {found->second.line, kCurves[i], fmt::format("{} rows", found->second.rows.size())});
  }
  if (std::ranges::any_of(joint.axes, [](const AxisLaw& axis) { return !axis.x.empty(); })) return;
  joint.K = Eigen::MatrixXd::Zero(6, 6);
  for (int i = 0; i < 6; ++i) joint.K(i, i) = joint.axes[std::size_t(i)].stiffness;
  joint.axes.clear();
}

void read_damping(const Blocks& blocks, ImportedJoint& joint) {
  for (const char* name : {"DAMPING", "DAMPING_COEFFICIENTS"}) {
    const auto found = blocks.find(name);
    if (found == blocks.end()) continue;
    for (const auto& [key, value] : found->second.values) lose(joint, value, {number_of(value)}, kNoDamping);
  }
}

void name_other_blocks(const Blocks& blocks, ImportedJoint& joint) {
  for (const auto& [name, block] : blocks) {
    const bool is_read = name == "MDI_HEADER" || name == "UNITS" || name.starts_with("DAMPING") ||
                         std::ranges::find(kCurves, name) != std::end(kCurves);
    if (!is_read) joint.lost.push_back(fmt::format("[{}] (line {}): not read", name, block.line));
  }
}

}  // namespace

std::vector<ImportedJoint> read_teim_orbit(std::string_view text, const ImportOptions&) {
  const Blocks blocks = blocks_of(text);
  check_header(blocks);
  ImportedJoint joint;
  joint.program = "Adams property file";
  joint.name = "bushing";
  read_curves(blocks, units_of(blocks), joint);
  read_damping(blocks, joint);
  name_other_blocks(blocks, joint);
  joint.notes.push_back(
      "places on the bodies, preloads and scales stand in the assembly (.sub), not here: the joint is put at "
      "the nodes");
  return {joint};
}

}  // namespace halfway::imports
