#include "reports/identify/read_csv.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/cli/streams.hpp"
#include "reports/identify/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace halfway::reports {
namespace {

namespace id = reference::identify;

constexpr std::size_t kMostRows = 20000;

/// What a line of the file means to the reader.
struct Reader {
  ReadCurves out{};
  std::vector<std::optional<Column>> columns{};  ///< of the block, in the order of the file
  char separator = 0;
  bool has_decimal_comma = false;
  std::optional<id::LoadCase> open{};
  std::string next_name{};
  std::set<std::string> ignored{};
  std::size_t rows = 0;
  int line = 0;

  void read(std::string_view text);
  void comment(std::string_view text);
  void hold(std::string_view names);
  void set_sigma(std::string_view text);
  void head(std::string_view text);
  void row(std::string_view text);
  void begin_case();
  void end_case();
  std::vector<std::string_view> cells(std::string_view text) const;
  double number(std::string_view text, const std::string& column, const reference::Unit& unit) const;
};

/// Of the separators of a head the one that occurs most.
char separator_of(std::string_view text) {
  char out = ',';
  std::ptrdiff_t most = 0;
  for (const char c : {',', ';', '\t'}) {
    const auto count = std::count(text.begin(), text.end(), c);
    if (count > most) most = count, out = c;
  }
  return out;
}

bool looks_like_number(std::string_view text) {
  text = trimmed_cell(text);
  return !text.empty() && (std::isdigit(static_cast<unsigned char>(text.front())) || text.front() == '-' ||
                           text.front() == '+' || text.front() == '.');
}

std::vector<std::string_view> Reader::cells(std::string_view text) const {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(trimmed_cell(text.substr(from, to - from)));
    if (to == std::string_view::npos) return parts;
    from = to + 1;
  }
}

/// In SI. What is too large for a double there is refused as what is no number.
double Reader::number(std::string_view text, const std::string& column, const reference::Unit& unit) const {
  std::string plain(text);
  if (has_decimal_comma || separator == ';') std::ranges::replace(plain, ',', '.');
  const std::string key = fmt::format("{} = {}", column, reference::shortened(plain));
  double value = 0;
  std::size_t used = 0;
  try {
    value = std::stod(plain, &used) * double(unit.factor);
  } catch (const std::exception&) {
    used = 0;
  }
  if (plain.empty() || used != plain.size() || !std::isfinite(value))
    refuse_at(line, key, plain.empty() ? "an empty cell" : "is no finite number",
              "a number in every cell of a row");
  return value;
}

void Reader::hold(std::string_view names) {
  if (!open) begin_case();
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t to = std::min(names.find_first_of(",; ", from), names.size());
    const std::string_view name = trimmed_cell(names.substr(from, to - from));
    from = to + 1;
    if (name.empty()) continue;
    if (name == "all") {
      open->held.fill(true);
      continue;
    }
    const auto column = named_column(name);
    if (!column || column->is_load)
      refuse_at(line, "held = " + reference::shortened(std::string(name)), "is no motion",
                "u_x, u_y, u_z, theta_x, theta_y, theta_z, all");
    open->held[std::size_t(column->component)] = true;
  }
}

/// "u = 0.01 mm, theta = 0.002 deg".
void Reader::set_sigma(std::string_view text) {
  constexpr std::array<std::string_view, 4> kNames = {"u", "theta", "f", "m"};
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find_first_of(",;", from), text.size());
    const std::string_view one = text.substr(from, to - from);
    from = to + 1;
    const std::size_t equals = one.find('=');
    const std::string_view name = trimmed_cell(one.substr(0, equals));
    const auto found = std::ranges::find(kNames, name);
    const std::string key = "sigma: " + reference::shortened(std::string(trimmed_cell(one)));
    if (found == kNames.end() || equals == std::string_view::npos)
      refuse_at(line, key, "is no noise", "u = 0.01 mm, theta = 0.002 deg, f = 1 N, m = 0.1 N m");
    const auto channel = std::size_t(found - kNames.begin());
    const auto [value, unit_text] = reference::split_quantity(trimmed_cell(one.substr(equals + 1)));
    const reference::Unit unit = read_component_unit(unit_text, channel >= 2, channel % 2 ? 3 : 0, key, line);
    const double size = number(value, key, unit);
    if (!(size > 0)) refuse_at(line, key, "is not positive", "a standard deviation above zero");
    out.data.sigma[channel] = size;
  }
}

void Reader::comment(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view key = trimmed_cell(text.substr(0, colon)),
                         value = trimmed_cell(text.substr(colon + 1));
  if (key == "sigma") return set_sigma(value);
  if (key != "held" && key != "case") return;
  if (open && !open->loads.empty()) end_case();
  if (key == "held") return hold(value);
  if (!open) begin_case();
  open->name = printable(reference::shortened(std::string(value)));
}

void Reader::begin_case() {
  open.emplace();
  open->line = line;
}

void Reader::end_case() {
  if (open && !open->loads.empty()) {
    if (open->name.empty()) open->name = fmt::format("case {}", out.data.cases.size() + 1);
    out.data.cases.push_back(std::move(*open));
  }
  open.reset();
}

