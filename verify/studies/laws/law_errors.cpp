// Laws and units that are wrong: refused by file, line, key, value and what is allowed.
#include "verify/oracle/broken_scene.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

constexpr const char* kCurves = R"(title = "good"
[joint]
kind = "angular"
offset_a = ["12 mm", 0, "0.1 in"]
offset_b = { values = [1, 2, 3], unit = "mm" }
[joint.law]
type = "per_axis"
preload = ["1 N m", 0, 0]
offset = [0, "2 deg", 0]
[[joint.law.axis]]
x = [-2, -1, 0, 1, 3]
y = [-5, -2, 0, 2, 3]
interpolation = "akima"
[[joint.law.axis]]
negative = 1.8
positive = 2.6
[[joint.law.axis]]
k1 = 2
k3 = "1 N m/deg^3"
[[load]]
type = "fixed_moment"
value = [0, 0, "1 lbf in"]
[path]
factor_end = 1
)";

constexpr const char* kMatrix = R"(title = "good"
[joint]
kind = "linear_angular"
[joint.law]
type = "linear"
K = [[10, 0.1, 0, 0, 0, "1 N/deg"],
     [0.2, 10, 0, 0, 0, 0],
     [0, 0, "3 kN/m", 0, 0, 0],
     [0, 0, 0, 2, 0, 0],
     [0, 0, 0, 0, 2, 0],
     ["1 N/deg", 0, 0, 0, 0, "90 N m/deg"]]
tolerance = 0.02
axes = [0.8, 0.6, 0, 0]
[[load]]
type = "fixed_force"
value = [1, 0, 0]
point = ["1 ft", 0, 0]
[path]
factor_end = 1
)";

