#include "reference/identify/linear_start.hpp"

#include "reference/truth/decoupling.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference::identify {
namespace {

constexpr double kRidge = 1e-7;     // of the equations' own weight: only what they leave open
constexpr double kFlattest = 1e-6;  // of the largest eigenvalue

/// One equation left . F . right = value for the symmetric F in scaled components.
struct Equations {
  int n;
  Eigen::MatrixXd normal;
  Eigen::VectorXd right;

  explicit Equations(int n_)
      : n(n_),
        normal(Eigen::MatrixXd::Zero(n * (n + 1) / 2, n * (n + 1) / 2)),
        right(Eigen::VectorXd::Zero(normal.rows())) {}
  int place(int i, int j) const { return i > j ? place(j, i) : i * n - i * (i - 1) / 2 + j - i; }
  /// value = sum_j X_ij by_j
  void add(int i, const Eigen::VectorXd& by, double value) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(right.size());
    for (int j = 0; j < n; ++j) row[place(i, j)] += by[j];
    normal += row * row.transpose();
    right += value * row;
  }
  Eigen::MatrixXd solved(double diagonal) const {
    const double weight = kRidge * (normal.trace() / double(normal.rows()) + 1e-300);
    Eigen::MatrixXd A = normal;
    Eigen::VectorXd b = right;
    A.diagonal().array() += weight;
    for (int i = 0; i < n; ++i) b[place(i, i)] += weight * diagonal;
    const Eigen::VectorXd x = A.ldlt().solve(b);
    Eigen::MatrixXd X(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) X(i, j) = x[place(i, j)];
    }
    return X;
  }
};

/// Positive definite, by its eigenvalues.
Eigen::MatrixXd positive(const Eigen::MatrixXd& X) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(X);
  const Eigen::VectorXd values = eigen.eigenvalues();
  const double largest = values.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return Eigen::MatrixXd::Identity(X.rows(), X.cols());
  const Eigen::VectorXd clamped = values.cwiseMax(kFlattest * largest);
  return eigen.eigenvectors() * clamped.asDiagonal() * eigen.eigenvectors().transpose();
}

bool knows_loads(const LoadCase& one, int first, int end) {
  for (int i = first; i < end; ++i) {
    if (one.held[std::size_t(i)] && !one.has_load[std::size_t(i)]) return false;
  }
  return true;
}

bool knows_motions(const LoadCase& one, int first, int end) {
  for (int i = first; i < end; ++i) {
    if (!one.held[std::size_t(i)] && !one.has_motion[std::size_t(i)]) return false;
  }
  return true;
}

/// The compliance in components over `scale` (motion) and by `scale` of the loads; of the rows alone that say
/// all loads or all motions. By the diagonal of the rest.
Eigen::MatrixXd scaled_compliance(const Data& data, const Eigen::VectorXd& motion,
                                  const Eigen::VectorXd& load) {
  const int first = first_component(data.kind), end = end_component(data.kind), n = end - first;
  Equations F(n), K(n);
  int of_F = 0, of_K = 0;
  for (const LoadCase& one : data.cases) {
    const bool by_loads = knows_loads(one, first, end), by_motions = knows_motions(one, first, end);
    for (std::size_t row = 0; row < one.loads.size(); ++row) {
      const Eigen::VectorXd l = one.loads[row].segment(first, n).cwiseQuotient(load);
      const Eigen::VectorXd z = one.motions[row].segment(first, n).cwiseQuotient(motion);
      for (int i = 0; i < n; ++i) {
        const bool has_motion = one.held[std::size_t(first + i)] || one.has_motion[std::size_t(first + i)];
        const bool has_load = !one.held[std::size_t(first + i)] || one.has_load[std::size_t(first + i)];
        if (by_loads && has_motion)
          F.add(i, l, z[i]), ++of_F;
        else if (by_motions && has_load)
          K.add(i, z, l[i]), ++of_K;
      }
    }
  }
  return of_F >= of_K ? positive(F.solved(1)) : Eigen::MatrixXd(positive(K.solved(1)).inverse());
}

/// Sizes of the motion's components: one for translations, one for rotations.
Eigen::VectorXd motion_scale(const Data& data) {
  const int first = first_component(data.kind), end = end_component(data.kind);
  const auto size = sizes(data);
  Eigen::VectorXd out(end - first);
  for (int i = first; i < end; ++i) {
    const double own = size[i < 3 ? 0 : 1], other = size[i < 3 ? 1 : 0];
    out[i - first] = own > 0 ? own : other > 0 ? other : 1;
  }
  return out;
}

