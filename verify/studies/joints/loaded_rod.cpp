#include "verify/studies/joints/loaded_rod.hpp"

#include <Eigen/LU>

namespace halfway::verify {
namespace {

constexpr int kSteps = 400;  ///< of the classical method of order four: 1e-12 of a turn of one radian

/// y over one step of the rate f; Y: sums and multiples.
template <class Y, class Rate>
Y stepped(const Y& y, double h, const Rate& rate) {
  const Y a = rate(y), b = rate(Y(y + h / 2 * a)), c = rate(Y(y + h / 2 * b)), d = rate(Y(y + h * c));
  return y + h / 6 * (a + 2 * b + 2 * c + d);
}

/// R beside x.
using Section = Eigen::Matrix<double, 3, 4>;

}  // namespace

Eigen::VectorXd middle_stiffness(const UniformRod& rod) {
  const double L = rod.length;
  const auto transverse = [&](double EI) { return 1 / (L * L * L / (12 * EI) + L / rod.shear); };
  Eigen::VectorXd K(6);
  K << rod.axial / L, transverse(rod.bending[2]), transverse(rod.bending[1]), rod.bending / L;
  return K;
}

BentRod bent_rod(const UniformRod& rod, const Vec3<double>& force, const Vec3<double>& moment) {
  const auto rate = [&](const Section& s) {
    const Mat3<double> R = s.leftCols<3>();
    const Vec3<double> inner = moment - s.col(3).cross(force);  // of the part beyond, about the section
    const Vec3<double> n = R.transpose() * force;
    Section out;
    out.leftCols<3>() = R * skew<double>((R.transpose() * inner).cwiseQuotient(rod.bending));
    out.col(3) = R * Vec3<double>(1 + n[0] / rod.axial, n[1] / rod.shear, n[2] / rod.shear);
    return out;
  };
  Section s = Section::Identity();
  for (int i = 0; i < kSteps; ++i) s = stepped(s, -rod.length / kSteps, rate);
  const Mat3<double> from_tip = s.leftCols<3>().transpose();
  return {{-(from_tip * s.col(3)), from_tip}, from_tip * force, from_tip * moment};
}

Mat3<double> turned_by_moment(const Mat3<double>& K, const Vec3<double>& moment) {
  const Mat3<double> compliance = K.inverse();
  const auto rate = [&](const Mat3<double>& R) -> Mat3<double> {
    return R * skew<double>(compliance * (R.transpose() * moment));
  };
  Mat3<double> R = Mat3<double>::Identity();
  for (int i = 0; i < kSteps; ++i) R = stepped(R, 1. / kSteps, rate);
  return R;
}

}  // namespace halfway::verify
