#include "reference/scene/joint/convexity.hpp"

#include <fmt/format.h>

#include <limits>

namespace halfway::reference {
namespace {

template <int N>
Eigen::MatrixXd stiffness_at_rest(const LawSpec& law) {
  return AnyLaw<double, N>(law)(Eigen::Matrix<double, N, 1>::Zero()).stiffness;
}

}  // namespace

double convex_radius(const Entry& entry, const JointSpec& spec) {
  if (entry.convex_radius == nullptr || spec.kind == Kind::linear)
    return std::numeric_limits<double>::infinity();
  return entry.convex_radius(spec.kind == Kind::angular ? stiffness_at_rest<3>(spec.law)
                                                        : stiffness_at_rest<6>(spec.law));
}

std::string beyond_convexity(double phi, double radius) {
  return fmt::format(
      "rotation of {:.3g} rad is beyond {:.3g} rad, within which its energy is convex for this stiffness",
      phi, radius);
}

std::string beyond_convexity(const Entry& entry, double phi, double radius) {
  return fmt::format("{}: {}", entry.name, beyond_convexity(phi, radius));
}

}  // namespace halfway::reference
