#include "verify/oracle/saboteurs/sort.hpp"

#include "reference/programs/joints.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::verify {
namespace {

/// The half-way form, a conservative one, one with a free xi and another program's.
constexpr std::string_view kRepresentatives[] = {"invariant", "conformal", "intrinsic", "drake_rpy"};

/// What else varies, the cheapest first: functions of rotations; bodies, elements and laws of solids; scenes
/// of angular joints.
constexpr std::string_view kOthers[] = {"exp",
                                        "log",
                                        "log_matrix",
                                        "log_quaternion",
                                        "gamma",
                                        "gamma_inverse",
                                        "half",
                                        "half_matrix",
                                        "half_quaternion",
                                        "matrix",
                                        "cayley_inverse",
                                        "block",
                                        "frustum_top",
                                        "frustum_base",
                                        "frustum",
                                        "frustum_off_centre",
                                        "bearing_plane_cone",
                                        "hex20",
                                        "hex20_full",
                                        "hex27",
                                        "st_venant",
                                        "neo_hooke",
                                        "hencky",
                                        "cauchy_log",
                                        "c1_skewed_torque",
                                        "c2_parallelepiped_small",
                                        "c3_buckling",
                                        "c4_frustum"};

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> out;
  for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
    end = name.find('/', at);
    out.push_back(name.substr(at, end - at));
  }
  return out;
}

/// Of the catalog, or a program's joint.
bool is_formulation(const std::string& part) {
  const std::string name = part.substr(0, part.find("_xi_"));
  return reference::find_program_joint(name) != nullptr ||
         std::ranges::any_of(reference::catalogued(), [&](const auto& entry) { return entry.name == name; });
}

bool is_number(const std::string& part) {
  return !part.empty() && part.find_first_not_of("0123456789.e+-") == std::string::npos;
}

bool varies(const std::string& part) {
  return is_formulation(part) || is_number(part) || std::ranges::find(kOthers, part) != std::end(kOthers);
}

/// The smaller, the better the check speaks for its sort.
std::ptrdiff_t rank(const std::string& check) {
  std::ptrdiff_t out = 0;
  for (const std::string& part : parts_of(check)) {
    if (is_formulation(part)) out += 100 * (std::ranges::find(kRepresentatives, part) - kRepresentatives);
    const auto* const other = std::ranges::find(kOthers, part);
    if (other != std::end(kOthers)) out += other - kOthers;
  }
  return out;
}

}  // namespace

std::string sort_of(const std::string& check) {
  std::string out;
  for (const std::string& part : parts_of(check))
    out += (out.empty() ? "" : "/") + (varies(part) ? "*" : part);
  return out;
}

std::vector<Siblings> sorted(const Checks& checks) {
  std::vector<Siblings> out;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const std::string sort = sort_of(checks[i].name);
    auto it = std::ranges::find(out, sort, &Siblings::sort);
    if (it == out.end()) it = out.insert(it, {sort, {}});
    it->members.push_back(i);
  }
  for (Siblings& siblings : out)
    std::ranges::stable_sort(siblings.members, {}, [&](std::size_t i) { return rank(checks[i].name); });
  return out;
}

}  // namespace halfway::verify
