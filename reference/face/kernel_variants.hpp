// The kernels as formulations of the registry, so that a scene is solved with what the benchmarks time.
#pragma once

#include "reference/face/registry.hpp"

#include <span>
#include <string_view>

namespace halfway::reference {

/// The invariant angular kernel with a cheaper angle or in another precision, by its benchmark's names.
struct KernelVariant {
  std::string_view name;       ///< order_1 ... order_3, log_4 ... log_18; empty: as exact as the precision
  std::string_view precision;  ///< double, float
  /// Loads as the kernel returns them. The law must be a linear stiffness.
  AngularLoads<double> (*angular)(const JointSpec&, const QuaternionPose<double>& a,
                                  const QuaternionPose<double>& b, bool with_tangent);
  /// The same behind the face of the registry: rotation matrices, and a compliance as well.
  AngularLoads<double> (*from_matrices)(const JointSpec&, const Pose<double>& a, const Pose<double>& b,
                                        bool with_tangent);
};

/// The plain kernel first, then from the crudest on.
std::span<const KernelVariant> invariant_variants();

/// The invariant's entry with its angular loads in double by a variant; all else is unchanged.
Entry with_variant(const Entry& invariant, const KernelVariant& variant);

/// A formulation's entry with its loads in double by its own kernel, in float when `single`. The law of
/// a joint must be linear; the entry must have a kernel.
Entry with_kernel(const Entry& entry, bool single);

}  // namespace halfway::reference
