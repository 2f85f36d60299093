// One problem written in other ways: each changes nothing of the answer, or what is known beforehand.
#pragma once

#include "reference/solve/equilibrium_problem.hpp"

namespace halfway::verify {

/// A scene in another writing, and what its answers have to be turned by before they compare.
struct Written {
  reference::Scene scene;
  reference::Setting setting{};
  Mat3<double> axes = Mat3<double>::Identity();    ///< v of the scene is now axes v
  Mat3<double> node_b = Mat3<double>::Identity();  ///< v in the axes of node b is now node_b v
};

/// A writing with a rotation H.
using Rewriting = Written (*)(const reference::Scene& scene, const Mat3<double>& H);

Written as_it_is(const reference::Scene& scene, const Mat3<double>&);

/// The axes of space and of both nodes are others: frames, offsets and loads turn with H, the law stays as it
/// is in the axes of the joint.
Written in_other_axes(const reference::Scene& scene, const Mat3<double>& H);

/// Both joint frames turn by H about their own axes, and the law turns back: H^T K H. Loads stay.
Written law_in_other_axes(const reference::Scene& scene, const Mat3<double>& H);

/// The axes of node b alone are others. It then starts turned, and all counts from there.
Written node_b_in_other_axes(const reference::Scene& scene, const Mat3<double>& H);

/// The clamped node is listed as b.
Written nodes_exchanged(const reference::Scene& scene, const Mat3<double>&);

}  // namespace halfway::verify
