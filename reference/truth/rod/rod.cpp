#include "reference/truth/rod/rod.hpp"

#include "reference/record/worst.hpp"
#include "reference/truth/rod/load_steps.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace halfway::reference::rod {

Section of_stiffness(const Vec3<double>& bending, const Vec3<double>& stretching) {
  if (!(bending.array() > 0).all() || !(stretching.array() > 0).all())
    throw std::invalid_argument("rod: a stiffness of its section is not positive");
  return {bending.cwiseInverse(), stretching.cwiseInverse()};
}

Section of_stiffness(const Vec3<double>& bending) {
  return of_stiffness(bending, Vec3<double>::Constant(std::numeric_limits<double>::infinity()));
}

Loads Loads::operator*(double factor) const {
  return {factor * force, factor * moment, factor * follower_force, factor * follower_moment};
}

double apart(const Tip& one, const Tip& other, double length) {
  return larger(largest_entry<double>((one.x - other.x) / length), largest_entry<double>(one.R - other.R));
}

double turn_between(const Mat3<double>& one, const Mat3<double>& other) {
  const Mat3<double> R = one.transpose() * other;
  return std::atan2(axial(R).norm(), (R.trace() - 1) / 2);
}

}  // namespace halfway::reference::rod
