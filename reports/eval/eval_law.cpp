#include "reports/eval/eval_law.hpp"

#include "reference/solve/spectrum.hpp"
#include "reports/eval/suggest.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reports {
namespace {

// A stiffness comes out of products of rotations and compliances: some tens of roundings of 1e-16.
constexpr double kRounding = 1e-12;

/// K in units of its own: force rows and moment rows divided so that the largest diagonal entry of
/// each block is 1. Symmetry and sign can then be judged without comparing N/m with N m.
Eigen::MatrixXd scaled(const Eigen::MatrixXd& K) {
  Eigen::VectorXd scale(K.rows());
  for (Eigen::Index start = 0; start < K.rows(); start += 3) {
    const double largest = K.diagonal().segment<3>(start).cwiseAbs().maxCoeff();
    scale.segment<3>(start).setConstant(largest > 0 ? 1 / std::sqrt(largest) : 1);
  }
  return scale.asDiagonal() * K * scale.asDiagonal();
}

void check_stiffness(const Eigen::MatrixXd& K, const Field& field) {
  const Eigen::MatrixXd S = scaled(K);
  Eigen::Index i = 0, j = 0;
  const double asymmetry = (S - S.transpose()).cwiseAbs().maxCoeff(&i, &j);
  if (!(asymmetry <= kRounding * S.cwiseAbs().maxCoeff())) {
    throw EvalError("not_symmetric",
                    fmt::format("K[{0}][{1}] = {2:.17g} but K[{1}][{0}] = {3:.17g}; K must be symmetric to "
                                "{4:g} relative",
                                i, j, K(i, j), K(j, i), kRounding),
                    field.path);
  }
  const auto [smallest, largest] = reference::spectrum(S);
  if (!(smallest >= -kRounding * largest)) {
    throw EvalError(
        "indefinite_stiffness",
        fmt::format("K is indefinite: smallest eigenvalue {:.6g} of K scaled to a largest diagonal "
                    "entry of 1 per block; positive semidefinite is allowed, zero eigenvalues included",
                    smallest),
        field.path);
  }
}

reference::LawSpec read_linear(const Field& law, int count, const reference::Entry& entry) {
  require_object(law, {"type", "K"});
  const Field field = required(law, "K");
  const Eigen::MatrixXd K = square_matrix(field, count);
  check_stiffness(K, field);
  if (entry.block_diagonal_law_only && count == 6 && !K.topRightCorner<3, 3>().isZero(0)) {
    throw EvalError("block_diagonal_law_only",
                    fmt::format("{} takes no coupling between translation and rotation; the off-diagonal 3x3 "
                                "blocks of K must be zero",
                                entry.name),
                    field.path);
  }
  return reference::LinearSpec{K, false};
}

reference::LawSpec read_polynomial(const Field& law, int count) {
  require_object(law, {"type", "k1", "k3", "k5"});
  const auto coefficients = [&](std::string_view key) -> Eigen::VectorXd {
    const auto field = member(law, key);
    return field ? numbers(*field, count) : Eigen::VectorXd::Zero(count);
  };
  const Field field = required(law, "k1");
  reference::PolynomialSpec spec{numbers(field, count), coefficients("k3"), coefficients("k5")};
  if (spec.k1.minCoeff() < 0) {
    throw EvalError("indefinite_stiffness",
                    fmt::format("k1 is the stiffness at rest and must not be negative, found {:.17g}",
                                spec.k1.minCoeff()),
                    field.path);
  }
  return spec;
}

}  // namespace

reference::LawSpec read_law(const Field& law, Kind kind, const reference::Entry& entry) {
  if (!law.value.is_object()) require_object(law, {});
  const Field type = required(law, "type");
  const std::string& name = text(type);
  if (name == "linear") return read_linear(law, strain_count(kind), entry);
  if (name == "polynomial") return read_polynomial(law, strain_count(kind));
  throw EvalError("unknown_law", unknown_name("law", name, {"linear", "polynomial"}), type.path);
}

}  // namespace halfway::reports
