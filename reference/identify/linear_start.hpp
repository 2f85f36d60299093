// Where the fit begins: the symmetric compliance that the small-motion law z = F l would have.
#pragma once

#include "reference/identify/model.hpp"

namespace halfway::reference::identify {

/// Principal stiffnesses and axes, joint point and coupling of a linear least squares fit. Directions that no
/// row loads get the mean compliance of those that are.
struct LinearStart {
  Frame frame;
  Unknowns unknowns;
};
LinearStart linear_start(const Data& data);

/// The same without what would turn the axes, move the joint point or couple.
LinearStart linear_start_along_axes(const Data& data);

/// Columns: eigenvectors of a symmetric matrix in the order and with the signs that are nearest to the
/// identity, so that axis 1 is the one next to x; `values` in the same order.
struct PrincipalAxes {
  Vec3<double> values;
  Mat3<double> axes;
};
PrincipalAxes principal_axes(const Mat3<double>& symmetric);

}  // namespace halfway::reference::identify
