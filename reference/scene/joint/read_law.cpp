#include "reference/scene/joint/read_law.hpp"

#include "reference/scene/joint/free_strains.hpp"
#include "reference/scene/joint/read_curves.hpp"
#include "reference/scene/joint/read_matrix.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace halfway::reference {
namespace {

/// Axes are those of a linear law: strains of another one are no vectors that could be turned.
void refuse_axes(const Field& law) {
  for (const char* key : {"axes", "axes_translation", "axes_rotation"}) {
    if (const auto field = law.find(key))
      field->refuse("stands beside a law that is not linear, whose strains are along the joint's axes",
                    "axes of a linear law; turn frame_a and frame_b instead");
  }
}

PolynomialSpec read_polynomial(const Field& law, Kind kind) {
  const int n = strain_count(kind);
  const std::string allowed = fmt::format("{} numbers, one for each strain, translation first", n);
  const Dimensions strain = strain_dimensions(kind), stress = stress_dimensions(kind);
  const auto coefficients = [&](const char* key, int power) -> Eigen::VectorXd {
    const auto field = law.find(key);
    return field ? field->vector(n, allowed, over_power(stress, strain, power)) : Eigen::VectorXd::Zero(n);
  };
  const Field k1 = law.at("k1", allowed);
  PolynomialSpec spec{coefficients("k1", 1), coefficients("k3", 3), coefficients("k5", 5)};
  if (spec.k1.minCoeff() < 0) {
    k1.refuse(fmt::format("has {}, but is the stiffness at rest", spec.k1.minCoeff()), "numbers >= 0",
              "indefinite_stiffness");
  }
  return spec;
}

/// What other programs and people call a law, and what it is here.
constexpr std::pair<std::string_view, std::string_view> kOtherWords[] = {
    {"table", "per_axis"},    {"tables", "per_axis"},    {"tabular", "per_axis"}, {"curve", "per_axis"},
    {"curves", "per_axis"},   {"spline", "per_axis"},    {"akima", "per_axis"},   {"piecewise", "per_axis"},
    {"bilinear", "per_axis"}, {"nonlinear", "per_axis"}, {"cubic", "polynomial"}, {"stiffness", "linear"},
    {"compliance", "linear"}, {"matrix", "linear"},      {"constant", "linear"},  {"K", "linear"}};

std::string read_type(const Field& type) {
  for (const auto& [word, here] : kOtherWords) {
    if (type.says(word))
      type.refuse(fmt::format("is not a known name (did you mean '{}'?)", here),
                  "linear, polynomial, per_axis", "unknown_law");
  }
  return type.one_of({"linear", "polynomial", "per_axis"}, "unknown_law");
}

PlainLawSpec read_plain(const Field& law, Kind kind) {
  const std::string type = read_type(law.at("type", "linear, polynomial, per_axis"));
  if (type == "linear") {
    law.has_only(kLinearKeys);
    return read_linear(law, kind);
  }
  refuse_axes(law);
  if (type == "polynomial") {
    law.has_only({"type", "preload", "offset", "k1", "k3", "k5"});
    return read_polynomial(law, kind);
  }
  law.has_only({"type", "preload", "offset", "axis"});
  return read_curves(law, kind);
}

Eigen::VectorXd shift(const std::optional<Field>& field, Kind kind, const char* unit,
                      const Dimensions& dimensions) {
  const int n = strain_count(kind);
  if (!field) return Eigen::VectorXd::Zero(n);
  return field->vector(n, fmt::format("{} numbers, {}, translation first", n, unit), dimensions);
}

LawSpec as_law(PlainLawSpec&& plain) {
  return std::visit([](auto& spec) -> LawSpec { return std::move(spec); }, plain);
}

}  // namespace

LawSpec read_law(const Field& law, Kind kind) {
  PlainLawSpec plain = read_plain(law, kind);
  const auto offset = law.find("offset"), preload = law.find("preload");
  if (!offset && !preload) return as_law(std::move(plain));
  ShiftedSpec out{std::move(plain), shift(offset, kind, "m or rad", strain_dimensions(kind)),
                  shift(preload, kind, "N or N m", stress_dimensions(kind))};
  if (out.offset.isZero(0) && out.preload.isZero(0)) return as_law(std::move(out.law));
  return out;
}

void note_free_strains(const Field& law, const JointSpec& joint) {
  const Eigen::MatrixXd free = free_strains(rest_stiffness(joint.law, joint.kind));
  std::string names;
  for (const auto& strain : free.colwise()) {
    names += (names.empty() ? "" : ", ") + strain_name(strain, joint.kind);
    if (is_slack(joint.law, strain)) names += " at rest";
  }
  if (!names.empty()) law.note("leaves free: " + names);
}

}  // namespace halfway::reference
