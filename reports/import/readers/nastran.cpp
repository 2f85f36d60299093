// Nastran: PBUSH, and where they are CBUSH, GRID and CORD2R, in fields of 8 or 16 columns or between commas.
// A linear element: it holds no law of rotation. GA is our node a, GB node b.
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/frames.hpp"
#include "reports/import/record/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace halfway::imports {
namespace {

/// A card's fields from the second on: eight of each line.
struct Card {
  int line = 1;
  std::string name{};
  std::vector<Source> fields{};

  /// Field of the card's own count, from 2; empty beyond the end.
  Source field(std::size_t number, const char* what) const {
    if (number - 2 < fields.size())
      return {fields[number - 2].line, name + " " + what, fields[number - 2].text};
    return {line, name + " " + what, ""};
  }
};

std::vector<std::string> fields_between_commas(std::string_view line) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t comma = line.find(',');
    out.emplace_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return out;
    line = line.substr(comma + 1);
  }
}

std::vector<std::string> fields_of_columns(std::string_view line, std::size_t width) {
  std::vector<std::string> out{std::string(trimmed(line.substr(0, 8)))};
  for (std::size_t at = 8; at < line.size() && at < 72; at += width)
    out.emplace_back(trimmed(line.substr(at, width)));
  return out;
}

constexpr std::string_view kRead[] = {"PBUSH", "CBUSH", "GRID", "CORD2R"};

/// The cards that are read; one goes on in lines that begin with a blank field, + or *.
std::vector<Card> cards_of(std::string_view text) {
  std::vector<Card> out;
  bool is_read = false;
  int number = 0;
  for (std::string_view line : lines_of(text)) {
    ++number;
    line = line.substr(0, line.find('$'));
    if (trimmed(line).empty()) continue;
    const bool is_free = line.find(',') != std::string_view::npos;
    const std::string_view first = trimmed(line.substr(0, is_free ? line.find(',') : 8));
    const bool is_large = !is_free && first.find('*') != std::string_view::npos;
    auto fields = is_free ? fields_between_commas(line) : fields_of_columns(line, is_large ? 16 : 8);
    const bool goes_on = first.empty() || first.front() == '+' || first.front() == '*';
    if (!goes_on) {
      const std::string name = upper(first.substr(0, first.find('*')));
      is_read = std::ranges::find(kRead, name) != std::end(kRead);
      if (is_read) out.push_back({number, name});
    }
    if (!is_read || out.empty()) continue;
    fields.resize(is_large ? 5 : 9);
    for (std::size_t i = 1; i < fields.size(); ++i)
      out.back().fields.push_back({number, out.back().name, fields[i]});
  }
  return out;
}

/// Also 1.5+3, Nastran's short exponent.
double real_of(Source at) {
  const std::size_t sign = at.text.find_last_of("+-");
  const bool is_short = sign != std::string::npos && sign > 0 &&
                        std::string_view("eEdD").find(at.text[sign - 1]) == std::string_view::npos;
  Source whole = at;
  if (is_short) whole.text.insert(sign, "e");
  return number_of(whole);
}

double real_or_zero(const Source& at) { return at.text.empty() ? 0 : real_of(at); }

struct Deck {
  std::map<std::string, const Card*> properties{}, grids{}, systems{};
  std::vector<const Card*> elements{};
};

Deck deck_of(const std::vector<Card>& cards) {
  Deck out;
  for (const Card& card : cards) {
    if (card.name == "CBUSH") {
      out.elements.push_back(&card);
      continue;
    }
    const Source id = card.field(2, "id");
    if (id.text.empty()) refuse(id, "is missing", "an id in field 2");
    auto& kind = card.name == "PBUSH" ? out.properties : card.name == "GRID" ? out.grids : out.systems;
    if (!kind.emplace(id.text, &card).second) refuse(id, "stands twice", "each id once");
  }
  return out;
}

Vec3<double> three_from(const Card& card, std::size_t first, const char* what) {
  return {real_or_zero(card.field(first, what)), real_or_zero(card.field(first + 1, what)),
          real_or_zero(card.field(first + 2, what))};
}

Vec3<double> grid_point(const Deck& deck, const Source& id, std::vector<Source>& from) {
  const auto found = deck.grids.find(id.text);
  if (found == deck.grids.end()) refuse(id, "is no GRID of the file", "the id of a GRID");
  const Card& grid = *found->second;
  const Source system = grid.field(3, "CP");
  if (!system.text.empty() && system.text != "0")
    refuse(system, "is another coordinate system", "0, the basic one");
  from.push_back({grid.line, "GRID", id.text});
  return three_from(grid, 4, "X");
}

Mat3<double> axes_of(const Source& at, const Vec3<double>& first, int axis, const Vec3<double>& second) {
  const Vec3<double> normal = first.cross(second);
  if (!(normal.norm() > 1e-9 * first.norm() * second.norm()) || !std::isfinite(normal.norm()))
    refuse(at, "gives no axes: two directions are parallel or zero", "directions that are neither");
  Mat3<double> R;
  const Vec3<double> u = first.normalized(), w = normal.normalized();
  // x and a vector in the plane of x and y; or z and one in that of x and z.
  if (axis == 0)
    R << u, w.cross(u), w;
  else
    R << w.cross(u), w, u;
  return R;
}