/// Such that motion times load is one energy in all components: then the scaled compliance is as symmetric as
/// the compliance itself.
Eigen::VectorXd load_scale(const Data& data, const Eigen::VectorXd& motion) {
  const auto size = sizes(data);
  double sum = 0, count = 0;
  for (std::size_t half : {0u, 1u}) {
    if (size[half] > 0 && size[2 + half] > 0) sum += std::log(size[half] * size[2 + half]), count += 1;
  }
  return (count > 0 ? std::exp(sum / count) : 1) * motion.cwiseInverse();
}

LinearStart of_compliance(const Mat6& F) {
  const Decoupling<double> parts = decouple<double>(F);
  LinearStart out;
  const PrincipalAxes rotations = principal_axes((parts.F_psi + parts.F_psi.transpose()) / 2);
  out.frame.H = rotations.axes;
  out.frame.angular = rotations.values.cwiseInverse();
  const Mat3<double> F_u =
      rotations.axes.transpose() * (parts.F_u + parts.F_u.transpose()) / 2 * rotations.axes;
  const PrincipalAxes translations = principal_axes(F_u);
  out.frame.E = translations.axes;
  out.frame.linear = translations.values.cwiseInverse();
  out.frame.length = std::sqrt(translations.values.mean() / rotations.values.mean());
  const Mat3<double> S = rotations.axes.transpose() * (parts.remainder + parts.remainder.transpose()) / 2 *
                         rotations.axes / out.frame.length;
  out.unknowns = no_unknowns();
  out.unknowns.segment<6>(kCoupling) << S(0, 0), S(1, 1), S(2, 2), S(1, 2), S(0, 2), S(0, 1);
  out.unknowns.segment<3>(kJointPoint) = parts.x / out.frame.length;
  return out;
}

/// The compliance in SI, of the components of the kind.
Eigen::MatrixXd linear_compliance(const Data& data) {
  const Eigen::VectorXd motion = motion_scale(data), load = load_scale(data, motion);
  return motion.asDiagonal() * scaled_compliance(data, motion, load) * load.cwiseInverse().asDiagonal();
}

LinearStart start_of(Kind kind, const Eigen::MatrixXd& F) {
  LinearStart out;
  if (kind == Kind::linear_angular) {
    out = of_compliance(Mat6(F));
  } else {
    const PrincipalAxes axes = principal_axes(Mat3<double>(F));
    (kind == Kind::angular ? out.frame.H : out.frame.E) = axes.axes;
    (kind == Kind::angular ? out.frame.angular : out.frame.linear) = axes.values.cwiseInverse();
    out.unknowns = no_unknowns();
  }
  out.frame.kind = kind;
  return out;
}

}  // namespace

PrincipalAxes principal_axes(const Mat3<double>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> eigen(symmetric);
  const Mat3<double> V = eigen.eigenvectors();
  std::array<int, 3> order{0, 1, 2}, best = order;
  double largest = -1;
  do {
    const double sum = std::abs(V(0, order[0])) + std::abs(V(1, order[1])) + std::abs(V(2, order[2]));
    if (sum > largest + 1e-12) largest = sum, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  PrincipalAxes out;
  for (int i = 0; i < 3; ++i) {
    const int from = best[std::size_t(i)];
    out.values[i] = eigen.eigenvalues()[from];
    out.axes.col(i) = V(i, from) < 0 ? Vec3<double>(-V.col(from)) : Vec3<double>(V.col(from));
  }
  if (out.axes.determinant() < 0) {  // turn round the one that is least along its own axis
    int worst = 0;
    for (int i = 1; i < 3; ++i) worst = out.axes(i, i) < out.axes(worst, worst) ? i : worst;
    out.axes.col(worst) *= -1;
  }
  return out;
}

LinearStart linear_start(const Data& data) { return start_of(data.kind, linear_compliance(data)); }

LinearStart linear_start_along_axes(const Data& data) {
  const Eigen::VectorXd diagonal = linear_compliance(data).diagonal();
  return start_of(data.kind, diagonal.asDiagonal());
}

}  // namespace halfway::reference::identify
