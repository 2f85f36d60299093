#include "reports/import/record/units.hpp"

#include "reports/import/record/frames.hpp"

#include <span>
#include <string>

namespace halfway::imports {
namespace {

struct Word {
  std::string_view name;
  double value;
};

constexpr double kPound = 4.4482216152605;  // N, by definition
constexpr double kKilopond = 9.80665;       // N, by definition

constexpr Word kLengths[] = {{"METER", 1},  {"METERS", 1},        {"M", 1},       {"CENTIMETER", 1e-2},
                             {"CM", 1e-2},  {"MILLIMETER", 1e-3}, {"MM", 1e-3},   {"KILOMETER", 1e3},
                             {"KM", 1e3},   {"INCH", 0.0254},     {"IN", 0.0254}, {"FOOT", 0.3048},
                             {"FT", 0.3048}};
constexpr Word kForces[] = {{"NEWTON", 1},      {"N", 1},
                            {"KNEWTON", 1e3},   {"KILONEWTON", 1e3},
                            {"KN", 1e3},        {"KILOGRAM_FORCE", kKilopond},
                            {"KGF", kKilopond}, {"POUND_FORCE", kPound},
                            {"LBF", kPound},    {"DYNE", 1e-5}};
constexpr Word kAngles[] = {{"DEG", kDegree}, {"DEGREE", kDegree}, {"DEGREES", kDegree},
                            {"RAD", 1},       {"RADIAN", 1},       {"RADIANS", 1}};

double word_of(const Source& at, std::span<const Word> words) {
  const std::string name = upper(at.text);
  std::string allowed;
  for (const Word& word : words) {
    if (word.name == name) return word.value;
    allowed += (allowed.empty() ? "" : ", ") + std::string(word.name);
  }
  refuse(at, "is no unit known here", allowed + ", in any case of letters");
}

}  // namespace

double length_unit(const Source& at) { return word_of(at, kLengths); }
double force_unit(const Source& at) { return word_of(at, kForces); }
double angle_unit(const Source& at) { return word_of(at, kAngles); }

Units units_said(const ImportOptions& options, std::string& note) {
  if (options.units == "mm") {
    note = "units: mm, N, N mm/rad, as --units says";
    return {1e-3, 1, 1};
  }
  note = options.units.empty() ? "the file has no units: taken as m, N, rad (--units mm if it is in mm and N)"
                               : "units: m, N, rad, as --units says";
  return {};
}

}  // namespace halfway::imports
