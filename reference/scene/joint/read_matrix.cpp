#include "reference/scene/joint/read_matrix.hpp"

#include "reference/numbers/linear_algebra.hpp"
#include "reference/scene/joint/read_joint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

namespace halfway::reference {
namespace {

// A stiffness comes out of products of rotations and compliances, or of an inverse: some tens of
// roundings of 1e-16.
constexpr double kRounding = 1e-12;

/// Of a measured matrix that is called symmetric; beyond, a row or a sign is wrong.
constexpr double kMostUnsymmetric = 0.1;

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

/// @param tolerance  largest difference of two entries, over the largest entry, in units of its own
Eigen::MatrixXd symmetric_part(const Field& field, const Eigen::MatrixXd& m, double tolerance) {
  const Eigen::MatrixXd S = in_own_units(m);
  Eigen::Index i = 0, j = 0;
  const double off = (S - S.transpose()).cwiseAbs().maxCoeff(&i, &j) / S.cwiseAbs().maxCoeff();
  if (!(off > 0)) return m;
  if (i > j) std::swap(i, j);
  const int first = field.dialect().first_index;
  if (off > tolerance) {
    field.refuse(
        fmt::format("is not symmetric: ({0}, {1}) is {2} and ({1}, {0}) is {3}, {4:.2g} of its largest entry",
                    i + first, j + first, m(i, j), m(j, i), off),
        fmt::format("a symmetric matrix, to {:g} of its largest entry; `tolerance` beside it says how "
                    "unsymmetric a measured one may be, up to {:g}",
                    tolerance, kMostUnsymmetric),
        "not_symmetric");
  }
  field.note(
      fmt::format("is symmetric to {:.1g} only; its symmetric part is used: ({}, {}) changes by {:.2g}", off,
                  i + first, j + first, std::abs(m(i, j) - m(j, i)) / 2));
  return (m + m.transpose()) / 2;
}

/// A direction without stiffness is a hinge or a slide: allowed.
void check_semidefinite(const Field& field, const Eigen::MatrixXd& m, const char* what) {
  const std::string allowed =
      fmt::format("a positive semidefinite matrix: zero {} is allowed, negative is not", what);
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

double read_tolerance(const Field& law, const Field& matrix) {
  const auto field = law.find("tolerance");
  if (!field) return kRounding;
  if (!matrix.holds_arrays())
    field->refuse("stands beside a diagonal", "tolerance beside the rows of a matrix");
  const double tolerance = field->number();
  if (!(tolerance >= kRounding && tolerance <= kMostUnsymmetric))
    field->refuse("is out of range", fmt::format("a number from {:g} to {:g}", kRounding, kMostUnsymmetric));
  return tolerance;
}

/// The axes of the law's translations and rotations, as they are given: columns, in the joint's.
struct Axes {
  std::optional<Mat3<double>> translation, rotation;
};

Axes read_axes(const Field& law, Kind kind) {
  const auto both = law.find("axes");
  const auto one = [&](const char* key, bool has_it) -> std::optional<Mat3<double>> {
    const auto field = law.find(key);
    if (field && both)
      field->refuse("stands beside axes", "axes, or axes_translation and axes_rotation", "named_twice");
    if (field && !has_it)
      field->refuse("is of strains that this kind of joint does not have", "axes, which turns those it has");
    if (!has_it || (!field && !both)) return std::nullopt;
    return read_rotation(field ? *field : *both);
  };
  return {one("axes_translation", kind != Kind::angular), one("axes_rotation", kind != Kind::linear)};
}

/// From the law's axes to the joint's: D M D^T, D with the axes on its diagonal. Orthogonal, so that a
/// compliance turns like a stiffness.
void turn(Eigen::MatrixXd& m, const Axes& axes) {
  if (!axes.translation && !axes.rotation) return;
  Eigen::MatrixXd D = Eigen::MatrixXd::Identity(m.rows(), m.cols());
  if (axes.translation) D.topLeftCorner<3, 3>() = *axes.translation;
  if (axes.rotation) D.bottomRightCorner<3, 3>() = *axes.rotation;
  m = D * m * D.transpose();
  m = Eigen::MatrixXd((m + m.transpose()) / 2);
}

/// n numbers or n rows of n.
Eigen::MatrixXd read_entries(const Field& field, int n, const MatrixDimensions& entries, double tolerance) {
  const std::string allowed =
      fmt::format("{0} numbers (a diagonal) or {0} rows of {0}, translation first", n);
  if (field.holds_arrays()) return symmetric_part(field, field.square_matrix(n, allowed, entries), tolerance);
  return field.vector(n, allowed, diagonal(entries)).asDiagonal();
}

}  // namespace

LinearSpec read_linear(const Field& law, Kind kind) {
  const int n = strain_count(kind);
  const Field field = matrix_field(law);
  LinearSpec spec;
  spec.is_compliance = law.find("compliance").has_value();
  const Dimensions strain = strain_dimensions(kind), stress = stress_dimensions(kind);
  const MatrixDimensions entries = spec.is_compliance ? ratio(strain, stress) : ratio(stress, strain);
  const double tolerance = read_tolerance(law, field);
  spec.matrix = read_entries(field, n, entries, tolerance);
  spec.is_compliance ? check_definite(field, spec.matrix)
                     : check_semidefinite(field, spec.matrix, "stiffness");
  turn(spec.matrix, read_axes(law, kind));
  return spec;
}

Eigen::MatrixXd read_damping(const Field& field, Kind kind) {
  const MatrixDimensions entries =
      times(ratio(stress_dimensions(kind), strain_dimensions(kind)), dimension::time);
  Eigen::MatrixXd out = read_entries(field, strain_count(kind), entries, kRounding);
  check_semidefinite(field, out, "damping");
  return out;
}

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

}  // namespace halfway::reference
