// Second-order couplings: the quadratic part of a joint's motion under load, of solids and formulations.
#pragma once

#include "reference/face/registry.hpp"

#include <array>

namespace halfway::reference {

/// Motion q = (d, theta) of node b under the load l = (f, m), node a clamped, loads of fixed direction at
/// the joint point: q_k = (C l)_k + l^T Q[k] l + third order. Q[k] is symmetric. m and rad per N and N m.
using Couplings = std::array<Eigen::Matrix<double, 6, 6>, 6>;

/// Of a formulation, from the derivative of its tangent by dual numbers at 50 digits: no truncation.
/// spec: kind linear_angular, ends at the nodes; its law gives the compliance.
Couplings couplings(const Entry& entry, const JointSpec& spec);

}  // namespace halfway::reference
