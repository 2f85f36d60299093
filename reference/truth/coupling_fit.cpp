#include "reference/truth/coupling_fit.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace halfway::reference {
namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Square root of C's two diagonal blocks.
Mat6 scale(const Mat6& C) {
  Mat6 S = Mat6::Zero();
  for (int block : {0, 3}) {
    const Eigen::SelfAdjointEigenSolver<Mat3<double>> eigen(Mat3<double>(C.block<3, 3>(block, block)));
    S.block<3, 3>(block, block) = eigen.operatorSqrt();
  }
  return S;
}

bool belongs(CouplingGroup group, int k, int i, int j) {
  if (group == CouplingGroup::all) return true;
  const bool moments = group == CouplingGroup::moments;
  return k >= 3 && (i >= 3) == moments && (j >= 3) == moments;
}

/// The group's entries in scaled loads l = S^-1 l' and motions q = S q', as one vector.
Eigen::VectorXd scaled(const Couplings& Q, const Mat6& S, CouplingGroup group) {
  const Mat6 S_inverse = S.inverse();
  std::vector<double> out;
  for (int k = 0; k < 6; ++k) {
    Mat6 row = Mat6::Zero();
    for (int l = 0; l < 6; ++l) row += S_inverse(k, l) * Q[std::size_t(l)];
    row = (S_inverse.transpose() * row * S_inverse).eval();
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        if (belongs(group, k, i, j)) out.push_back(row(i, j));
      }
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(out.data(), Eigen::Index(out.size()));
}

Couplings intrinsic_couplings(const Mat6& C, double xi) {
  JointSpec spec;
  spec.kind = Kind::linear_angular;
  spec.law = LinearSpec{C, true};
  spec.xi = xi;
  return couplings(*find_formulation("intrinsic"), spec);
}

}  // namespace

const char* to_string(CouplingGroup group) {
  switch (group) {
    case CouplingGroup::moments:
      return "moments";
    case CouplingGroup::forces:
      return "forces";
    default:
      return "all";
  }
}

double coupling_error(const Couplings& joint, const Couplings& truth, const Mat6& C, CouplingGroup group) {
  const Mat6 S = scale(C);
  const Eigen::VectorXd expected = scaled(truth, S, group);
  return (scaled(joint, S, group) - expected).norm() / expected.norm();
}

BestXi best_xi(const Couplings& truth, const Mat6& C, CouplingGroup group) {
  const Mat6 S = scale(C);
  const Eigen::VectorXd at_zero = scaled(intrinsic_couplings(C, 0), S, group);
  const Eigen::VectorXd slope = scaled(intrinsic_couplings(C, 1), S, group) - at_zero;
  const Eigen::VectorXd expected = scaled(truth, S, group);
  const double xi = slope.dot(expected - at_zero) / slope.squaredNorm();
  return {xi, (at_zero + xi * slope - expected).norm() / expected.norm()};
}

}  // namespace halfway::reference
