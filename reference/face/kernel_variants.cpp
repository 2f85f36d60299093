#include "reference/face/kernel_variants.hpp"

#include "halfway/systems/intrinsic.hpp"
#include "reference/face/kernel_instance.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace halfway::reference {
namespace {

/// Kernels take a stiffness.
JointSpec stiffness_of(const JointSpec& spec) {
  JointSpec out = spec;
  auto& law = std::get<LinearSpec>(out.law);
  if (!law.is_compliance) return out;
  if (law.matrix.rows() == 3)
    law.matrix = detail::inverse_stiffness<double, 3>(law.matrix);
  else
    law.matrix = detail::inverse_stiffness<double, 6>(law.matrix);
  law.is_compliance = false;
  return out;
}

template <class T, class S>
QuaternionPose<T> cast(const QuaternionPose<S>& p) {
  return {p.x.template cast<T>(), p.q.template cast<T>()};
}

QuaternionPose<double> quaternion_pose(const Pose<double>& p) {
  const auto q = so3::quaternion<double>(p.R);
  return {p.x, {q.w, q.v[0], q.v[1], q.v[2]}};
}

template <class T>
AngularLoads<double> in_double(const AngularLoads<T>& l) {
  return {l.m_b.template cast<double>(), l.m_b_wa.template cast<double>(), l.m_b_wb.template cast<double>()};
}
template <class T>
NodeLoads<double> in_double(const NodeLoads<T>& l) {
  return {l.q.template cast<double>(), l.tangent.template cast<double>()};
}

template <class T, class Accuracy>
AngularLoads<double> variant_loads(const JointSpec& spec, const QuaternionPose<double>& a,
                                   const QuaternionPose<double>& b, bool with_tangent) {
  return in_double(kernel_angular<Invariant, T, Accuracy>(spec, cast<T>(a), cast<T>(b), with_tangent));
}

template <class T, class Accuracy>
AngularLoads<double> variant_from_matrices(const JointSpec& spec, const Pose<double>& a,
                                           const Pose<double>& b, bool with_tangent) {
  return variant_loads<T, Accuracy>(stiffness_of(spec), quaternion_pose(a), quaternion_pose(b), with_tangent);
}

template <class T, class Angle = kernel::ExactAngle>
KernelVariant variant(std::string_view name) {
  using Accuracy = kernel::Accuracy<Angle>;
  return {name, std::is_same_v<T, float> ? "float" : "double", &variant_loads<T, Accuracy>,
          &variant_from_matrices<T, Accuracy>};
}

constexpr std::size_t kFormulations = 0
#define HALFWAY_FORMULATION(...) +1
#include "halfway/catalog.def"
#undef HALFWAY_FORMULATION
    ;

/// The catalog's entry number `at` by its kernel. A pointer to a function carries no entry with it:
/// hence one pair of functions an entry.
template <std::size_t at, class T>
struct ByKernel {
  static const KernelEvaluators<T>& kernel() {
    const KernelEntry& all = formulations()[at].kernel;
    if constexpr (std::is_same_v<T, float>)
      return all.in_float;
    else
      return all.in_double;
  }
  static AngularLoads<double> angular(const JointSpec& spec, const Pose<double>& a, const Pose<double>& b,
                                      bool with_tangent) {
    return in_double(kernel().angular(stiffness_of(spec), cast<T>(quaternion_pose(a)),
                                      cast<T>(quaternion_pose(b)), with_tangent));
  }
  static NodeLoads<double> point(const JointSpec& spec, const Pose<double>& a, const Pose<double>& b,
                                 bool with_tangent) {
    return in_double(kernel().point(stiffness_of(spec), cast<T>(quaternion_pose(a)),
                                    cast<T>(quaternion_pose(b)), with_tangent));
  }
};

struct Functions {
  decltype(Evaluators<double>::angular) angular;
  decltype(Evaluators<double>::point) point;
};

template <class T, std::size_t... at>
std::array<Functions, sizeof...(at)> table(std::index_sequence<at...>) {
  return {Functions{&ByKernel<at, T>::angular, &ByKernel<at, T>::point}...};
}

}  // namespace

std::span<const KernelVariant> invariant_variants() {
  using kernel::PolynomialAngle, kernel::SmallAngle;
  static const KernelVariant all[] = {variant<double>(""),
                                      variant<double, SmallAngle<1>>("order_1"),
                                      variant<double, SmallAngle<2>>("order_2"),
                                      variant<double, SmallAngle<3>>("order_3"),
                                      variant<double, PolynomialAngle<4>>("log_4"),
                                      variant<double, PolynomialAngle<8>>("log_8"),
                                      variant<double, PolynomialAngle<12>>("log_12"),
                                      variant<double, PolynomialAngle<18>>("log_18"),
                                      variant<float>("")};
  return all;
}

Entry with_variant(const Entry& invariant, const KernelVariant& variant) {
  Entry out = invariant;
  out.in_double.angular = variant.from_matrices;
  return out;
}

Entry with_kernel(const Entry& entry, bool single) {
  const auto catalog = formulations();
  const Entry* registered = find_formulation(entry.name);
  if (registered == nullptr || registered->kernel.in_double.angular == nullptr)
    throw std::invalid_argument(std::string(entry.name) + " has no kernel");
  const auto at = std::size_t(registered - catalog.data());
  constexpr auto indices = std::make_index_sequence<kFormulations>();
  const Functions by = single ? table<float>(indices)[at] : table<double>(indices)[at];
  Entry out = entry;
  out.in_double.angular = by.angular;
  out.in_double.point = by.point;
  return out;
}

}  // namespace halfway::reference
