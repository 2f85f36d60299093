// Numbers with units: each the double next to the value that its definition gives.
#include "reference/scene/chain_scene.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/temporary_scene.hpp"
#include "verify/studies/laws/read_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace halfway::verify {
namespace {

using reference::Scene;

/// A number of a scene: the lines that it stands in, and where it is read.
struct Place {
  const char *name, *law, *joint;
  double (*read)(const Scene&);
};

double entry(const Scene& scene, int i, int j) {
  return std::get<reference::LinearSpec>(scene.joint.law).matrix(i, j);
}
const reference::ShiftedSpec& shifted(const Scene& scene) {
  return std::get<reference::ShiftedSpec>(scene.joint.law);
}
double coefficient(const Scene& scene, std::size_t axis, std::size_t power) {
  return (*std::get<reference::PerAxisSpec>(scene.joint.law).axes)[axis].pieces.front()[power];
}

constexpr const char* kOnes = "type = \"linear\"\nstiffness = [1, 1, 1, 1, 1, 1]\n";
constexpr const char* kCurve =
    "type = \"per_axis\"\naxis = [{{ k1 = 1, k3 = {0} }}, {{ k1 = 1 }}, {{ k1 = 1 }}, {{ k1 = 1 }}, {{ k1 = "
    "1 }}, {{ k1 = 1 }}]\n";

const Place kPlaces[] = {
    {"length", kOnes, "offset_a = [{0}, 0, 0]", [](const Scene& s) { return s.joint.a.o[0]; }},
    {"angle", "type = \"linear\"\nstiffness = [1, 1, 1, 1, 1, 1]\noffset = [0, 0, 0, 0, {0}, 0]\n", "",
     [](const Scene& s) { return shifted(s).offset[4]; }},
    {"force", "type = \"linear\"\nstiffness = [1, 1, 1, 1, 1, 1]\npreload = [0, 0, {0}, 0, 0, 0]\n", "",
     [](const Scene& s) { return shifted(s).preload[2]; }},
    {"moment", "type = \"linear\"\nstiffness = [1, 1, 1, 1, 1, 1]\npreload = [0, 0, 0, {0}, 0, 0]\n", "",
     [](const Scene& s) { return shifted(s).preload[3]; }},
    {"translational", "type = \"linear\"\nstiffness = [1, {0}, 1, 1, 1, 1]\n", "",
     [](const Scene& s) { return entry(s, 1, 1); }},
    {"rotational", "type = \"linear\"\nstiffness = [1, 1, 1, 1, 1, {0}]\n", "",
     [](const Scene& s) { return entry(s, 5, 5); }},
    {"coupling",
     "type = \"linear\"\nK = [[1e9, 0, 0, 0, 0, {0}], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, "
     "0, 0], "
     "[0, 0, 0, 0, 1, 0], [{0}, 0, 0, 0, 0, 1e9]]\n",
     "", [](const Scene& s) { return entry(s, 0, 5); }},
    {"flexible", "type = \"linear\"\ncompliance = [1, {0}, 1, 1, 1, 1]\n", "",
     [](const Scene& s) { return entry(s, 1, 1); }},
    {"flexible_rotation", "type = \"linear\"\ncompliance = [1, 1, 1, {0}, 1, 1]\n", "",
     [](const Scene& s) { return entry(s, 3, 3); }},
    {"cubic", kCurve, "", [](const Scene& s) { return coefficient(s, 0, 3); }},
    {"cubic_rotation", "type = \"polynomial\"\nk1 = [1, 1, 1, 1, 1, 1]\nk3 = [0, 0, 0, {0}, 0, 0]\n", "",
     [](const Scene& s) { return std::get<reference::PolynomialSpec>(s.joint.law).k3[3]; }},
    {"fifth", "type = \"polynomial\"\nk1 = [1, 1, 1, 1, 1, 1]\nk5 = [{0}, 0, 0, 0, 0, 0]\n", "",
     [](const Scene& s) { return std::get<reference::PolynomialSpec>(s.joint.law).k5[0]; }}};

struct Quantity {
  const char *place, *text, *value;
};

// By hand from 1 in = 25.4 mm, 1 ft = 12 in, 1 lbf = 0.45359237 x 9.80665 N, 1 deg = pi/180 rad, to 22
// digits.
constexpr Quantity kQuantities[] = {
    {"length", "12 mm", "0.012"},
    {"length", "0.1 in", "0.00254"},
    {"length", "-2.5e-1ft", "-0.0762"},
    {"length", "+7 cm", "0.07"},
    {"length", "3 um", "0.000003"},
    {"length", "0.002 km", "2"},
    {"length", "1 N/(N/mm)", "0.001"},
    {"angle", "-10 deg", "-0.1745329251994329576924"},
    {"angle", "1 deg", "0.01745329251994329576924"},
    {"angle", "30°", "0.5235987755982988730771"},
    {"angle", "0.25 rev", "1.570796326794896619231"},
    {"angle", "5 mrad", "0.005"},
    {"angle", "180 deg", "3.141592653589793238463"},
    {"force", "2 kN", "2000"},
    {"force", "1 lbf", "4.4482216152605"},
    {"force", "3 kip", "13344.6648457815"},
    {"force", "10 kgf", "98.0665"},
    {"force", "4 daN", "40"},
    {"force", "2 MPa*mm^2", "2"},
    {"force", "7 mN", "0.007"},
    {"moment", "5 kN m", "5000"},
    {"moment", "5 N mm", "0.005"},
    {"moment", "12 lbf in", "1.3558179483314004"},
    {"moment", "1 ft lbf", "1.3558179483314004"},
    {"moment", "3 Nm", "3"},
    {"moment", "1 kN·mm", "1"},
    {"translational", "3 kN/mm", "3e6"},
    {"translational", "175 lbf/in", "30647.19616813336614173"},
    {"translational", "9 N m^-1", "9"},
    {"rotational", "1.8 N m/deg", "103.1324031235481775782"},
    {"rotational", "2.60 N m/deg", "148.9690267340140342797"},
    {"rotational", "40 lbf in/deg", "258.9421540915851856507"},
    {"rotational", "4 kN mm/rad", "4"},
    {"rotational", "2 Nm/mrad", "2000"},
    {"coupling", "5 N/deg", "286.4788975654116043840"},
    {"coupling", "5 kN", "5000"},
    {"coupling", "5 N m/mm", "5000"},
    {"coupling", "5 N/rad", "5"},
    {"flexible", "2 mm/kN", "0.000002"},
    {"flexible_rotation", "3 deg/(N m)", "0.05235987755982988730771"},
    {"flexible_rotation", "3 mrad/kN/m", "0.000003"},
    {"cubic", "2 N/mm^3", "2e9"},
    {"cubic_rotation", "0.5 N m/deg^3", "94045.47440720971046177"},
    {"fifth", "1 kN/m^5", "1000"},
};

double read_at(const std::string& place, const std::string& text) {
  for (const Place& p : kPlaces) {
    if (place != p.name) continue;
    const auto with = [&](const char* lines) { return fmt::format(fmt::runtime(lines), text); };
    return p.read(scene_of_law(Kind::linear_angular, with(p.law), with(p.joint)));
  }
  return std::nan("");
}

std::vector<Finding> conversions() {
  Measurement worst;
  for (const Quantity& q : kQuantities) {
    const double found = tapped(read_at(q.place, fmt::format("\"{}\"", q.text)));
    worst.include(std::abs(found / std::strtod(q.value, nullptr) - 1), fmt::format("\"{}\"", q.text));
  }
  return {at_most("units/conversions", "units", worst, 0, "relative", Oracle::closed_form,
                  "the double next to the value by definition: no rounding on the way")};
}

/// Every double of three digits in millimetres is the double of the text with its point moved.
std::vector<Finding> decimals() {
  Measurement worst;
  for (int i = 1; i < 1000; i += 7) {
    const double found = tapped(read_at("length", fmt::format("\"{} mm\"", i)));
    worst.include(std::abs(found / std::strtod(fmt::format("{}e-3", i).c_str(), nullptr) - 1),
                  fmt::format("{} mm", i));
  }
  return {at_most("units/decimals", "units", worst, 0, "relative", Oracle::closed_form, "7 mm is 0.007")};
}

constexpr const char* kTexts = R"(title = "with units"
[chain]
links = 4
length = "700 mm"
GJ = "0.8 N m^2"
EI = { values = [1000, 4000], unit = "kPa m^4" }
EA = "10 kN"
GA = ["5 kN", 5e3]
curvature = [0, 0, "9 deg/m"]
root = { x = { values = [1, 2, 3], unit = "in" } }
[[load]]
type = "follower_force"
value = ["1 kgf", 0, 0]
)";
constexpr const char* kNumbers = R"(title = "without"
[chain]
links = 4
length = 0.7
GJ = 0.8
EI = [1e6, 4e6]
EA = 1e4
GA = 5e3
curvature = [0, 0, 0.157079632679489661923]
root = { x = [0.0254, 0.0508, 0.0762] }
[[load]]
type = "follower_force"
value = [9.80665, 0, 0]
)";

