#include "reference/truth/rod/stability.hpp"

#include "reference/numbers/linear_algebra.hpp"

namespace halfway::reference::rod {
namespace {

const Mat3<double> kIdentity = Mat3<double>::Identity();

End nothing() { return {Eigen::Matrix<double, 12, 6>::Zero(), Eigen::Matrix<double, 6, 12>::Zero()}; }

void hold_place(End& end) {
  end.admitted.block<3, 3>(kForce, 0) = kIdentity;
  end.demanded.block<3, 3>(0, kX) = kIdentity;
}

void release_place(End& end, const Mat3<double>& force_by_spin) {
  end.admitted.block<3, 3>(kX, 0) = kIdentity;
  end.admitted.block<3, 3>(kForce, 3) = force_by_spin;
  end.demanded.block<3, 3>(0, kForce) = kIdentity;
  end.demanded.block<3, 3>(0, kSpin) = -force_by_spin;
}

void release_orientation(End& end, const Mat3<double>& moment_by_spin) {
  end.admitted.block<3, 3>(kSpin, 3) = kIdentity;
  end.admitted.block<3, 3>(kMoment, 3) = moment_by_spin;
  end.demanded.block<3, 3>(3, kMoment) = kIdentity;
  end.demanded.block<3, 3>(3, kSpin) = -moment_by_spin;
}

}  // namespace

Mat3<double> of_fixed_moment() { return Mat3<double>::Zero(); }
Mat3<double> of_follower_moment(const Vec3<double>& m) { return -skew(m); }
Mat3<double> of_semi_tangential_moment(const Vec3<double>& m) { return -skew(m) / 2; }
Mat3<double> of_quasi_tangential_moment(double M, const Vec3<double>& p, const Vec3<double>& q) {
  return M * p * q.transpose();
}

End clamped() {
  End out = nothing();
  hold_place(out);
  out.admitted.block<3, 3>(kMoment, 3) = kIdentity;
  out.demanded.block<3, 3>(3, kSpin) = kIdentity;
  return out;
}

End hinged(const Mat3<double>& moment_by_spin) {
  End out = nothing();
  hold_place(out);
  release_orientation(out, moment_by_spin);
  return out;
}

End free_end(const Mat3<double>& moment_by_spin, const Mat3<double>& force_by_spin) {
  End out = nothing();
  release_place(out, force_by_spin);
  release_orientation(out, moment_by_spin);
  return out;
}

End fork(const State& at) {
  End out = nothing();
  hold_place(out);
  const Mat3<double> along = at.R.transpose(), follower = of_follower_moment(at.m);
  out.admitted.block<3, 1>(kMoment, 3) = at.R.col(0);
  out.admitted.block<3, 2>(kSpin, 4) = at.R.rightCols<2>();
  out.admitted.block<3, 2>(kMoment, 4) = follower * at.R.rightCols<2>();
  out.demanded.block<1, 3>(3, kSpin) = along.row(0);
  out.demanded.block<2, 3>(4, kMoment) = along.bottomRows<2>();
  out.demanded.block<2, 3>(4, kSpin) = -along.bottomRows<2>() * follower;
  return out;
}

double determinant(const End& start, const Changes& transfer, const End& end, std::span<const int> kept) {
  const Eigen::Matrix<double, 6, 6> all = end.demanded * (transfer * start.admitted);
  const auto size = long(kept.size());
  SmallMatrix<double> some(size, size);
  for (long i = 0; i < size; ++i)
    for (long j = 0; j < size; ++j) some(i, j) = all(kept[std::size_t(i)], kept[std::size_t(j)]);
  return lu_determinant<double>(some);
}

Arrival carried(const Rod& rod, const Vec3<double>& n, const Vec3<double>& m, int finer, double inertia) {
  const State start{.m = m};
  const int steps = finer * enough_steps(rod, start, n);
  return flow(rod, start, n, Changes::Identity(12, 12), steps, inertia);
}

}  // namespace halfway::reference::rod
