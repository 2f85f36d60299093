// Joints that see a slender rod's strains (rod34) move by linear increments of these, and not of d.
//
// A bent joint's ends draw nearer by h theta^2/12. Where the rod hardly stretches, an increment that is
// linear in d leaves what is of second order in the rotation to the axial stiffness: a force that throws the
// next iteration far off.
#pragma once

#include "halfway/kernels/measures.hpp"
#include "halfway/kernels/response.hpp"
#include "halfway/kernels/slender.hpp"
#include "reference/chain/loops/sweep.hpp"

namespace halfway::reference::chain::detail {

/// In the half-way frame, from the root on: listed the other way round both d and the rod change sign.
template <class P>
class RodStrains {
  using V = kernel::V3<P>;

 public:
  HALFWAY_INLINE explicit RodStrains(const Rod& rod) : shape_(rod.length, diagonal(rod.stiffness)) {}

  /// The displacements that the law sees, after increments.
  /// @param d  m    @param dd, spin  increments of d and of the rotation (rad), half-way axes
  HALFWAY_INLINE V moved(const kernel::Relative<P>& r, const V& d, const V& dd, const V& spin) const {
    const auto e = kernel::MeasureKernel<RotationVectorMeasure>::measured<1>(r, angle<1>(r));
    const V theta = e.eta * r.v, turn = e.beta * spin + (e.gamma * dot(r.v, spin)) * r.v;
    return seen(d, theta) + shape_.by_d(d) * dd + shape_.by_theta(theta) * turn;
  }

  /// d, of what the law sees. @param e  m
  HALFWAY_INLINE V displacement(const kernel::Relative<P>& r, const V& e) const {
    const V theta = angle<0>(r).h * r.v, aside = e - seen(kernel::zero3<P>(), theta);
    const V across{P(0.), aside.y, aside.z};
    return across + V{e.x - seen(across, theta).x, P(0.), P(0.)};
  }

 private:
  HALFWAY_INLINE V seen(const V& d, const V& theta) const { return shape_.seen(kernel::Pair<P>{d, theta}).f; }
  template <int order>
  static HALFWAY_INLINE kernel::AngleJet<P> angle(const kernel::Relative<P>& r) {
    return kernel::jet_at<kernel::ExactAngle, order>(r);
  }
  static HALFWAY_INLINE kernel::Stiffness6<P> diagonal(const double (&k)[6]) {
    const P zero(0.);
    return {{P(k[0]), zero, zero, P(k[1]), zero, P(k[2])},
            kernel::zero33<P>(),
            {P(k[3]), zero, zero, P(k[4]), zero, P(k[5])}};
  }

  kernel::SlenderShape<P> shape_;
};

}  // namespace halfway::reference::chain::detail