reference::ChainScene chain_of_text(const char* text) {
  const TemporaryScene file("units", text);
  return std::get<reference::ChainScene>(reference::read_any_scene(file.path()));
}

/// A chain's numbers take units as a joint's do.
std::vector<Finding> chains() {
  const auto given = chain_of_text(kTexts), plain = chain_of_text(kNumbers);
  Measurement worst;
  const auto same = [&](const char* what, double a, double b) {
    worst.include(std::abs(tapped(a) / b - 1), what);
  };
  const auto &s = given.chain.section, &t = plain.chain.section;
  same("length", given.chain.length, plain.chain.length);
  same("GJ", s.GJ, t.GJ);
  same("EI2", s.EI2, t.EI2);
  same("EI3", s.EI3, t.EI3);
  same("EA", s.EA, t.EA);
  same("GA2", s.GA2, t.GA2);
  same("GA3", s.GA3, t.GA3);
  same("curvature", given.chain.curvature[2], plain.chain.curvature[2]);
  for (int i = 0; i < 3; ++i) same("root", given.chain.root.x[i], plain.chain.root.x[i]);
  same("load", given.loads.follower_force[0], plain.loads.follower_force[0]);
  return {at_most("units/chain", "units", worst, 0, "relative", Oracle::closed_form, "the same chain in SI")};
}