// The line of a table of [[joint.law.axis]] is that of its own header.
constexpr Broken kBrokenCurves[] = {
    {"axes_too_few", "joint.law.axis = [a table, a table]: has 2 tables; allowed: 3 tables",
     "[[joint.law.axis]]\nx = [-2, -1, 0, 1, 3]\ny = [-5, -2, 0, 2, 3]\ninterpolation = "
     "\"akima\"\n[[joint.law.axis]]",
     "[[joint.law.axis]] #!"},
    {"axes_too_many", "joint.law.axis = [a table, a table, a table, a table]: has more tables than strains",
     "[[joint.law.axis]]\nx", "[[joint.law.axis]] #!\nstiffness = 1\n[[joint.law.axis]]\nx"},
    {"axis_no_table", "joint.law.axis = a table: ",
     "[[joint.law.axis]]\nx = [-2, -1, 0, 1, 3]\ny = [-5, -2, 0, 2, 3]\n"
     "interpolation = \"akima\"\n[[joint.law.axis]]\nnegative = 1.8\npositive = 2.6\n[[joint.law.axis]]\nk1 "
     "= 2\nk3 = \"1 N m/deg^3\"",
     "axis = { k1 = 1 } #!"},
    {"axis_empty", "joint.law.axis[2] = a table: says no law; allowed: stiffness; k1, k3, k5; x, y",
     "[[joint.law.axis]]\nnegative = 1.8\npositive = 2.6\n", "[[joint.law.axis]] #!\n"},
    {"axis_unknown_key",
     "joint.law.axis[2].postive = 2.6: is not a known key (did you mean 'positive'?); allowed: stiffness",
     "positive = 2.6", "postive = 2.6 #!"},
    {"axis_two_laws", "joint.law.axis[3].k1 = 2: stands beside another law of the axis; allowed: one of",
     "k1 = 2", "k1 = 2 #!\nstiffness = 3"},
    {"axis_half_a_slope", "joint.law.axis[2].positive = nothing: is missing; allowed: the slopes",
     "[[joint.law.axis]]\nnegative = 1.8\npositive = 2.6", "[[joint.law.axis]] #!\nnegative = 1.8"},
    {"axis_no_k1", "joint.law.axis[3].k1 = nothing: is missing; allowed: ", "[[joint.law.axis]]\nk1 = 2",
     "[[joint.law.axis]] #!"},
    {"axis_no_y", "joint.law.axis[1].y = nothing: is missing; allowed: a stress for each x",
     "[[joint.law.axis]]\nx = [-2, -1, 0, 1, 3]\ny = [-5, -2, 0, 2, 3]",
     "[[joint.law.axis]] #!\nx = [-2, -1, 0, 1, 3]"},
    {"slope_negative",
     "joint.law.axis[2].negative = -1.8: is negative, but is a slope at rest; allowed: a number >= 0",
     "negative = 1.8", "negative = -1.8 #!"},
    {"slope_infinite", "joint.law.axis[2].positive = inf: is not finite; allowed: a finite number",
     "positive = 2.6", "positive = inf #!"},
    {"table_lengths",
     "joint.law.axis[1].y = [-5, -2, 0, 2]: has 4 entries, x has 5; allowed: a stress for each x",
     "y = [-5, -2, 0, 2, 3]", "y = [-5, -2, 0, 2] #!"},
    {"table_too_short", "joint.law.axis[1].x = [-1, 0, 1]: has 3 points; allowed: at least 5",
     "x = [-2, -1, 0, 1, 3]\ny = [-5, -2, 0, 2, 3]", "x = [-1, 0, 1] #!\ny = [-2, 0, 2]"},
    {"table_not_increasing",
     "joint.law.axis[1].x = [-2, -1, 0, 0, 3]: does not increase: 0 comes behind 0; allowed: strains that "
     "strictly",
     "x = [-2, -1, 0, 1, 3]", "x = [-2, -1, 0, 0, 3] #!"},
    {"table_backwards",
     "joint.law.axis[1].x = [3, 1, 0, -1, -2]: does not increase: 1 comes behind 3; allowed: ",
     "x = [-2, -1, 0, 1, 3]", "x = [3, 1, 0, -1, -2] #!"},
    {"table_falls_at_rest",
     "joint.law.axis[1].y = [5, 2, 0, -2, -3]: falls at rest: its slope at zero strain is -2",
     "y = [-5, -2, 0, 2, 3]", "y = [5, 2, 0, -2, -3] #!"},
    {"table_steep",
     "joint.law.axis[1].x = [-2, -1e-320, 0, 1, 3]: has points whose slope is not finite; allowed: points "
     "farther apart",
     "x = [-2, -1, 0, 1, 3]", "x = [-2, -1e-320, 0, 1, 3] #!"},
    {"table_of_tables", "joint.law.axis[1].x[2] = [1]: is an array; allowed: a finite number",
     "x = [-2, -1, 0, 1, 3]", "x = [-2, [1], 0, 1, 3] #!"},
    {"table_in_newtons",
     "joint.law.axis[1].y[2] = \"-2 N\": is in N (N in SI) where N m is needed; allowed: a number, N m",
     "y = [-5, -2, 0, 2, 3]", "y = [-5, \"-2 N\", 0, 2, 3] #!"},
    {"interpolation_unknown",
     "joint.law.axis[1].interpolation = \"akimaa\": is not a known name (did you mean 'akima'?); allowed: "
     "linear, akima, monotone",
     "\"akima\"", "\"akimaa\" #!"},
    {"law_type_unknown",
     "joint.law.type = \"per_axes\": is not a known name (did you mean 'per_axis'?); allowed: linear, "
     "polynomial, per_axis",
     "\"per_axis\"", "\"per_axes\" #!"},
    {"law_type_of_others",
     "joint.law.type = \"table\": is not a known name (did you mean 'per_axis'?); allowed: linear, "
     "polynomial, per_axis",
     "\"per_axis\"", "\"table\" #!"},
    {"preload_too_short", "joint.law.preload = [1, 2]: has 2 entries; allowed: 3 numbers",
     "preload = [\"1 N m\", 0, 0]", "preload = [1, 2] #!"},
    {"preload_of_force", "joint.law.preload[1] = \"1 N\": is in N (N in SI) where N m is needed",
     "preload = [\"1 N m\", 0, 0]", "preload = [\"1 N\", 0, 0] #!"},
    {"offset_in_metres",
     "joint.law.offset[2] = \"2 mm\": is in mm (m in SI) where rad is needed; allowed: a number, rad, or a "
     "text of a "
     "number and a unit: rad, deg, mrad",
     "offset = [0, \"2 deg\", 0]", "offset = [0, \"2 mm\", 0] #!"},
    {"axes_of_curves",
     "joint.law.axes = [1, 0, 0, 0]: stands beside a law that is not linear, whose strains are along the "
     "joint's axes; "
     "allowed: axes of a linear law; turn frame_a and frame_b",
     "offset = [0, \"2 deg\", 0]", "axes = [1, 0, 0, 0] #!"},
    {"unit_unknown",
     "joint.offset_a[1] = \"12 mn\": has the unit 'mn', which has 'mn', which is no unit that is known",
     "\"12 mm\", 0, \"0.1 in\"]", "\"12 mn\", 0, 0] #!"},
    {"unit_of_angle",
     "joint.offset_a[1] = \"12 deg\": is in deg (rad in SI) where m is needed; allowed: a number, m, or a "
     "text of a number "
     "and a unit: m, mm, in",
     "\"12 mm\", 0, \"0.1 in\"]", "\"12 deg\", 0, 0] #!"},
    {"unit_missing", "joint.offset_a[1] = \"12\": is a text without a unit; allowed: a number, m",
     "\"12 mm\", 0, \"0.1 in\"]", "\"12\", 0, 0] #!"},
    {"unit_alone", "joint.offset_a[1] = \"mm\": is a text; allowed: a number, m", "\"12 mm\", 0, \"0.1 in\"]",
     "\"mm\", 0, 0] #!"},
    {"unit_comma", "joint.offset_a[1] = \"1,5 mm\": has the unit ',5 mm', which ",
     "\"12 mm\", 0, \"0.1 in\"]", "\"1,5 mm\", 0, 0] #!"},
    {"unit_overflow", "joint.offset_a[1] = \"1e308 km\": is not finite; allowed: a finite number",
     "\"12 mm\", 0, \"0.1 in\"]", "\"1e308 km\", 0, 0] #!"},
    {"unit_bracket",
     "joint.offset_a[1] = \"1 (mm\": has the unit '(mm', which has a bracket that is not closed; allowed: m, "
     "cm, mm",
     "\"12 mm\", 0, \"0.1 in\"]", "\"1 (mm\", 0, 0] #!"},
    {"unit_power", "joint.offset_a[1] = \"1 mm^99\": has the unit 'mm^99', which has a power",
     "\"12 mm\", 0, \"0.1 in\"]", "\"1 mm^99\", 0, 0] #!"},
    {"unit_twice",
     "joint.offset_b.values[2] = \"2 mm\": has a unit beside that of all values; allowed: plain numbers",
     "[1, 2, 3], unit = \"mm\" }", "[1, \"2 mm\", 3], unit = \"mm\" } #!"},
    {"unit_not_said", "joint.offset_b.unit = nothing: is missing; allowed: the unit of all values",
     "[1, 2, 3], unit = \"mm\" }", "[1, 2, 3] } #!"},
    {"unit_no_text", "joint.offset_b.unit = 3: is a number; allowed: the unit of all values",
     "unit = \"mm\" }", "unit = 3 } #!"},
    {"unit_of_all", "joint.offset_b.values[1] = 1: is in N (N in SI) where m is needed", "unit = \"mm\" }",
     "unit = \"N\" } #!"},
    {"unit_key",
     "joint.offset_b.units = \"mm\": is not a known key (did you mean 'unit'?); allowed: values, unit",
     "unit = \"mm\" }", "units = \"mm\" } #!"},
    {"load_unit",
     "load[1].value[3] = \"1 lbf\": is in lbf (N in SI) where N m is needed; allowed: a number, N m",
     "\"1 lbf in\"]", "\"1 lbf\"] #!"},
    {"cubic_unit",
     "joint.law.axis[3].k3 = \"1 N m/deg\": is in N m/deg (N m/rad in SI) where N m/rad^3 is needed",
     "\"1 N m/deg^3\"", "\"1 N m/deg\" #!"},
    {"factor_unit", "path.factor_end = \"1 mm\": is a text; allowed: a finite number", "factor_end = 1",
     "factor_end = \"1 mm\" #!"},
};

