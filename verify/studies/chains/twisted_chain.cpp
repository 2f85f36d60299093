#include "verify/studies/chains/twisted_chain.hpp"

#include <Eigen/LU>

namespace halfway::verify {
namespace {

using reference::Entry;
using reference::Real50;

template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// Adds joint j, between nodes j and j + 1, to the rows of its nodes; node 0 has none.
template <class T>
void add_joint(const AngularLoads<T>& loads, int j, Matrix<T>& out) {
  out.template block<3, 3>(3 * j, 3 * j) += loads.m_b_wb;
  if (j == 0) return;
  out.template block<3, 3>(3 * j, 3 * j - 3) += loads.m_b_wa;
  out.template block<3, 3>(3 * j - 3, 3 * j - 3) -= loads.m_b_wa;
  out.template block<3, 3>(3 * j - 3, 3 * j) -= loads.m_b_wb;
}

template <class T>
T determinant_of(const Entry& entry, const Vec3<double>& K, int links, const T& angle, EndMoment end,
                 T& moment) {
  reference::JointSpec spec;
  spec.xi = entry.probe_xi;
  spec.law = reference::LinearSpec{Eigen::MatrixXd((links * K).asDiagonal())};
  const auto node = [&](int i) {
    return Pose<T>{Vec3<T>::Zero(), so3::exp<T>(T(i) * angle * Vec3<T>::UnitX())};
  };
  Matrix<T> tangent = Matrix<T>::Zero(3 * links, 3 * links);
  for (int j = 0; j < links; ++j) {
    const AngularLoads<T> loads = entry.in<T>().angular(spec, node(j), node(j + 1), true);
    add_joint(loads, j, tangent);
    moment = loads.m_b[0];
  }
  if (end == EndMoment::semi_tangential)  // less half of w x m
    tangent.template bottomRightCorner<3, 3>() += skew<T>(moment / T(2) * Vec3<T>::UnitX());
  for (int i = 0; i < 3 * links; ++i) tangent.row(i) /= T(links * K[i % 3]);
  return tangent.partialPivLu().determinant();
}

}  // namespace

template <class T>
Twisted<T> twisted(const Entry& entry, const Vec3<double>& K, int links, const T& angle, EndMoment end) {
  Twisted<T> out;
  // At rest it is one: each joint's own stiffness, over itself.
  out.determinant = determinant_of(entry, K, links, angle, end, out.moment);
  return out;
}

template Twisted<double> twisted(const Entry&, const Vec3<double>&, int, const double&, EndMoment);
template Twisted<Real50> twisted(const Entry&, const Vec3<double>&, int, const Real50&, EndMoment);

}  // namespace halfway::verify