/// Of a CBUSH: the system CID, or x from GA to GB and the plane of x and y by a vector or point.
Mat3<double> element_axes(const Deck& deck, const Card& element, const Vec3<double>& a, const Vec3<double>& b,
                          std::vector<Source>& from) {
  const Source id = element.field(9, "CID"), x1 = element.field(6, "GO/X1");
  if (id.text == "0") return Mat3<double>::Identity();
  if (!id.text.empty()) {
    const auto found = deck.systems.find(id.text);
    if (found == deck.systems.end()) refuse(id, "is no CORD2R of the file", "0, or the id of a CORD2R");
    const Card& system = *found->second;
    const Source based = system.field(3, "RID");
    if (!based.text.empty() && based.text != "0")
      refuse(based, "is another coordinate system", "0, the basic one");
    const Vec3<double> A = three_from(system, 4, "A"), B = three_from(system, 7, "B"),
                       C = three_from(system, 10, "C");
    from.push_back({system.line, "CORD2R", id.text});
    return axes_of(id, B - A, 2, C - A);
  }
  if (x1.text.empty())
    refuse({element.line, "CBUSH CID", ""}, "is missing, and so is the vector GO or X1, X2, X3",
           "0, the id of a CORD2R, or a vector");
  const bool is_point = element.field(7, "X2").text.empty() && element.field(8, "X3").text.empty();
  const Vec3<double> v =
      is_point ? Vec3<double>(grid_point(deck, x1, from) - a) : three_from(element, 6, "X");
  return axes_of(x1, b - a, 0, v);
}

void read_place(const Deck& deck, const Card& element, ImportedJoint& joint) {
  const Vec3<double> a = grid_point(deck, element.field(4, "GA"), joint.a_from);
  const Source second = element.field(5, "GB");
  if (second.text.empty())
    joint.notes.push_back(fmt::format("CBUSH (line {}) has no GB: node b is the ground at GA", element.line));
  const Vec3<double> b = second.text.empty() ? a : grid_point(deck, second, joint.b_from);
  const Source share = element.field(10, "S"), system = element.field(11, "OCID");
  if (!system.text.empty() && system.text != "-1")
    refuse(system, "places the spring in a coordinate system", "-1 or nothing, and S");
  const double s = share.text.empty() ? 0.5 : real_of(share);
  if (!(s >= 0 && s <= 1)) refuse(share, "is out of range", "0 to 1");
  const Vec3<double> at = a + s * (b - a);
  joint.a.o = at - a, joint.b.o = at - b;
  joint.a.H = joint.b.H = element_axes(deck, element, a, b, joint.a_from);
}

constexpr std::string_view kFlags[] = {"K", "B", "GE", "RCV", "M", "T", "KN", "ALPHA"};

/// Up to six numbers behind a flag; what is blank is zero.
struct Group {
  Source at{};
  std::vector<double> values{};
};

Group group_at(const Card& property, std::size_t at, const std::string& flag) {
  Group out{{property.field(at, "flag").line, "PBUSH " + flag, ""}};
  for (std::size_t i = 1; i <= 6; ++i) {
    const Source value = property.field(at + i, (flag + std::to_string(i)).c_str());
    out.values.push_back(real_or_zero(value));
    if (flag == "K" && out.values.back() < 0) refuse(value, "is a negative stiffness", "numbers >= 0");
    out.at.text += (i == 1 ? "" : ", ") + (value.text.empty() ? "-" : value.text);
  }
  return out;
}

/// Each group begins a line, or follows the eight fields of another.
void read_law(const Card& property, ImportedJoint& joint) {
  joint.K = Eigen::MatrixXd::Zero(6, 6);
  std::set<std::string> seen;
  for (std::size_t at = 3; at - 2 < property.fields.size(); at += 8) {
    const Source flag = property.field(at, "flag");
    const std::string name = upper(flag.text);
    if (name.empty()) continue;
    if (std::ranges::find(kFlags, name) == std::end(kFlags))
      refuse(flag, "is not known", "K, B, GE, RCV, M, T");
    if (!seen.insert(name).second) refuse(flag, "stands twice in its card", "each flag once");
    const Group group = group_at(property, at, name);
    if (name == "K") {
      for (int i = 0; i < 6; ++i) joint.K(i, i) = group.values[std::size_t(i)];
      joint.law_from.push_back(group.at);
    } else {
      lose(joint, group.at, group.values, name == "B" || name == "GE" ? kNoDamping : "a scene cannot say it");
    }
  }
}

ImportedJoint joint_of_property(const Card& property, std::string name, int line, const Units& units,
                                const std::string& note) {
  ImportedJoint joint;
  joint.program = "Nastran";
  joint.name = std::move(name);
  joint.line = line;
  joint.notes.push_back(note);
  read_law(property, joint);
  for (int i = 0; i < 6; ++i) joint.K(i, i) *= units.stiffness(i);
  return joint;
}

}  // namespace

std::vector<ImportedJoint> read_nastran(std::string_view text, const ImportOptions& options) {
  const auto cards = cards_of(text);
  const Deck deck = deck_of(cards);
  std::string note;
  const Units units = units_said(options, note);
  std::vector<ImportedJoint> out;
  std::map<std::string, const Card*> unused = deck.properties;
  for (const Card* element : deck.elements) {
    const Source id = element->field(2, "EID"), pid = element->field(3, "PID");
    const auto property = deck.properties.find(pid.text.empty() ? id.text : pid.text);
    if (property == deck.properties.end()) refuse(pid, "is no PBUSH of the file", "the id of a PBUSH");
    unused.erase(property->first);
    ImportedJoint joint =
        joint_of_property(*property->second, "CBUSH " + id.text, element->line, units, note);
    read_place(deck, *element, joint);
    joint.a.o *= units.length, joint.b.o *= units.length;
    out.push_back(joint);
  }
  for (const auto& [id, property] : unused) {
    out.push_back(joint_of_property(*property, "PBUSH " + id, property->line, units, note));
    out.back().notes.push_back("no CBUSH has it: the joint is put at the nodes");
  }
  if (out.empty()) refuse({1, "the file", ""}, "has no bushing", "PBUSH");
  return out;
}

}  // namespace halfway::imports
