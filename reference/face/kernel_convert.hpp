// Between the kernels' plain structures and Eigen's.
#pragma once

#include "halfway/kernels/joint.hpp"
#include "reference/face/kernel_entry.hpp"

namespace halfway::reference {

template <class T, class S>
kernel::V3<T> plain(const Vec3<S>& v) {
  return {T(v[0]), T(v[1]), T(v[2])};
}
template <class T>
kernel::NodePose<T> plain(const QuaternionPose<T>& p) {
  return {plain<T>(p.x), {p.q[0], {p.q[1], p.q[2], p.q[3]}}};
}
template <class T>
kernel::KernelEnd<T> plain_end(const JointEnd<double>& e) {
  const auto q = so3::quaternion<double>(e.H);
  return {plain<T>(e.o), {T(q.w), plain<T>(q.v)}};
}

/// The upper triangle of a symmetric block.
template <class T, class M>
kernel::S3<T> plain_symmetric(const M& m) {
  return {T(m(0, 0)), T(m(0, 1)), T(m(0, 2)), T(m(1, 1)), T(m(1, 2)), T(m(2, 2))};
}
template <class T, class M>
kernel::M3<T> plain_matrix(const M& m) {
  const auto row = [&](int i) { return kernel::V3<T>{T(m(i, 0)), T(m(i, 1)), T(m(i, 2))}; };
  return {row(0), row(1), row(2)};
}

/// A linear stiffness as the kernels take it.
template <Kind kind, class T>
auto plain_law(const Eigen::MatrixXd& K) {
  if constexpr (strain_count(kind) == 3)
    return kernel::Linear3<T>{plain_symmetric<T>(K)};
  else
    return kernel::Linear6<T>{{plain_symmetric<T>(K.topLeftCorner(3, 3)),
                               plain_matrix<T>(K.topRightCorner(3, 3)),
                               plain_symmetric<T>(K.bottomRightCorner(3, 3))}};
}

template <class T>
AngularLoads<T> eigen(const kernel::MomentLoads<T>& l) {
  T out[3 + 18];
  kernel::expand<true>(l, out);
  const Eigen::Map<const Eigen::Matrix<T, 3, 6, Eigen::RowMajor>> tangent(out + 3);
  return {Eigen::Map<const Vec3<T>>(out), tangent.template leftCols<3>(), tangent.template rightCols<3>()};
}
template <class T>
NodeLoads<T> eigen(const kernel::PointLoads<T>& l) {
  T out[12 + 144];
  kernel::expand<true>(l, out);
  return {Eigen::Map<const Eigen::Matrix<T, 12, 1>>(out),
          Eigen::Map<const Eigen::Matrix<T, 12, 12, Eigen::RowMajor>>(out + 12)};
}

}  // namespace halfway::reference
