#include "reference/face/kernel_variants.hpp"

#include "halfway/systems/intrinsic.hpp"
#include "reference/face/kernel_instance.hpp"

#include <stdexcept>
#include <string>

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

/// A formulation's loads in double by its kernel in T.
template <class T>
void take_loads(Evaluators<double>& out, const KernelEvaluators<T>& kernel) {
  out.angular = [by = kernel.angular](const JointSpec& spec, const Pose<double>& a, const Pose<double>& b,
                                      bool with_tangent) {
    return in_double(
        by(stiffness_of(spec), cast<T>(quaternion_pose(a)), cast<T>(quaternion_pose(b)), with_tangent));
  };
  out.point = [by = kernel.point](const JointSpec& spec, const Pose<double>& a, const Pose<double>& b,
                                  bool with_tangent) {
    return in_double(
        by(stiffness_of(spec), cast<T>(quaternion_pose(a)), cast<T>(quaternion_pose(b)), with_tangent));
  };
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
  if (entry.kernel.in_double.angular == nullptr)
    throw std::invalid_argument(std::string(entry.name) + " has no kernel");
  Entry out = entry;
  if (single)
    take_loads(out.in_double, entry.kernel.in_float);
  else
    take_loads(out.in_double, entry.kernel.in_double);
  return out;
}

}  // namespace halfway::reference