/// One unit for all values, of a list and of a matrix.
std::vector<Finding> shared() {
  const Scene list = scene_of_law(
      Kind::angular, "type = \"linear\"\nstiffness = { values = [1, 2.5, 4], unit = \"N m/deg\" }\n");
  const Scene rows = scene_of_law(
      Kind::angular,
      "type = \"linear\"\nK = { values = [[1, 0, 0], [0, 2.5, 0], [0, 0, 4]], unit = \"N m/deg\" }\n");
  Measurement worst;
  for (int i = 0; i < 3; ++i) {
    const double expected = std::strtod(i == 0   ? "57.29577951308232087680"
                                        : i == 1 ? "143.2394487827058021920"
                                                 : "229.1831180523292835072",
                                        nullptr);
    worst.include(std::abs(tapped(entry(list, i, i)) / expected - 1), "a list");
    worst.include(std::abs(tapped(entry(rows, i, i)) / expected - 1), "a matrix");
  }
  return {at_most("units/shared", "units", worst, 0, "relative", Oracle::closed_form,
                  "180/pi times 1, 2.5 and 4")};
}

}  // namespace

void unit_texts(Checks& checks) {
  checks.push_back({"units/conversions", "units", conversions});
  checks.push_back({"units/decimals", "units", decimals});
  checks.push_back({"units/chain", "units", chains});
  checks.push_back({"units/shared", "units", shared});
}

}  // namespace halfway::verify
