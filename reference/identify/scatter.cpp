#include "reference/identify/scatter.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>

namespace halfway::reference::identify {
namespace {

using Matrix = Eigen::MatrixXd;
using Channels = Eigen::Matrix<double, kChannels, 1>;

constexpr double kNoSay = 0.5;  // degrees of freedom below which a channel tells nothing of its own scatter

/// (J^T J)^-1 by eigenvalues of the scaled matrix: directions without effect get a large but finite variance.
Matrix inverse_normal(const Matrix& J) {
  if (J.cols() == 0) return Matrix(0, 0);
  constexpr double kFloor = 1e-15;
  const Eigen::VectorXd size = (J.colwise().norm().transpose().array() + 1e-300).matrix();
  const Matrix scaled = J * size.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(scaled.transpose() * scaled);
  const Eigen::VectorXd inverse = eigen.eigenvalues().cwiseMax(kFloor).cwiseInverse();
  const Matrix V = size.cwiseInverse().asDiagonal() * eigen.eigenvectors();
  return V * inverse.asDiagonal() * V.transpose();
}

/// Of each channel its share of J^T J, and how many numbers it has.
struct Shares {
  std::array<Matrix, kChannels> normal;
  std::array<double, kChannels> count{};

  Shares(const Matrix& J, const std::vector<int>& channel) {
    normal.fill(Matrix::Zero(J.cols(), J.cols()));
    for (Eigen::Index row = 0; row < J.rows(); ++row) {
      const auto c = std::size_t(channel[std::size_t(row)]);
      normal[c].noalias() += J.row(row).transpose() * J.row(row);
      count[c] += 1;
    }
  }
};

/// Covariance of the variances found, each over itself: the inverse of their information, which is half the
/// squared norm of each block of what projects on the residuals. Zero of those that were not found.
Eigen::Matrix4d of_variances(const std::array<Matrix, kChannels>& hat, const Shares& shares,
                             const std::array<bool, kChannels>& takes_part) {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  for (int c = 0; c < kChannels; ++c) {
    for (int d = 0; d < kChannels; ++d) {
      const auto i = std::size_t(c), j = std::size_t(d);
      if (!takes_part[i] || !takes_part[j]) continue;
      information(c, d) = (hat[i].cwiseProduct(hat[j].transpose()).sum() +
                           (c == d ? shares.count[i] - 2 * hat[i].trace() : 0)) /
                          2;
    }
  }
  return information.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace

Scatter scatter_of(const Matrix& J, const std::vector<int>& channel,
                   const std::array<bool, kChannels>& found) {
  const Shares shares(J, channel);
  const Matrix C = inverse_normal(J);
  Scatter out{C, Eigen::VectorXd::Ones(C.cols()), Eigen::VectorXd(C.cols()), {}};
  std::array<Matrix, kChannels> hat, of_channel;  // N_c C, and C N_c C: what the channel's scatter brings
  std::array<bool, kChannels> takes_part{};
  double all = -double(C.cols());
  for (std::size_t c = 0; c < kChannels; ++c) {
    hat[c] = shares.normal[c] * C;
    of_channel[c] = C * hat[c];
    out.left[c] = shares.count[c] - hat[c].trace();
    takes_part[c] = found[c] && shares.count[c] > 0 && out.left[c] >= kNoSay;
    all += shares.count[c];
  }
  const Eigen::Matrix4d W = of_variances(hat, shares, takes_part);
  Matrix more = Matrix::Zero(C.rows(), C.cols());
  for (std::size_t c = 0; c < kChannels; ++c) {
    more += W(Eigen::Index(c), Eigen::Index(c)) * of_channel[c];
    for (std::size_t d = 0; d < kChannels; ++d)
      more -= W(Eigen::Index(c), Eigen::Index(d)) * of_channel[c] * hat[d];
  }
  for (Eigen::Index i = 0; i < C.cols(); ++i) {
    Channels share;
    for (int c = 0; c < kChannels; ++c) share[c] = of_channel[std::size_t(c)](i, i);
    const double scatter = share.dot(W * share), own = 2 * C(i, i) * C(i, i) / scatter;
    out.degrees[i] = std::max(1., scatter > 0 ? std::min(all, own) : all);
    out.inflation[i] += 2 * std::max(0., more(i, i)) / C(i, i);
  }
  return out;
}

}  // namespace halfway::reference::identify
