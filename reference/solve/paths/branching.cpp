#include "reference/solve/paths/branching.hpp"

#include "reference/numbers/linear_algebra.hpp"

#include <cmath>

namespace halfway::reference {
namespace {

using Square = SmallMatrix<Real50>;
using Column = SmallVector<Real50>;

/// The equations next to a point that is nearly a branching: F + beta psi0 = 0, g = 0.
class Equations {
 public:
  Equations(const ContinuationStep<Real50>& step, const ArcState<Real50>& near) : step_(step) {
    const Eigen::MatrixXd A = step.equilibrium_rows(near).cast<double>();
    const SingularValues right = singular_values(A), left = singular_values(A * A.transpose());
    n_ = A.rows();
    psi0_ = left.v.col(n_ - 1).cast<Real50>();
    plane_ = right.v.rightCols(2).cast<Real50>();
  }

  /// psi and g with psi^T A + g^T plane^T = 0 and psi^T psi0 = 1: at g = 0 psi is a left null vector of A.
  struct Null {
    Column psi;
    Eigen::Matrix<Real50, 2, 1> g;
  };
  Null null_at(const ArcState<Real50>& at) const {
    Square M = Square::Zero(n_ + 2, n_ + 2);
    M.topLeftCorner(n_, n_ + 1) = step_.equilibrium_rows(at);
    M.topRightCorner(n_, 1) = psi0_;
    M.bottomLeftCorner(2, n_ + 1) = plane_.transpose();
    const Column z = lu_solve<Real50>(M.transpose(), Column(Column::Unit(n_ + 2, n_ + 1)));
    return {z.head(n_), z.tail<2>()};
  }

  /// dg/dy, 2 rows. Second derivatives are differences of tangents: at 50 digits a step of 1e-20 leaves 20
  /// digits of them, so that Newton still squares its error.
  Square slopes(const ArcState<Real50>& at) const {
    const Real50 h(1e-20);
    const auto here = null_at(at).g;
    Square out(2, n_ + 1);
    for (Eigen::Index j = 0; j <= n_; ++j) {
      const ArcVector<Real50> aside = h * ArcVector<Real50>::Unit(n_ + 1, j);
      out.col(j) = (null_at(step_.moved(at, aside)).g - here) / h;
    }
    return out;
  }

  /// Of (y, beta).
  Column correction(const ArcState<Real50>& at, const Real50& beta) const {
    Square J = Square::Zero(n_ + 2, n_ + 2);
    J.topLeftCorner(n_, n_ + 1) = step_.equilibrium_rows(at);
    J.topRightCorner(n_, 1) = psi0_;
    J.bottomLeftCorner(2, n_ + 1) = slopes(at);
    Column r(n_ + 2);
    r << step_.imbalance(at) - beta * psi0_, -null_at(at).g;
    return lu_solve(J, r);
  }

  /// psi^T F_yy on the null plane of A, whose basis is `plane`, up to its sign.
  Eigen::Matrix2d curvature(const ArcState<Real50>& at, const Eigen::MatrixXd& plane) const {
    const Eigen::MatrixXd by_plane = slopes(at).cast<double>() * plane;
    return plane.transpose() * plane_.cast<double>() * by_plane;
  }

 private:
  const ContinuationStep<Real50>& step_;
  Eigen::Index n_ = 0;
  Column psi0_;
  Eigen::Matrix<Real50, Eigen::Dynamic, 2, 0, 7, 2> plane_;
};

/// Frames, loads and stiffness are given in double, each to some eps of itself. A frame that is eps off
/// strains the joint by eps rad, which its largest stiffness answers (1 in the path's scales); a load that is
/// eps off leaves that of itself. Over the load that bends the softest way this is eps times the condition.
/// Some hundred of them, because no path in double turns off at a smaller defect either: it keeps d =
/// defect^(1/3) away from the branching, where noise of eps in the loads moves it by eps / d^2, which must
/// stay far below d.
double rounding_of(const ContinuationStep<Real50>& step, const ArcState<Real50>& at) {
  constexpr double kSome = 256;
  const ArcMatrix<Real50> A = step.equilibrium_rows(at);
  const Real50 load = A.col(A.cols() - 1).norm() * abs(at.factor) / Real50(step.scales().factor);
  return kSome * Eigen::NumTraits<double>::epsilon() * (1 + double(load));
}

/// The directions in which a quadratic form vanishes: two, or none where it is definite (a point by itself).
std::optional<std::array<Eigen::Vector2d, 2>> null_directions(const Eigen::Matrix2d& B) {
  const double a = B(0, 0), b = (B(0, 1) + B(1, 0)) / 2, c = B(1, 1), root = std::sqrt(b * b - a * c);
  if (!(root > 0)) return std::nullopt;
  const double q = -(b + std::copysign(root, b));  // a x^2 + 2 b x y + c y^2 = 0 without cancellation
  return std::array{Eigen::Vector2d(q, a), Eigen::Vector2d(c, q)};
}

/// What is told of the root.
std::optional<DefinedBranching> completed(const ContinuationStep<Real50>& step, const Equations& equations,
                                          const Real50& beta, DefinedBranching out) {
  const ArcMatrix<double> A = step.equilibrium_rows(out.state).cast<double>();
  const Eigen::MatrixXd plane = singular_values(A).v.rightCols(2);
  const auto directions = null_directions(equations.curvature(out.state, plane));
  if (!directions) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) out.tangents[i] = (plane * (*directions)[i]).normalized();
  out.defect = double(abs(beta) / equations.null_at(out.state).psi.norm());
  out.rounding = rounding_of(step, out.state);
  return out;
}

}  // namespace

std::optional<DefinedBranching> defined_branching(const ContinuationStep<Real50>& step,
                                                  const ArcState<Real50>& start) {
  constexpr int kIterations = 12;
  constexpr double kSettled = 1e-18;  // the next correction is the square of it
  const Equations equations(step, start);
  DefinedBranching out{start};
  Real50 beta(0);
  for (int i = 0; i < kIterations; ++i) {
    const Column c = equations.correction(out.state, beta);
    const Eigen::Index n = c.size() - 2;
    out.change = double(c.head(n + 1).norm());
    if (!std::isfinite(out.change)) return std::nullopt;
    out.state = step.moved(out.state, c.head(n + 1));
    beta += c[n + 1];
    if (out.change <= kSettled) return completed(step, equations, beta, out);
  }
  return std::nullopt;
}

}  // namespace halfway::reference
