#include "reference/scene/read_law.hpp"

#include "reference/numbers/linear_algebra.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reference {
namespace {

// A stiffness comes out of products of rotations and compliances, or of an inverse: some tens of
// roundings of 1e-16.
constexpr double kRounding = 1e-12;

/// Smallest eigenvalue of a compliance scaled to a unit diagonal; below, its inverse has no digit left.
constexpr double kSmallestEigenvalue = 1e-13;

/// The matrix in units of its own: force rows and moment rows divided so that the largest diagonal entry
/// of each block is 1. Symmetry and sign can then be judged without comparing N/m with N m.
Eigen::MatrixXd in_own_units(const Eigen::MatrixXd& m) {
  Eigen::VectorXd scale(m.rows());
  for (Eigen::Index start = 0; start < m.rows(); start += 3) {
    const double largest = m.diagonal().segment<3>(start).cwiseAbs().maxCoeff();
    scale.segment<3>(start).setConstant(largest > 0 ? 1 / std::sqrt(largest) : 1);
  }
  return scale.asDiagonal() * m * scale.asDiagonal();
}

Eigen::MatrixXd symmetric_part(const Field& field, const Eigen::MatrixXd& m) {
  const Eigen::MatrixXd S = in_own_units(m);
  Eigen::Index i = 0, j = 0;
  const double off = (S - S.transpose()).cwiseAbs().maxCoeff(&i, &j) / S.cwiseAbs().maxCoeff();
  if (off > kRounding) {
    const int first = field.dialect().first_index;
    field.refuse(fmt::format("is not symmetric: ({0}, {1}) is {2} and ({1}, {0}) is {3}", i + first,
                             j + first, m(i, j), m(j, i)),
                 "a symmetric matrix, to 1e-12 of its largest entry", "not_symmetric");
  }
  if (off > 0) field.note(fmt::format("is symmetric to {:.1g} only; its symmetric part is used", off));
  return off > 0 ? Eigen::MatrixXd((m + m.transpose()) / 2) : m;
}

/// A direction without stiffness is a hinge or a slide: allowed.
void check_semidefinite(const Field& field, const Eigen::MatrixXd& m) {
  const std::string allowed = "a positive semidefinite matrix: zero stiffness is allowed, negative is not";
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    // Alone in its row it is no rounding of larger entries.
    if (m(i, i) < 0 && m.row(i).cwiseAbs().sum() == -m(i, i))
      field.refuse(fmt::format("has {} on its diagonal", m(i, i)), allowed, "indefinite_stiffness");
  }
  const auto [smallest, largest] = spectrum(in_own_units(m));
  if (!(smallest >= -kRounding * largest)) {
    field.refuse(fmt::format("is indefinite: smallest eigenvalue {:.3g} where the largest diagonal entries "
                             "of forces and of moments are 1",
                             smallest),
                 allowed, "indefinite_stiffness");
  }
}

/// It is inverted.
void check_definite(const Field& field, const Eigen::MatrixXd& m) {
  const std::string allowed =
      "a positive definite compliance; a rigid direction has a large stiffness instead";
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    if (!(m(i, i) > 0))
      field.refuse(fmt::format("has {} on its diagonal", m(i, i)), allowed, "indefinite_stiffness");
  }
  const Eigen::VectorXd scale = m.diagonal().cwiseSqrt().cwiseInverse();
  const double smallest = spectrum(scale.asDiagonal() * m * scale.asDiagonal()).smallest;
  if (!(smallest > kSmallestEigenvalue)) {
    field.refuse(
        fmt::format("is singular or indefinite: smallest eigenvalue {:.3g} at unit diagonal", smallest),
        allowed, "indefinite_stiffness");
  }
}

LinearSpec read_linear(const Field& law, int n) {
  law.has_only({"type", "stiffness", "K", "compliance"});
  const Field field = matrix_field(law);
  const std::string allowed =
      fmt::format("{0} numbers (a diagonal) or {0} rows of {0}, translation first", n);
  LinearSpec spec;
  spec.is_compliance = law.find("compliance").has_value();
  spec.matrix = field.holds_arrays() ? symmetric_part(field, field.square_matrix(n, allowed))
                                     : Eigen::MatrixXd(field.vector(n, allowed).asDiagonal());
  spec.is_compliance ? check_definite(field, spec.matrix) : check_semidefinite(field, spec.matrix);
  return spec;
}

PolynomialSpec read_polynomial(const Field& law, int n) {
  law.has_only({"type", "k1", "k3", "k5"});
  const std::string allowed = fmt::format("{} numbers, one for each strain, translation first", n);
  const auto coefficients = [&](const char* key) -> Eigen::VectorXd {
    const auto field = law.find(key);
    return field ? field->vector(n, allowed) : Eigen::VectorXd::Zero(n);
  };
  const Field k1 = law.at("k1", allowed);
  PolynomialSpec spec{k1.vector(n, allowed), coefficients("k3"), coefficients("k5")};
  if (spec.k1.minCoeff() < 0) {
    k1.refuse(fmt::format("has {}, but is the stiffness at rest", spec.k1.minCoeff()), "numbers >= 0",
              "indefinite_stiffness");
  }
  return spec;
}

}  // namespace

Field matrix_field(const Field& law) {
  const std::string one_of_them = "exactly one of stiffness (or K), compliance";
  std::optional<Field> found;
  std::string name;
  for (const char* word : {"stiffness", "K", "compliance"}) {
    const auto field = law.find(word);
    if (field && found) field->refuse("stands beside " + name, one_of_them, "named_twice");
    if (field) found = field, name = word;
  }
  return found ? *found : law.at(law.dialect().stiffness, one_of_them);
}

LawSpec read_law(const Field& law, Kind kind) {
  const Field type = law.at("type", "linear, polynomial");
  if (type.one_of({"linear", "polynomial"}, "unknown_law") == "linear")
    return read_linear(law, strain_count(kind));
  return read_polynomial(law, strain_count(kind));
}

}  // namespace halfway::reference