constexpr Broken kBrokenMatrix[] = {
    {"not_symmetric",
     "joint.law.K = [[10, 100, 0, 0, 0, \"1 N/deg\"], [0.2, 10, 0, 0, 0, 0], [0, 0...: is not symmetric: (1, "
     "2) is 100 and (2, 1) is 0.2, 0.033 of its largest entry; allowed: a symmetric matrix, to 0.02",
     "K = [[10, 0.1, 0, 0, 0, \"1 N/deg\"],", "K = [[10, 100, 0, 0, 0, \"1 N/deg\"], #!"},
    {"tolerance_too_large", "joint.law.tolerance = 0.5: is out of range; allowed: a number from 1e-12 to 0.1",
     "tolerance = 0.02", "tolerance = 0.5 #!"},
    {"matrix_tolerance_zero", "joint.law.tolerance = 0: is out of range; allowed: a number from 1e-12",
     "tolerance = 0.02", "tolerance = 0 #!"},
    {"axes_twice",
     "joint.law.axes_rotation = [1, 0, 0, 0]: stands beside axes; allowed: axes, or axes_translation and "
     "axes_rotation",
     "axes = [0.8, 0.6, 0, 0]", "axes = [0.8, 0.6, 0, 0]\naxes_rotation = [1, 0, 0, 0] #!"},
    {"axes_no_rotation", "joint.law.axes = [0.8, 0.8, 0, 0]: has length 1.13", "axes = [0.8, 0.6, 0, 0]",
     "axes = [0.8, 0.8, 0, 0] #!"},
    {"coupling_unit",
     "joint.law.K[1][6] = \"1 N/mm\": is in N/mm (N/m in SI) where N/rad is needed; allowed: a number, N/rad",
     "K = [[10, 0.1, 0, 0, 0, \"1 N/deg\"],", "K = [[10, 0.1, 0, 0, 0, \"1 N/mm\"], #!"},
    {"stiffness_without_rad",
     "joint.law.K[6][6] = \"90 N m\": is in N m (N m in SI) where N m/rad is needed; allowed: a number, N "
     "m/rad, or a text of a "
     "number and a unit: N m/rad, N m/deg",
     "\"90 N m/deg\"]]", "\"90 N m\"]] #!"},
    {"one_unit_for_a_matrix", "joint.law.K.values[1][4] = 0: is in N/mm (N/m in SI) where N/rad is needed",
     "K = [[10, 0.1, 0, 0, 0, \"1 N/deg\"],\n     [0.2, 10, 0, 0, 0, 0],\n     [0, 0, \"3 kN/m\", 0, 0, "
     "0],\n     [0, 0, 0, 2, 0, 0],\n     [0, 0, 0, 0, 2, 0],\n     "
     "[\"1 N/deg\", 0, 0, 0, 0, \"90 N m/deg\"]]",
     "K = { values = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, "
     "0, 0, 1, 0], [0, 0, 0, 0, 0, 1]], unit = \"N/mm\" } #!"},
    {"point_unit", "load[1].point[1] = \"1 lbf ft\": is in lbf ft (N m in SI) where m is needed",
     "point = [\"1 ft\", 0, 0]", "point = [\"1 lbf ft\", 0, 0] #!"},
    {"negative_within_tolerance",
     "joint.law.K = [[0.0001, 0.1, 0, 0, 0, \"1 N/deg\"], [0.2, 10, 0, 0, 0, 0], [...: is indefinite: "
     "smallest eigenvalue -0.000213",
     "K = [[10, 0.1, 0, 0, 0, \"1 N/deg\"],", "K = [[0.0001, 0.1, 0, 0, 0, \"1 N/deg\"], #!"},
};

void add(Checks& checks, const char* good, const Broken& b) {
  checks.push_back({fmt::format("laws/refuses/{}", b.what), "cases",
                    [good, &b] { return std::vector{broken_refused(good, b)}; }});
}

}  // namespace

void law_errors(Checks& checks) {
  checks.push_back({"laws/accepts", "cases", [] {
                      return std::vector{accepted("law_curves", kCurves), accepted("law_matrix", kMatrix)};
                    }});
  for (const Broken& b : kBrokenCurves) add(checks, kCurves, b);
  for (const Broken& b : kBrokenMatrix) add(checks, kMatrix, b);
}

}  // namespace halfway::verify