void Reader::head(std::string_view text) {
  separator = separator_of(text);
  columns.clear();
  std::set<std::string> seen;
  for (const std::string_view cell : cells(text)) {
    columns.push_back(read_column(cell, line));
    if (!columns.back()) {
      if (!cell.empty()) ignored.insert(printable(reference::shortened(std::string(cell))));
    } else if (!seen.insert(columns.back()->name).second) {
      refuse_at(line, columns.back()->name, "stands twice", "each column once");
    }
  }
  if (seen.empty())
    refuse_at(line, reference::shortened(std::string(text)), "is no head of columns that are known",
              "columns of " + column_names() + ", with units: f_x [N], theta_z [deg]");
}

void Reader::row(std::string_view text) {
  if (columns.empty())
    refuse_at(line, reference::shortened(std::string(text)), "numbers before a head",
              "a line of column names with units first: f_x [N], u_x [mm]");
  if (!open) begin_case();
  const auto all = cells(text);
  if (all.size() != columns.size())
    refuse_at(line, reference::shortened(std::string(text)),
              fmt::format("{} cells below {} columns", all.size(), columns.size()), "a cell for each column");
  if (++rows > kMostRows)
    refuse_at(line, "rows", fmt::format("more than {}", kMostRows), "fewer rows: every tenth, say");
  id::Vec6 load = id::Vec6::Zero(), motion = id::Vec6::Zero();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!columns[i]) continue;
    const Column& column = *columns[i];
    (column.is_load ? load : motion)[column.component] = number(all[i], column.name, column.unit);
    (column.is_load ? open->has_load : open->has_motion)[std::size_t(column.component)] = true;
  }
  if (motion.tail<3>().norm() >= std::numbers::pi)
    refuse_at(line, "theta", fmt::format("a rotation of {:.4g} rad", motion.tail<3>().norm()),
              "rotation vectors shorter than half a turn; deg where the numbers are degrees");
  open->loads.push_back(load);
  open->motions.push_back(motion);
}

void Reader::read(std::string_view text) {
  const std::string_view plain = trimmed_cell(text);
  if (plain.empty() || plain.find_first_not_of(",;\t ") == std::string_view::npos) return end_case();
  if (plain.front() == '#') return comment(plain.substr(1));
  if (looks_like_number(plain)) return row(text);
  if (open && !open->loads.empty()) end_case();
  head(text);
}

bool any(const std::array<bool, 6>& flags, int first) {
  return flags[std::size_t(first)] || flags[std::size_t(first + 1)] || flags[std::size_t(first + 2)];
}

/// Without any word of rotations the joint is a linear one, without any of translations an angular one.
Kind kind_of(const id::Data& data) {
  bool moves = false, turns = false;
  for (const id::LoadCase& one : data.cases) {
    moves = moves || any(one.has_load, 0) || any(one.has_motion, 0);
    turns = turns || any(one.has_load, 3) || any(one.has_motion, 3);
  }
  return moves && turns ? Kind::linear_angular : moves ? Kind::linear : Kind::angular;
}

void note_assumptions(const id::LoadCase& one, Kind kind, std::vector<std::string>& notes) {
  std::vector<std::string> zero, unmeasured, held, reaction;
  for (int i = id::first_component(kind); i < id::end_component(kind); ++i) {
    const auto at = std::size_t(i);
    if (!one.held[at] && !one.has_load[at]) zero.emplace_back(id::kLoadNames[at]);
    if (!one.held[at] && !one.has_motion[at]) unmeasured.emplace_back(id::kMotionNames[at]);
    if (one.held[at] && !one.has_motion[at]) held.emplace_back(id::kMotionNames[at]);
    if (one.held[at] && !one.has_load[at]) reaction.emplace_back(id::kLoadNames[at]);
  }
  const auto add = [&](const std::vector<std::string>& names, const char* what) {
    if (!names.empty()) notes.push_back(fmt::format("{}: {} {}", one.name, fmt::join(names, ", "), what));
  };
  add(zero, "without a column: no such load");
  add(unmeasured, "without a column: free, not measured");
  add(held, "held at zero");
  add(reaction, "not measured");
}

}  // namespace

ReadCurves read_csv(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Reader reader;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    ++reader.line;
    reader.read(text.substr(from, to - from));
    from = to + 1;
  }
  reader.end_case();
  ReadCurves& out = reader.out;
  if (out.data.cases.empty())
    refuse_at(std::max(1, reader.line), "the file", "has no row of numbers",
              "a head such as m_x [N m], theta_x [deg], and rows below it");
  out.data.kind = kind_of(out.data);
  if (out.data.kind == Kind::angular)
    out.notes.emplace_back("no forces and no displacements: an angular joint");
  if (out.data.kind == Kind::linear)
    out.notes.emplace_back("no moments and no rotations: a linear joint that does not turn");
  for (const id::LoadCase& one : out.data.cases) note_assumptions(one, out.data.kind, out.notes);
  if (!reader.ignored.empty())
    out.notes.push_back(fmt::format("columns left out: {}", fmt::join(reader.ignored, ", ")));
  return out;
}

}  // namespace halfway::reports
