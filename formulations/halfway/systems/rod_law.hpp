// What a uniform rod adds to the law of a joint at its middle: laws that ask another law.
//
// Derived here by the Magnus series of R' = R [K^-1 R^T m], the rod under an end moment m, in the half-way
// frame (SI units, rad):
//   U = 1/2 theta . w - 1/24 (w x theta) . K^-1 (w x theta) + O(6),  w = K theta.
// K is the law's angular stiffness at no strain: exact to that order for a linear law. A series: unbounded
// below (rod_radius.hpp), and of no use where |theta| k_max/k_min > 1.
#pragma once

#include "halfway/joint/laws.hpp"
#include "halfway/joint/parameters.hpp"
#include "halfway/rotations/so3.hpp"

#include <Eigen/LU>

namespace halfway {

/// The fourth order: energy (J), its gradient (N m) and its Hessian (N m/rad) by the rotation vector (rad).
/// Not finite where K is singular.
template <class T>
class RodCorrection {
 public:
  /// @param K  symmetric, N m/rad
  explicit RodCorrection(const Mat3<T>& K) : K_(K), compliance_(K.inverse()) {}

  T energy(const Vec3<T>& theta) const {
    const Vec3<T> u = (K_ * theta).cross(theta);
    return u.dot(compliance_ * u) / T(-24);
  }
  Vec3<T> gradient(const Vec3<T>& theta) const {
    const Vec3<T> w = K_ * theta, v = compliance_ * w.cross(theta);
    return (w.cross(v) - K_ * theta.cross(v)) / T(12);
  }
  Mat3<T> hessian(const Vec3<T>& theta) const {
    const Vec3<T> w = K_ * theta, v = compliance_ * w.cross(theta);
    const Mat3<T> B = skew(w) - skew(theta) * K_;  // d(w x theta)
    const Mat3<T> turn = skew(v) * K_;
    return (B.transpose() * compliance_ * B + turn + turn.transpose()) / T(-12);
  }

 private:
  Mat3<T> K_, compliance_;
};

/// A law and that correction. Strains as the law's: 3 rotations, or 3 displacements and 3 rotations.
template <class T, int N, class L>
struct RodLaw {
  L law;

  LawResponse<T, N> operator()(const Eigen::Matrix<T, N, 1>& strain) const {
    LawResponse<T, N> r = law(strain);
    const RodCorrection<T> rod = correction();
    const Vec3<T> theta = strain.template tail<3>();
    r.stress.template tail<3>() += rod.gradient(theta);
    r.stiffness.template bottomRightCorner<3, 3>() += rod.hessian(theta);
    return r;
  }
  T energy(const Eigen::Matrix<T, N, 1>& strain) const {
    return law.energy(strain) + correction().energy(strain.template tail<3>());
  }

 private:
  RodCorrection<T> correction() const {
    const LawResponse<T, N> at_rest = law(Eigen::Matrix<T, N, 1>::Zero());
    return RodCorrection<T>(at_rest.stiffness.template bottomRightCorner<3, 3>());
  }
};

/// A law that sees a slender straight rod's strains: a bent rod's ends draw nearer, and one that is twisted
/// and bent moves them aside. With i along the rod, (i, j, k) cyclic, k_i and F_i the diagonals of the law's
/// angular and linear stiffness at no strain, d and theta the half-way displacement (m) and rotation vector
/// (rad):
///   e_i = d_i - L (theta_j^2 + theta_k^2)/12 + 3 (q_j^2 + q_k^2)/(5 L),  q_j = F_j L^2/(12 k_k) d_j (bending
///   share) e_j = d_j + (k_i - k_j + k_k) L/(12 k_k) theta_i theta_j,  e_k likewise.
/// The rod's to fourth order where the joint's axes are the section's principal axes and the law is a
/// diagonal one; a potential all the same elsewhere.
template <class T, class L>
class SlenderLaw {
 public:
  using Vec6 = Eigen::Matrix<T, 6, 1>;
  using Mat6 = Eigen::Matrix<T, 6, 6>;

  /// @param rod  its length and axis are read
  SlenderLaw(const L& law, const Parameters& rod)
      : law_(law), length_(rod.axis > 0 ? rod.length : -rod.length) {
    i_ = (rod.axis > 0 ? rod.axis : -rod.axis) - 1, j_ = (i_ + 1) % 3, k_ = (i_ + 2) % 3;
    const Vec6 K = law_(Vec6::Zero()).stiffness.diagonal();
    const T ki = K[3 + i_], kj = K[3 + j_], kk = K[3 + k_];
    aside_j_ = (ki - kj + kk) * length_ / (T(12) * kk);
    aside_k_ = (ki + kj - kk) * length_ / (T(12) * kj);
    shortening_j_ = shortening(T(K[j_] * length_ * length_ / (T(12) * kk)));
    shortening_k_ = shortening(T(K[k_] * length_ * length_ / (T(12) * kj)));
  }

  LawResponse<T, 6> operator()(const Vec6& strain) const {
    const LawResponse<T, 6> r = law_(seen(strain));
    const Mat6 J = rate(strain);
    return {J.transpose() * r.stress, J.transpose() * r.stiffness * J + curvature(r.stress)};
  }
  T energy(const Vec6& strain) const { return law_.energy(seen(strain)); }

 private:
  T shortening(const T& share) const { return T(6) * share * share / (T(5) * length_); }

  Vec6 seen(const Vec6& e) const {
    const T &ti = e[3 + i_], &tj = e[3 + j_], &tk = e[3 + k_];
    Vec6 s = e;
    s[i_] += (shortening_j_ * e[j_] * e[j_] + shortening_k_ * e[k_] * e[k_]) / T(2) -
             length_ * (tj * tj + tk * tk) / T(12);
    s[j_] += aside_j_ * ti * tj;
    s[k_] += aside_k_ * ti * tk;
    return s;
  }
  /// d(seen)/d(strain).
  Mat6 rate(const Vec6& e) const {
    Mat6 J = Mat6::Identity();
    J(i_, j_) = shortening_j_ * e[j_], J(i_, k_) = shortening_k_ * e[k_];
    J(i_, 3 + j_) = -length_ * e[3 + j_] / T(6), J(i_, 3 + k_) = -length_ * e[3 + k_] / T(6);
    J(j_, 3 + i_) = aside_j_ * e[3 + j_], J(j_, 3 + j_) = aside_j_ * e[3 + i_];
    J(k_, 3 + i_) = aside_k_ * e[3 + k_], J(k_, 3 + k_) = aside_k_ * e[3 + i_];
    return J;
  }
  /// d(J^T stress)/d(strain) for constant stress.
  Mat6 curvature(const Vec6& stress) const {
    Mat6 H = Mat6::Zero();
    H(j_, j_) = shortening_j_ * stress[i_], H(k_, k_) = shortening_k_ * stress[i_];
    H(3 + j_, 3 + j_) = H(3 + k_, 3 + k_) = -length_ * stress[i_] / T(6);
    H(3 + i_, 3 + j_) = H(3 + j_, 3 + i_) = aside_j_ * stress[j_];
    H(3 + i_, 3 + k_) = H(3 + k_, 3 + i_) = aside_k_ * stress[k_];
    return H;
  }

  L law_;
  T length_;
  int i_, j_, k_;
  T aside_j_, aside_k_, shortening_j_, shortening_k_;
};

}  // namespace halfway
