#include "reference/scene/read_law.hpp"

#include "reference/scene/read_curves.hpp"
#include "reference/scene/read_matrix.hpp"

#include <fmt/format.h>

#include <optional>

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

void has_only(const Field& law, const Names& own) {
  Names keys = {"type", "preload", "offset"};
  keys.insert(keys.end(), own.begin(), own.end());
  law.has_only(keys);
}

PlainLawSpec read_plain(const Field& law, Kind kind) {
  const Names types = {"linear", "polynomial", "per_axis"};
  const std::string type = law.at("type", "linear, polynomial, per_axis").one_of(types, "unknown_law");
  if (type == "linear") {
    has_only(law, kLinearKeys);
    return read_linear(law, kind);
  }
  refuse_axes(law);
  if (type == "polynomial") {
    has_only(law, {"k1", "k3", "k5"});
    return read_polynomial(law, kind);
  }
  has_only(law, {"axis"});
  return read_curves(law, kind);
}

Eigen::VectorXd shift(const Field& law, const char* key, int n, const char* unit,
                      const Dimensions& dimensions) {
  const auto field = law.find(key);
  if (!field) return Eigen::VectorXd::Zero(n);
  return field->vector(n, fmt::format("{} numbers, {}, translation first", n, unit), dimensions);
}

}  // namespace

LawSpec read_law(const Field& law, Kind kind) {
  const int n = strain_count(kind);
  ShiftedSpec shifted{read_plain(law, kind), shift(law, "offset", n, "m or rad", strain_dimensions(kind)),
                      shift(law, "preload", n, "N or N m", stress_dimensions(kind))};
  if (!shifted.offset.isZero(0) || !shifted.preload.isZero(0)) return shifted;
  return std::visit([](auto& plain) -> LawSpec { return std::move(plain); }, shifted.law);
}

}  // namespace halfway::reference
